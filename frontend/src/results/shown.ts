/** Which finite-element result is laid over the instant answer. */
import { useQuery } from "@tanstack/react-query";

import { useJobResult, useJobs, version } from "../api/queries";
import { Store, usePick, useStore } from "../api/store";
import type { Job, Result } from "../api/types";
import { readDesign, readScene, sameDesign, type Work } from "../workbench/document";
import { bench } from "../workbench/workbench";

/** A job's id, or the newest finished one of the open version, or none. */
export type Choice = { readonly kind: "newest" } | { readonly kind: "none" } | { readonly kind: "job"; readonly id: string };

export const shownJob = new Store<Choice>({ kind: "newest" });

export interface ShownFe {
  job: Job;
  result: Result;
  /** Whether it answers what is on the bench (gravity and all parameters alike). */
  matches: boolean;
}

export function hasResult(job: Job): boolean {
  return job.state === "done";
}

function newestDone(jobs: readonly Job[], versionId: string | null): Job | null {
  const done = jobs.filter((job) => hasResult(job) && job.version_id === versionId);
  return done.reduce<Job | null>(
    (best, job) => (best && best.created_at >= job.created_at ? best : job),
    null,
  );
}

/** Jobs of the open version, from its own record and from the live list. */
function useCandidates(): { jobs: Job[]; versionId: string | null } {
  const versionId = usePick(bench, (timeline) => {
    const origin = timeline?.present.origin;
    return origin?.kind === "version" ? origin.versionId : null;
  });
  const { data: live = [] } = useJobs();
  const { data: detail } = useQuery({ ...version(versionId ?? ""), enabled: versionId !== null });
  const known = new Map<string, Job>();
  for (const job of detail?.jobs ?? []) known.set(job.id, job);
  for (const job of live) known.set(job.id, job);
  return { jobs: [...known.values()], versionId };
}

export function useShownJob(): Job | null {
  const choice = useStore(shownJob);
  const { jobs, versionId } = useCandidates();
  if (choice.kind === "none") return null;
  if (choice.kind === "newest") return newestDone(jobs, versionId);
  return jobs.find((job) => job.id === choice.id && hasResult(job)) ?? null;
}

function answersSame(result: Result, work: Work): boolean {
  const { gravity } = readScene(result.scene);
  return gravity === work.gravity && sameDesign(readDesign(result.design), work.design);
}

export function useShownFe(): ShownFe | null {
  const job = useShownJob();
  const { data: result } = useJobResult(job?.id ?? null);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  if (!job || !result || !work) return null;
  return { job, result, matches: answersSame(result, work) };
}
