/** Says when a job has ended, and offers to look at it. */
import { onJobEnd } from "../api/live";
import type { Job } from "../api/types";
import { shownJob } from "../results/shown";
import { failureInWords, failureTitle, outcomeInWords } from "../results/words";
import { dropDrafts } from "../ui/drafts";
import { showToast } from "../ui/toasts";
import { setViewer, viewerSettings } from "../viewer/settings";
import { openVersion } from "../workbench/opening";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";

function isHere(job: Job): boolean {
  const origin = bench.get()?.present.origin;
  return origin?.kind === "version" && origin.versionId === job.version_id;
}

/** Whether the 3D view turns to this job's answer by itself: nothing is left to offer then. */
function isShown(job: Job): boolean {
  if (!isHere(job) || viewerSettings.get().source === "instant") return false;
  const choice = shownJob.get();
  return choice.kind === "newest" || (choice.kind === "job" && choice.id === job.id);
}

function look(job: Job): void {
  if (!isHere(job)) {
    openVersion(job.version_id);
    return;
  }
  dropDrafts();
  shownJob.set({ kind: "job", id: job.id });
  setViewer({ source: "fe" });
}

function announce(job: Job): void {
  if (job.state === "cancelled") return;
  if (job.state === "failed") {
    const snapshot = bench.get()?.present;
    if (isHere(job) && snapshot && !isChanged(snapshot)) return; // said over the 3D view
    showToast({ tone: "bad", text: `3D FE of ${job.design_name}: ${failureTitle(job)}. ${failureInWords(job)}` });
    return;
  }
  const early = job.outcome !== null && job.outcome !== "converged";
  showToast({
    tone: early ? "info" : "good",
    text: `3D FE of ${job.design_name} is done. ${early ? outcomeInWords(job.outcome ?? "") : ""}`,
    ...(isShown(job) ? {} : { action: { label: isHere(job) ? "Show in 3D" : "Open", run: () => look(job) } }),
  });
}

export function announceJobs(): void {
  onJobEnd.add(announce);
}
