/** Which pressure is looked at: one value for the 3D view, the plots and the numbers. */
import { Store } from "../api/store";

export interface Scrubber {
  /** Pressure looked at [kPa]; null stands for the end of the path. */
  readonly pressure: number | null;
  /** Pressures of the frames [kPa]. */
  readonly frames: readonly number[];
  readonly playing: boolean;
}

export const scrubber = new Store<Scrubber>({ pressure: null, frames: [], playing: false });

export function nearest(frames: readonly number[], pressure: number): number {
  let best = 0;
  for (let index = 1; index < frames.length; index++) {
    if (Math.abs((frames[index] ?? 0) - pressure) < Math.abs((frames[best] ?? 0) - pressure)) best = index;
  }
  return best;
}

export function frameIndex(state: Scrubber): number {
  if (state.pressure === null) return Math.max(0, state.frames.length - 1);
  return nearest(state.frames, state.pressure);
}

/** Pressure of the frame shown [kPa], or null before there are frames. */
export function shownPressure(state: Scrubber): number | null {
  return state.frames[frameIndex(state)] ?? null;
}

export function setFrames(frames: readonly number[]): void {
  scrubber.update((state) => {
    const last = frames.at(-1) ?? 0;
    const beyond = state.pressure !== null && state.pressure >= last;
    return { ...state, frames, pressure: beyond ? null : state.pressure };
  });
}

export function scrubToFrame(index: number): void {
  scrubber.update((state) => {
    const isLast = index >= state.frames.length - 1;
    return { ...state, pressure: isLast ? null : (state.frames[Math.max(0, index)] ?? null), playing: false };
  });
}

export function scrubToPressure(pressure: number): void {
  scrubToFrame(nearest(scrubber.get().frames, pressure));
}

const FRAME_MS = 90;
const HOLD_MS = 700;
let timer = 0;

function step(): void {
  const state = scrubber.get();
  if (!state.playing) return;
  const last = state.frames.length - 1;
  const next = frameIndex(state) >= last ? 0 : frameIndex(state) + 1;
  scrubber.set({ ...state, pressure: next === last ? null : (state.frames[next] ?? 0) });
  timer = window.setTimeout(step, next === last ? HOLD_MS : FRAME_MS);
}

export function togglePlay(): void {
  window.clearTimeout(timer);
  scrubber.update((state) => ({ ...state, playing: !state.playing && state.frames.length > 1 }));
  if (scrubber.get().playing) step();
}
