/** Which place on the path is looked at: one value for the 3D view, the plots and the numbers. */
import { Store } from "../api/store";
import type { Control } from "./loads";

export interface Scrubber {
  /** What places are: pressures [kPa] or volumes [ml]. */
  readonly control: Control;
  /** Place looked at; null stands for the end of the path. */
  readonly at: number | null;
  /** Places of the frames, from rest to the end; they fall under suction. */
  readonly frames: readonly number[];
  readonly playing: boolean;
}

export const scrubber = new Store<Scrubber>({ control: "pressure", at: null, frames: [], playing: false });

export function nearest(frames: readonly number[], at: number): number {
  let best = 0;
  for (let index = 1; index < frames.length; index++) {
    if (Math.abs((frames[index] ?? 0) - at) < Math.abs((frames[best] ?? 0) - at)) best = index;
  }
  return best;
}

export function frameIndex(state: Scrubber): number {
  if (state.at === null) return Math.max(0, state.frames.length - 1);
  return nearest(state.frames, state.at);
}

/** Place of the frame shown, or null before there are frames. */
export function shownPlace(state: Scrubber): number | null {
  return state.frames[frameIndex(state)] ?? null;
}

export function setFrames(frames: readonly number[], control: Control = "pressure"): void {
  scrubber.update((state) => {
    const [first = 0] = frames;
    const last = frames.at(-1) ?? 0;
    const sense = last < first ? -1 : 1;
    const beyond = state.at !== null && (state.at - last) * sense >= 0;
    return { ...state, frames, control, at: beyond || control !== state.control ? null : state.at };
  });
}

export function scrubToFrame(index: number): void {
  scrubber.update((state) => {
    const isLast = index >= state.frames.length - 1;
    return { ...state, at: isLast ? null : (state.frames[Math.max(0, index)] ?? null), playing: false };
  });
}

export function scrubTo(at: number): void {
  scrubToFrame(nearest(scrubber.get().frames, at));
}

const FRAME_MS = 90;
const HOLD_MS = 700;
let timer = 0;

function step(): void {
  const state = scrubber.get();
  if (!state.playing) return;
  const last = state.frames.length - 1;
  const next = frameIndex(state) >= last ? 0 : frameIndex(state) + 1;
  scrubber.set({ ...state, at: next === last ? null : (state.frames[next] ?? 0) });
  timer = window.setTimeout(step, next === last ? HOLD_MS : FRAME_MS);
}

export function togglePlay(): void {
  window.clearTimeout(timer);
  scrubber.update((state) => ({ ...state, playing: !state.playing && state.frames.length > 1 }));
  if (scrubber.get().playing) step();
}
