/** What a slider spans. Limits of a family are far apart (10 to 1000 mm); a slider over all of
 * them could not be set to a tenth. So it spans a window around the value the design was opened
 * with; the number field takes the full limits. */
import type { Parameter } from "../api/types";

export interface Reach {
  min: number;
  max: number;
  step: number;
}

function roundTo(value: number, step: number, how: (x: number) => number): number {
  return Number((how(value / step + (how === Math.ceil ? -1e-9 : 1e-9)) * step).toPrecision(10));
}

export function reachOf(parameter: Parameter, opened: number, current: number): Reach {
  const lower = parameter.lower ?? -Infinity;
  const upper = parameter.upper ?? Infinity;
  const step = parameter.step ?? (parameter.kind === "count" ? 1 : 0.1);
  if (parameter.kind === "angle") return { min: lower, max: upper, step };
  const size = Math.max(Math.abs(opened), 4 * step);
  const least = parameter.kind === "count" ? opened / 3 : size / 4;
  let min = Math.max(lower, roundTo(least, step, Math.floor));
  let max = Math.min(upper, roundTo(size * 2.5, step, Math.ceil));
  if (current < min) min = Math.max(lower, roundTo(current, step, Math.floor));
  if (current > max) max = Math.min(upper, roundTo(current, step, Math.ceil));
  return { min, max, step };
}

/** Sliders count their steps from `min`; a value between steps must stay reachable, so the track's
 * start is moved onto the grid of the opened value. */
export function alignReach(reach: Reach, opened: number): Reach {
  const offset = (opened - reach.min) % reach.step;
  const onGrid = Math.abs(offset) < 1e-9 || Math.abs(offset - reach.step) < 1e-9;
  if (onGrid) return reach;
  const count = Math.floor((opened - reach.min) / reach.step + 1e-9);
  return { ...reach, min: Number((opened - count * reach.step).toPrecision(10)) };
}
