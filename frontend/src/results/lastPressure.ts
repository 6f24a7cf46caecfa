import type { Result } from "../api/types";

/** The highest pressure a path reached [kPa]. */
export function lastPressure(result: Result): number | null {
  const pressures = result.path.flatMap((point) => (point.pressure_kPa === null ? [] : [point.pressure_kPa]));
  return pressures.length === 0 ? null : Math.max(...pressures);
}
