/** Unsaved work in the browser's storage, one slot for each address, so that no reload loses it. */
import type { Timeline } from "./timeline";

const PREFIX = "pneustudio.work.2:";
/** Steps back that survive a reload. */
const STORED_STEPS = 40;

export function slotOf(versionId: string | null): string {
  return versionId ?? "new";
}

export function readSlot(slot: string): Timeline | null {
  const text = localStorage.getItem(PREFIX + slot);
  if (text === null) return null;
  try {
    const timeline = JSON.parse(text) as Timeline;
    const { work, baseline } = timeline.present;
    if (typeof work.pressureTo !== "number" || typeof baseline.design !== "object") return null;
    return { ...timeline, gesture: null };
  } catch {
    // Not ours, or from another version of the page: begin anew.
    localStorage.removeItem(PREFIX + slot);
    return null;
  }
}

export function writeSlot(slot: string, timeline: Timeline): void {
  const stored: Timeline = {
    present: timeline.present,
    past: timeline.past.slice(-STORED_STEPS),
    future: timeline.future.slice(0, STORED_STEPS),
    gesture: null,
  };
  try {
    localStorage.setItem(PREFIX + slot, JSON.stringify(stored));
  } catch {
    // Storage is full: keep the design itself, let the steps go.
    localStorage.setItem(PREFIX + slot, JSON.stringify({ ...stored, past: [], future: [] }));
  }
}

export function clearSlot(slot: string): void {
  localStorage.removeItem(PREFIX + slot);
}
