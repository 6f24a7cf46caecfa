import { useEffect } from "react";

import { usePick, useStore } from "../api/store";
import { useShownFe } from "../results/shown";
import { useTheme } from "../theme/theme";
import { sceneOf } from "../workbench/loads";
import { frameIndex, scrubber } from "../workbench/scrubber";
import { colourFor, viewerSettings } from "./settings";
import { useInstantShape, useSource } from "./source";
import { openView, setDark, showContent, showFrame, view } from "./view";

/** Keeps the room in step with the bench, the settings, the scrubber and the theme. */
export function useViewFeed(): void {
  const settings = useStore(viewerSettings);
  const { undeformed } = settings;
  const shape = useInstantShape();
  const work = shape?.work ?? null;
  const rung = shape?.rung ?? "energy";
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
    if (jobId !== null) {
      showContent({ source: { kind: "job", job_id: jobId }, colour, undeformed, frame: null });
    } else if (work) {
      // The very question that the cell and rod was asked, which is answered already.
      const scene = rung === "cell-rod" ? sceneOf(work.loads, "auto") : sceneOf(work.loads);
      const source = { kind: "instant" as const, design: work.design, scene, rung };
      showContent({ source, colour, undeformed, frame: null }, view.get().content ? "at rest" : "now");
    }
  }, [work, rung, jobId, colour, undeformed]);

  useEffect(() => {
    showFrame(index);
  }, [index]);
}
