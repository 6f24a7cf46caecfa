/** The design on the bench: one timeline, kept in the browser's storage while it is edited. */
import { Store } from "../api/store";
import { dropDrafts } from "../ui/drafts";
import { markInput } from "./latency";
import type { DesignDocument, Origin, Value, Work } from "./document";
import type { Loads } from "./loads";
import * as slots from "./slots";
import * as timelines from "./timeline";
import type { Timeline } from "./timeline";

/** Null until the first design is open. */
export const bench = new Store<Timeline | null>(null);

/** The entry edited last, by border name; null after steps back and other designs. */
export const lastEdited = new Store<string | null>(null);

let slot = "new";
let writing = 0;

function persist(): void {
  window.clearTimeout(writing);
  writing = 0;
  const timeline = bench.get();
  if (!timeline) return;
  const pristine = !timelines.isChanged(timeline.present) && timeline.past.length === 0;
  if (slot !== "new" && pristine) slots.clearSlot(slot);
  else slots.writeSlot(slot, timeline);
}

window.addEventListener("pagehide", persist);

bench.subscribe(() => {
  if (writing === 0) writing = window.setTimeout(persist, 250);
});

function change(next: (timeline: Timeline) => Timeline): void {
  bench.update((timeline) => timeline && next(timeline));
}

function editWork(key: string, next: (work: Work) => Work): void {
  markInput();
  lastEdited.set(key);
  change((timeline) => timelines.edit(timeline, next(timeline.present.work), key, performance.now()));
}

/** Put a timeline on the bench; what was there before is stored first. */
export function lay(nextSlot: string, timeline: Timeline): void {
  persist();
  slot = nextSlot;
  lastEdited.set(null);
  dropDrafts();
  bench.set(timeline);
}

export function setParameter(borderName: string, value: Value): void {
  editWork(borderName, (work) => ({ ...work, design: { ...work.design, [borderName]: value } }));
}

/** Several parameters in one step. */
export function setParameters(key: string, values: DesignDocument): void {
  editWork(key, (work) => ({ ...work, design: { ...work.design, ...values } }));
}

/** `key` names the entry moved: "pressure", "plate.gap", ... */
export function setLoads(key: string, change: Partial<Loads>): void {
  editWork(key, (work) => ({ ...work, loads: { ...work.loads, ...change } }));
}

/** A name is not a question: it neither asks anew nor counts as a change of the design. */
export function setName(name: string): void {
  change((timeline) => ({
    ...timeline,
    present: { ...timeline.present, work: { ...timeline.present.work, name } },
  }));
}

export function setOrigin(origin: Origin): void {
  change((timeline) => ({ ...timeline, present: { ...timeline.present, origin } }));
}

export function discardChanges(): void {
  dropDrafts();
  change((timeline) => timelines.edit(timeline, timeline.present.baseline, "discard", 0));
}

export function replaceDesign(work: Work, origin: Origin): void {
  dropDrafts();
  change((timeline) => timelines.replace(timeline, { work, baseline: work, origin }));
}

export function endGesture(): void {
  change(timelines.endGesture);
}

export function undo(): void {
  markInput();
  lastEdited.set(null);
  dropDrafts();
  change(timelines.undo);
}

export function redo(): void {
  markInput();
  lastEdited.set(null);
  dropDrafts();
  change(timelines.redo);
}

/** After saving: the timeline moves to the new version's slot, the old slot is done with. */
export function moveToVersion(origin: Origin & { kind: "version" }, kept: Work): void {
  const timeline = bench.get();
  if (!timeline) return;
  const old = slot;
  slot = slots.slotOf(origin.versionId);
  slots.clearSlot(old);
  bench.set(timelines.saved(timeline, origin, kept));
}
