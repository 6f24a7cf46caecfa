import { useEffect } from "react";

import { usePick, useStore } from "../api/store";
import { useShownFe } from "../results/shown";
import { useTheme } from "../theme/theme";
import { answers } from "../workbench/answers";
import { sceneOf } from "../workbench/loads";
import { frameIndex, scrubber } from "../workbench/scrubber";
import { colourFor, viewerSettings } from "./settings";
import { useSource } from "./source";
import { openView, setDark, showContent, showFrame, view } from "./view";

/** Keeps the room in step with the bench, the settings, the scrubber and the theme. */
export function useViewFeed(): void {
  const settings = useStore(viewerSettings);
  const { undeformed } = settings;
  // The last design that was answered: one that is refused has no body to show.
  const answered = usePick(answers, (now) => now.answered);
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
    } else if (answered) {
      const source = { kind: "instant" as const, design: answered.design, scene: sceneOf(answered.loads) };
      showContent({ source, colour, undeformed, frame: null }, view.get().content ? "at rest" : "now");
    }
  }, [answered, jobId, colour, undeformed]);

  useEffect(() => {
    showFrame(index);
  }, [index]);
}
