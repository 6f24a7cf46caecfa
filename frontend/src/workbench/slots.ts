/** Unsaved work in the browser's storage, one slot for each address, so that no reload loses it. */
import type { Work } from "./document";
import { pressureLoads, type Loads } from "./loads";
import type { Snapshot, Timeline } from "./timeline";

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
    const { present, past, future } = JSON.parse(text) as Timeline;
    return {
      present: snapshot(present),
      past: past.map(snapshot),
      future: future.map(snapshot),
      gesture: null,
    };
  } catch {
    // Not ours, or from another version of the page: begin anew.
    localStorage.removeItem(PREFIX + slot);
    return null;
  }
}

/** Work as earlier pages kept it had a pressure and a gravity that was there or not. */
interface EarlierWork {
  pressureTo?: unknown;
  gravity?: unknown;
}

function upToDate(work: Work & EarlierWork): Work {
  if (typeof work.design !== "object") throw new TypeError("no design");
  if (typeof work.loads === "object") return { ...work, loads: withChoices(work.loads) };
  const { pressureTo, gravity, ...rest } = work;
  if (typeof pressureTo !== "number") throw new TypeError("no loads");
  const loads = pressureLoads(pressureTo);
  return { ...rest, loads: gravity === false ? { ...loads, gravity: null } : loads };
}

/** Loads as earlier pages kept them knew one effect to be chosen. */
function withChoices(loads: Loads & { selfContact?: unknown }): Loads {
  const { selfContact, ...rest } = loads;
  if (typeof rest.forced === "object") return rest;
  return { ...rest, forced: selfContact === "on" || selfContact === "off" ? { self_contact: selfContact } : {} };
}

function snapshot({ work, baseline, origin }: Snapshot): Snapshot {
  return { work: upToDate(work), baseline: upToDate(baseline), origin };
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
