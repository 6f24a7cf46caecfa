/** Which finite-element result is laid over the instant answer. */
import { useQuery } from "@tanstack/react-query";

import { useJobResult, useJobs, version } from "../api/queries";
import { Store, usePick, useStore } from "../api/store";
import type { Job, Result } from "../api/types";
import { readDesign, sameDesign, type Work } from "../workbench/document";
import { readLoads, sameButEnd } from "../workbench/loads";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";

/** A job's id, or the newest answered one of the open version, or none. */
export type Choice = { readonly kind: "newest" } | { readonly kind: "none" } | { readonly kind: "job"; readonly id: string };

export const shownJob = new Store<Choice>({ kind: "newest" });

export interface ShownFe {
  job: Job;
  result: Result;
  /** Whether it answers what is on the bench: all parameters and loads alike, save how far it goes. */
  matches: boolean;
}

export function hasResult(job: Job): boolean {
  return job.has_answer;
}

function newestDone(jobs: readonly Job[]): Job | null {
  return jobs.filter(hasResult).reduce<Job | null>(
    (best, job) => (best && best.created_at >= job.created_at ? best : job),
    null,
  );
}

/** Jobs that answer the open version: its own, from its record and from the live list, and those of
 * other versions that hold the same design in the same scene, as a fork's origin does. */
export function useCandidates(): Job[] {
  const versionId = usePick(bench, (timeline) => {
    const origin = timeline?.present.origin;
    return origin?.kind === "version" ? origin.versionId : null;
  });
  const { data: live = [] } = useJobs();
  const { data: detail } = useQuery({ ...version(versionId ?? ""), enabled: versionId !== null });
  const known = new Map<string, Job>();
  for (const job of detail?.jobs ?? []) known.set(job.id, job);
  for (const job of detail?.answered_by ?? []) known.set(job.id, job);
  for (const job of live) {
    if (job.version_id === versionId || known.has(job.id)) known.set(job.id, job);
  }
  return [...known.values()];
}

/** The newest job of what is on the bench, where it failed: no answer has come after it. */
export function useFailedJob(): Job | null {
  const jobs = useCandidates();
  const unchanged = usePick(bench, (timeline) => timeline !== null && !isChanged(timeline.present));
  const newest = jobs.reduce<Job | null>((last, job) => (last && last.created_at >= job.created_at ? last : job), null);
  return unchanged && newest?.state === "failed" ? newest : null;
}

export function useShownJob(): Job | null {
  const choice = useStore(shownJob);
  const jobs = useCandidates();
  if (choice.kind === "none") return null;
  if (choice.kind === "newest") return newestDone(jobs);
  return jobs.find((job) => job.id === choice.id && hasResult(job)) ?? null;
}

function answersSame(result: Result, work: Work): boolean {
  return sameButEnd(readLoads(result.scene), work.loads) && sameDesign(readDesign(result.design), work.design);
}

export function useShownFe(): ShownFe | null {
  const job = useShownJob();
  const { data: result } = useJobResult(job?.id ?? null);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  if (!job || !result || !work) return null;
  return { job, result, matches: answersSame(result, work) };
}
