import type { Result } from "../api/types";
import { placeOf } from "../charts/curve";
import type { Control } from "../workbench/loads";

/** The farthest place that a path reached: its highest pressure or volume; its lowest under suction, and where a cavity
 * is emptied. */
export function reached(result: Result, control: Control): number | null {
  const places = result.path.flatMap((point) => placeOf(point, control) ?? []);
  const [first] = places;
  const last = places.at(-1);
  if (first === undefined || last === undefined) return null;
  return last < first ? Math.min(...places) : Math.max(...places);
}

/** `at`, or the end of the path where that lies before it. */
export function within(result: Result, at: number, control: Control): number {
  const [start] = result.path;
  const first = start === undefined ? null : placeOf(start, control);
  const end = reached(result, control);
  if (first === null || end === null) return at;
  return (at - end) * (end < first ? -1 : 1) > 0 ? end : at;
}
