import type { Result } from "../api/types";
import { reached } from "../results/reached";

/** The highest pressure that every given path reaches [kPa]. */
export function commonPressure(results: readonly (Result | null)[]): number | null {
  const ends = endsOf(results);
  return ends.length === 0 ? null : Math.min(...ends);
}

/** The highest pressure that any given path reaches [kPa]. */
export function highestPressure(results: readonly (Result | null)[]): number | null {
  const ends = endsOf(results);
  return ends.length === 0 ? null : Math.max(...ends);
}

function endsOf(results: readonly (Result | null)[]): number[] {
  return results.flatMap((result) => (result ? (reached(result, "pressure") ?? []) : []));
}
