import { useEffect, useState } from "react";

import { messageOf } from "../api/client";
import { reconnections } from "../api/live";
import { usePick, useStore } from "../api/store";
import { shownJob } from "../results/shown";
import { setViewer } from "../viewer/settings";
import { showToast } from "../ui/toasts";
import { openAddress } from "../workbench/opening";
import { bench, discardChanges } from "../workbench/workbench";
import { address } from "./address";

/** Lays on the bench what the address names, at the start and whenever the address changes. */
export function useOpenAddress(): { problem: string | null; retry: () => void } {
  const versionId = usePick(address, (now) => now.versionId);
  const returned = useStore(reconnections);
  const [problem, setProblem] = useState<string | null>(null);
  const [attempt, setAttempt] = useState(0);

  useEffect(() => {
    const origin = bench.get()?.present.origin;
    const openId = origin?.kind === "version" ? origin.versionId : null;
    // A version just saved, or a preset just chosen, lies on the bench already.
    if (origin && openId === versionId) return;
    let current = true;
    shownJob.set({ kind: "newest" });
    setViewer({ source: "instant" });
    openAddress({ versionId, compare: null }).then(
      (restored) => {
        if (!current) return;
        setProblem(null);
        if (restored && versionId !== null) {
          showToast({
            tone: "info",
            text: "Unsaved changes of your last visit are back.",
            action: { label: "Discard", run: discardChanges },
          });
        }
      },
      (error: unknown) => {
        if (current) setProblem(messageOf(error));
      },
    );
    return () => {
      current = false;
    };
  }, [versionId, returned, attempt]);

  return { problem, retry: () => setAttempt((count) => count + 1) };
}
