import type { Triple } from "../workbench/loads";

/** A direction with a name. */
export interface Direction {
  value: string;
  label: string;
  vector: Triple;
}

/** Name of a direction, "own" for one that has none. */
export function optionOf(options: readonly Direction[], vector: Triple): string {
  const same = (other: Triple) => other.every((part, axis) => Math.abs(part - (vector[axis] ?? 0)) < 1e-9);
  return options.find((option) => same(option.vector))?.value ?? "own";
}
