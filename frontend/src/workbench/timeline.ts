/** Undo and redo over snapshots, as pure functions. */
import { sameQuestion, type Origin, type Work } from "./document";

export interface Snapshot {
  readonly work: Work;
  /** As it was opened: what "changed" and "reset" refer to. */
  readonly baseline: Work;
  readonly origin: Origin;
}

export interface Timeline {
  readonly present: Snapshot;
  readonly past: readonly Snapshot[];
  readonly future: readonly Snapshot[];
  /** What is being moved and since when; moves of one thing in one go are one step. */
  readonly gesture: { readonly key: string; readonly at: number } | null;
}

const KEPT = 100;
const GESTURE_MS = 800;

export function start(present: Snapshot): Timeline {
  return { present, past: [], future: [], gesture: null };
}

export function edit(timeline: Timeline, work: Work, key: string, now: number): Timeline {
  const { gesture, present } = timeline;
  const continues = gesture?.key === key && now - gesture.at < GESTURE_MS;
  return {
    present: { ...present, work },
    past: continues ? timeline.past : [...timeline.past, present].slice(-KEPT),
    future: [],
    gesture: { key, at: now },
  };
}

/** A whole other design (a preset), as one step that can be undone. */
export function replace(timeline: Timeline, present: Snapshot): Timeline {
  return { present, past: [...timeline.past, timeline.present].slice(-KEPT), future: [], gesture: null };
}

export function endGesture(timeline: Timeline): Timeline {
  return timeline.gesture === null ? timeline : { ...timeline, gesture: null };
}

export function undo(timeline: Timeline): Timeline {
  const previous = timeline.past.at(-1);
  if (!previous) return timeline;
  return {
    present: previous,
    past: timeline.past.slice(0, -1),
    future: [timeline.present, ...timeline.future],
    gesture: null,
  };
}

export function redo(timeline: Timeline): Timeline {
  const [next, ...rest] = timeline.future;
  if (!next) return timeline;
  return { present: next, past: [...timeline.past, timeline.present], future: rest, gesture: null };
}

/** The present is now a saved version; steps back stay possible, and are changes against it. */
export function saved(timeline: Timeline, origin: Origin, kept: Work): Timeline {
  const rebase = (snapshot: Snapshot): Snapshot => ({
    work: { ...snapshot.work, name: kept.name },
    baseline: kept,
    origin,
  });
  return {
    present: rebase(timeline.present),
    past: timeline.past.map(rebase),
    future: [],
    gesture: null,
  };
}

export function isChanged(snapshot: Snapshot): boolean {
  return !sameQuestion(snapshot.work, snapshot.baseline);
}
