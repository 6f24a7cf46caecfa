/** What the 3D view shows: the instant answer or a finite-element result. */
import { usePick, useStore } from "../api/store";
import { useDrawn } from "../results/drawn";
import { useShownFe, type ShownFe } from "../results/shown";
import { answers } from "../workbench/answers";
import { sameQuestion, type Work } from "../workbench/document";
import { modelChoice, movingRung, type InstantRung } from "../workbench/model";
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

export interface InstantShape {
  work: Work;
  rung: InstantRung;
  /** Whether it answers what is on the bench; else a newer answer is on its way, or there is none. */
  fits: boolean;
}

/** The instant answer to show: the one in the plots, else the last that there was, as a design that
 * is refused has no body. */
export function useInstantShape(): InstantShape | null {
  const last = usePick(answers, (now) => now.answered);
  const present = usePick(bench, (timeline) => timeline?.present.work ?? null);
  const moving = movingRung(useStore(modelChoice));
  const drawn = useDrawn();
  const fits = (work: Work) => present !== null && sameQuestion(work, present);
  if (drawn?.result.rung === "cell-rod") return { work: drawn.answered, rung: "cell-rod", fits: fits(drawn.answered) };
  return last && { work: last, rung: moving, fits: fits(last) };
}
