/** Logarithmic axes: ranges in whole decades, their marks, and values as places. */

export interface LogScale {
  readonly low: number;
  readonly high: number;
  /** Place [px] of a value; values beyond the ends stand at them. */
  readonly place: (value: number) => number;
}

/** Whole decades around the values, at least two of them; `least`: nothing below it is told apart. */
export function decades(values: readonly number[], least: number): [number, number] {
  const positive = values.filter((value) => Number.isFinite(value)).map((value) => Math.max(value, least));
  if (positive.length === 0) return [least, 100 * least];
  // A value on a decade needs no further one.
  const low = Math.floor(Math.log10(Math.min(...positive)) + 1e-9);
  const high = Math.ceil(Math.log10(Math.max(...positive)) - 1e-9);
  return [10 ** low, 10 ** Math.max(high, low + 2)];
}

/** `from` and `to`: places [px] of the ends. */
export function logScale([low, high]: readonly [number, number], from: number, to: number): LogScale {
  const [start, end] = [Math.log10(low), Math.log10(high)];
  const place = (value: number) => {
    const share = (Math.log10(Math.max(value, low)) - start) / (end - start);
    return from + Math.min(1, share) * (to - from);
  };
  return { low, high, place };
}

/** Decades to be marked, at most `most` of them, evenly left out where there are more. */
export function marks({ low, high }: Pick<LogScale, "low" | "high">, most: number): number[] {
  const first = Math.round(Math.log10(low));
  const count = Math.round(Math.log10(high)) - first + 1;
  const every = Math.ceil(count / most);
  return Array.from({ length: Math.ceil(count / every) }, (_, index) => 10 ** (first + index * every));
}

interface TimeMark {
  /** [s] */
  readonly at: number;
  readonly text: string;
}

/** One and ten of every unit that times are told in. */
const TIMES: readonly TimeMark[] = [
  { at: 1e-4, text: "0.1 ms" },
  { at: 1e-3, text: "1 ms" },
  { at: 0.01, text: "10 ms" },
  { at: 0.1, text: "0.1 s" },
  { at: 1, text: "1 s" },
  { at: 10, text: "10 s" },
  { at: 60, text: "1 min" },
  { at: 600, text: "10 min" },
  { at: 3600, text: "1 h" },
  { at: 36_000, text: "10 h" },
  { at: 360_000, text: "100 h" },
];

/** Times to be marked on a scale of seconds, at most `most` of them, evenly left out where there are more. */
export function timeMarks({ low, high }: Pick<LogScale, "low" | "high">, most: number): TimeMark[] {
  const within = TIMES.filter(({ at }) => at >= low * (1 - 1e-9) && at <= high * (1 + 1e-9));
  const every = Math.ceil(within.length / most);
  return within.filter((_, index) => index % every === 0);
}

/** "10 ms", "1 s", "2.5 min", as short as can be. */
export function shortSeconds(seconds: number): string {
  const two = (value: number) => String(Number(value.toPrecision(2)));
  if (seconds < 0.0995) return `${two(1000 * seconds)} ms`;
  if (seconds < 99.5) return `${two(seconds)} s`;
  if (seconds < 99.5 * 60) return `${two(seconds / 60)} min`;
  return `${two(seconds / 3600)} h`;
}

interface Seconds {
  readonly value: number;
  readonly low: number;
  readonly high: number;
}

/** "about 1.3 s, four of five jobs between 1 s and 10 s" */
export function rangeInWords({ value, low, high }: Seconds): string {
  return `about ${shortSeconds(value)}, four of five jobs between ${shortSeconds(low)} and ${shortSeconds(high)}`;
}
