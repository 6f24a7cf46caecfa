/** What a running job was expected to take, held against what it has taken. */
import { useExpectedSeconds, useJobs } from "../api/queries";
import type { Job, LadderPoint } from "../api/types";
import { shortSeconds } from "../ladder/scale";
import { useElapsed } from "./useElapsed";

type Seconds = NonNullable<LadderPoint["seconds"]>;

/** Whether a job runs longer than the upper end of what was expected, where nine of ten such jobs have ended. */
export function isLate(job: Pick<Job, "state">, elapsed: number | null, expected: Seconds | null): boolean {
  return job.state === "running" && elapsed !== null && expected !== null && elapsed > expected.high;
}

export interface Expectation {
  elapsed: number | null;
  expected: Seconds | null;
  /** "Longer than expected (1.3 s)" once the upper end of the expectation is passed. */
  late: string | null;
}

export function useExpectation(job: Job | null): Expectation {
  const elapsed = useElapsed(job);
  const { data: expected = null } = useExpectedSeconds(job);
  const late = job !== null && expected !== null && isLate(job, elapsed, expected);
  return { elapsed, expected, late: late ? `Longer than expected (${shortSeconds(expected.value)})` : null };
}

/** The same of a job that is known by its id only. */
export function useLateness(jobId: string | null): string | null {
  const { data: jobs = [] } = useJobs();
  return useExpectation(jobs.find((job) => job.id === jobId) ?? null).late;
}
