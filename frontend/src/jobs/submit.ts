/** Sending what is on the bench to the queue. */
import { api, messageOf, take } from "../api/client";
import { withJob } from "../api/live";
import { keys, queryClient } from "../api/queries";
import type { Job } from "../api/types";
import { shownJob } from "../results/shown";
import { showToast } from "../ui/toasts";
import { setViewer } from "../viewer/settings";
import { ensureSaved } from "../workbench/opening";

export interface FeQuestion {
  /** A fraction. */
  accuracy: number;
  /** The one mesh to solve on; null: the accuracy decides. */
  mesh: string | null;
}

/** Keeps the bench as a version first; its answer is shown when it is there. Never rejects. */
export async function runFe({ accuracy, mesh }: FeQuestion): Promise<void> {
  setViewer({ source: "newest" });
  try {
    const versionId = await ensureSaved("Kept for a finite-element job");
    const body = { version_id: versionId, rung: "fe" as const, accuracy, mesh, scene: null };
    const job = await take(api.POST("/api/jobs", { body }));
    queryClient.setQueryData<Job[]>(keys.jobs, (jobs) => withJob(jobs, job));
    shownJob.set({ kind: "newest" });
    if (job.from_store) showToast({ tone: "good", text: "This question was answered before; the stored result is shown." });
    for (const listener of onJobSent) listener();
  } catch (error) {
    showToast({ tone: "bad", text: messageOf(error) });
  }
}

/** Called after every job sent from this tab. */
export const onJobSent = new Set<() => void>();
