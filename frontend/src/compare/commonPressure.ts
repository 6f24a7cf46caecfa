import type { Result } from "../api/types";

/** The highest pressure that every given path reaches [kPa]. */
export function commonPressure(results: readonly (Result | null)[]): number | null {
  const ends = results.flatMap((result) => {
    const last = result?.path.at(-1)?.pressure_kPa;
    return last === null || last === undefined ? [] : [last];
  });
  return ends.length === 0 ? null : Math.min(...ends);
}
