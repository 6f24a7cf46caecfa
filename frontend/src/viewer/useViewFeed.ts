import { useEffect, useRef } from "react";

import { usePick, useStore } from "../api/store";
import type { ContentRequest } from "../api/types";
import { useShownFe } from "../results/shown";
import { useTheme } from "../theme/theme";
import { sceneOf } from "../workbench/loads";
import { frameIndex, scrubber } from "../workbench/scrubber";
import { colourFor, viewerSettings } from "./settings";
import { useInstantShape, useSource, type InstantShape } from "./source";
import { openView, setDark, showContent, showFrame, view } from "./view";

type Shape = Pick<InstantShape, "work" | "rung">;

function instantSource(shape: Shape | null): ContentRequest["source"] | null {
  if (shape === null) return null;
  const { work, rung } = shape;
  // The very question that the cell and rod was asked, which is answered already.
  const scene = rung === "cell-rod" ? sceneOf(work.loads, "auto") : sceneOf(work.loads);
  return { kind: "instant", design: work.design, scene, rung };
}

/** Keeps the room in step with the bench, the settings, the scrubber and the theme. */
export function useViewFeed(): void {
  const settings = useStore(viewerSettings);
  const { undeformed } = settings;
  const shape = useInstantShape();
  const { work = null, rung = "energy", fits = false } = shape ?? {};
  // An answer to an earlier question is not put into view in place of what is there.
  const held = useRef<Shape | null>(null);
  const asked = useRef<string | null>(null);
  const feJobId = useShownFe()?.job.id ?? null;
  const source = useSource();
  const jobId = source === "fe" ? feJobId : null;
  const colour = colourFor(settings.colour, source);
  const index = usePick(scrubber, frameIndex);
  const { theme } = useTheme();
  const viewId = usePick(view, (state) => state.viewId);

  useEffect(() => {
    setDark(theme === "dark");
  }, [theme, viewId]);

  useEffect(() => {
    void openView();
  }, []);

  useEffect(() => {
    if (work && (fits || held.current === null)) held.current = { work, rung };
    const next = jobId === null ? instantSource(held.current) : { kind: "job" as const, job_id: jobId };
    if (next === null) return;
    const content: ContentRequest = { source: next, colour, undeformed, frame: null };
    const text = JSON.stringify(content);
    if (text === asked.current) return;
    asked.current = text;
    showContent(content, jobId === null && view.get().content ? "at rest" : "now");
  }, [work, rung, fits, jobId, colour, undeformed]);

  useEffect(() => {
    showFrame(index);
  }, [index]);
}
