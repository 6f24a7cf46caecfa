/** What the designer would put up with; kept between visits. */
import { Store } from "../api/store";

export interface Limits {
  readonly percent: number;
  readonly seconds: number;
}

const KEY = "pneustudio.limits";
const FIRST: Limits = { percent: 2, seconds: 10 };
export const MOST: Limits = { percent: 1000, seconds: 1e6 };

function usable(value: unknown, most: number): value is number {
  return typeof value === "number" && value > 0 && value <= most;
}

/** The limits with one changed; unchanged where the value cannot be meant. */
export function withLimit(limits: Limits, name: keyof Limits, value: number): Limits {
  return usable(value, MOST[name]) ? { ...limits, [name]: value } : limits;
}

export function sameLimits(a: Limits | null, b: Limits): boolean {
  return a !== null && a.percent === b.percent && a.seconds === b.seconds;
}

function read(): Limits {
  try {
    const stored = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<Limits>;
    return withLimit(withLimit(FIRST, "percent", Number(stored.percent)), "seconds", Number(stored.seconds));
  } catch {
    return FIRST;
  }
}

export const limits = new Store<Limits>(read());

limits.subscribe(() => localStorage.setItem(KEY, JSON.stringify(limits.get())));
