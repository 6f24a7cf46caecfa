/** Estimated errors of an answer in the units of what they belong to. */
import { isBeyondTrust, valueAt } from "../charts/curve";
import type { PathPoint, Result } from "../api/types";
import type { Control } from "../workbench/loads";
import type { Quantity } from "./quantities";

export interface Uncertainty {
  /** In the quantity's unit. */
  size: number;
  /** What the percent are of. */
  of: string;
  percent: number;
}

type Key = NonNullable<Quantity["estimate"]>;

function length(values: readonly (number | null)[]): number {
  return Math.hypot(...values.map((value) => value ?? 0));
}

function grown(point: PathPoint, first: PathPoint): number | null {
  const [now, before] = [point.cavity_volume_ml, first.cavity_volume_ml];
  return now === null || before === null ? null : now - before;
}

/** Estimates are shares of these: of the way and not of where it leads to, of the growth and not of the volume. */
const WHOLE: Record<Key, { of: string; at: (point: PathPoint, first: PathPoint) => number | null | undefined }> = {
  tip: { of: "the tip's way", at: (point) => length(point.tip_displacement_mm) },
  angle: { of: "the end's turn", at: (point) => point.tip_rotation_deg },
  volume: { of: "the cavity's growth", at: grown },
  force: { of: "the force", at: (point) => point.plate_force_N ?? point.cylinder_force_N },
};

/** What rounding leaves of a zero, in any unit. */
const ROUNDED = 1e-9;

/** What `quantity` may be off by at a place of the path; null where nothing is known of it, beyond the
 * answer's own range, or where symmetry keeps it at 0. */
export function uncertainty(result: Result, quantity: Quantity, place: number, control: Control): Uncertainty | null {
  const key = quantity.estimate;
  const percent = key === undefined ? null : result.error_estimates_percent[key];
  const first = result.path[0];
  if (key === undefined || percent === null || percent === undefined || first === undefined) return null;
  if (result.path.every((point) => Math.abs(quantity.value(point) ?? Infinity) < ROUNDED)) return null;
  if (isBeyondTrust(result, place, control)) return null;
  const { of, at } = WHOLE[key];
  const whole = valueAt(result, place, key === "force" ? quantity.value : (point) => at(point, first), control);
  return whole === null ? null : { size: Math.abs(whole) * (percent / 100), of, percent };
}
