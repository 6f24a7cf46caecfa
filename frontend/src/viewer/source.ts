/** What the 3D view shows: the instant answer or a finite-element result. */
import { usePick, useStore } from "../api/store";
import { useShownFe, type ShownFe } from "../results/shown";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";
import { viewerSettings, type ViewerSettings } from "./settings";

/** Finite elements only where there is a result; unless asked for, only while it answers the bench. */
export function sourceOf(
  chosen: ViewerSettings["source"],
  fe: Pick<ShownFe, "matches"> | null,
  changed: boolean,
): "instant" | "fe" {
  if (fe === null || chosen === "instant") return "instant";
  return chosen === "fe" || (fe.matches && !changed) ? "fe" : "instant";
}

export function useSource(): "instant" | "fe" {
  const chosen = useStore(viewerSettings).source;
  const changed = usePick(bench, (timeline) => timeline !== null && isChanged(timeline.present));
  return sourceOf(chosen, useShownFe(), changed);
}
