/** The one websocket of this tab: jobs and history as they change. */
import { keys, queryClient } from "./queries";
import { Store } from "./store";
import type { Job, LiveEvent } from "./types";

export type Connection = "connecting" | "live" | "lost";

export const connection = new Store<Connection>("connecting");

/** Counts connections made; a change means that something may have been missed. */
export const reconnections = new Store(0);

/** A live channel sends a beat every 15 s; twice that without news and it is taken as lost. */
const SILENCE_MS = 35_000;

let lastSeq: number | null = null;
let attempts = 0;

export function withJob(jobs: readonly Job[] | undefined, job: Job): Job[] {
  const rest = jobs ?? [];
  const index = rest.findIndex((other) => other.id === job.id);
  return index < 0 ? [job, ...rest] : rest.with(index, job);
}

const FINAL = new Set<Job["state"]>(["done", "failed", "cancelled"]);

/** Called with every job that ends while this tab looks on. */
export const onJobEnd = new Set<(job: Job) => void>();

function onJob(job: Job): void {
  const before = queryClient.getQueryData<Job[]>(keys.jobs)?.find((other) => other.id === job.id);
  queryClient.setQueryData<Job[]>(keys.jobs, (jobs) => withJob(jobs, job));
  if (FINAL.has(job.state)) {
    if (before && !FINAL.has(before.state)) for (const listener of onJobEnd) listener(job);
    // A list on its way may be older than this end and must not take its place.
    if (queryClient.isFetching({ queryKey: keys.jobs }) > 0) void queryClient.invalidateQueries({ queryKey: keys.jobs });
    void queryClient.invalidateQueries({ queryKey: keys.version(job.version_id) });
    void queryClient.invalidateQueries({ queryKey: keys.designs });
    void queryClient.invalidateQueries({ queryKey: ["compare"] });
  }
}

function onEvent(event: LiveEvent): void {
  lastSeq = event.seq;
  if (event.kind === "job" && event.job) onJob(event.job);
  if (event.kind === "history") {
    // A new name shows in the list of jobs as well.
    for (const queryKey of [keys.designs, keys.jobs]) void queryClient.invalidateQueries({ queryKey });
  }
}

const CHANGING = new Set(["jobs", "designs", "version", "compare", "health"]);

function refetchAll(): void {
  void queryClient.invalidateQueries({
    predicate: (query) => query.state.status === "error" || CHANGING.has(String(query.queryKey[0])),
  });
}

export function connectLive(): void {
  const scheme = window.location.protocol === "https:" ? "wss" : "ws";
  const after = lastSeq === null ? "" : `?after=${lastSeq}`;
  const socket = new WebSocket(`${scheme}://${window.location.host}/api/live${after}`);
  let silence = 0;

  const expectBeat = () => {
    window.clearTimeout(silence);
    silence = window.setTimeout(() => socket.close(), SILENCE_MS);
  };

  socket.onopen = () => {
    expectBeat();
    const returning = lastSeq !== null || attempts > 0;
    attempts = 0;
    connection.set("live");
    refetchAll(); // What was fetched before this channel stood may have changed in between.
    if (!returning) return;
    reconnections.update((count) => count + 1);
  };
  socket.onmessage = (message: MessageEvent<string>) => {
    expectBeat();
    onEvent(JSON.parse(message.data) as LiveEvent);
  };
  socket.onclose = () => {
    window.clearTimeout(silence);
    attempts += 1;
    connection.set("lost");
    const pause = Math.min(5000, 300 * 2 ** Math.min(attempts, 5));
    window.setTimeout(connectLive, pause);
  };
}
