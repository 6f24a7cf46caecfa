/** Number as a designer types it: no trailing zeros, at most 6 significant digits. */
export function formatNumber(value: number): string {
  return String(Number(value.toPrecision(6)));
}

/** Reads "7.3", "7,3" and " 7.3 "; null for anything else. */
export function parseNumber(text: string): number | null {
  const clean = text.trim().replace(",", ".");
  if (!/^[+-]?(\d+\.?\d*|\.\d+)(e[+-]?\d+)?$/i.test(clean)) return null;
  const value = Number(clean);
  return Number.isFinite(value) ? value : null;
}

/** Thousands apart from ten thousand on: "10 000", with a space that keeps the line together. */
export function grouped(text: string): string {
  return text.replace(/^[−-]?\d{5,}/, (whole) => whole.replace(/\B(?=(\d{3})+$)/g, "\u202f"));
}

/** Decimals that anybody reads of a quantity. */
const MOST_DECIMALS = 4;

/** Decimals that show a ±'s first digit, and its second from 1 to 10. */
export function decimalsOf(size: number): number {
  if (!Number.isFinite(size) || size <= 0 || size >= 9.95) return 0;
  return Math.min(MOST_DECIMALS, Math.max(1, -Math.floor(Math.log10(size))));
}

/** A ± to read, whose first digit always shows: "0.005", "0.3", "1.2", "12". */
export function formatUncertainty(size: number): string {
  if (!Number.isFinite(size)) return "—";
  const least = Number((10 ** -MOST_DECIMALS).toPrecision(1));
  if (size > 0 && size < least) return `< ${least}`;
  return grouped(size.toFixed(decimalsOf(size)));
}

/** A quantity to read: fixed decimals by size and at least as many as asked for, a dash where there is none. */
export function formatQuantity(value: number | null | undefined, digits = 3, leastDecimals = 0): string {
  if (value === null || value === undefined || !Number.isFinite(value)) return "—";
  // What a solver leaves of a zero is a zero to read.
  const size = Math.abs(value) < 1e-6 ? 0 : Math.abs(value);
  if (size !== 0 && (size >= 1e7 || size < 1e-3)) return value.toExponential(digits - 1).replace("-", "−");
  const whole = size >= 1 ? Math.floor(Math.log10(size)) + 1 : 1;
  const decimals = Math.max(leastDecimals, Math.min(MOST_DECIMALS, digits - whole));
  const text = value.toFixed(decimals);
  return grouped((Number(text) === 0 ? text.replace("-", "") : text).replace("-", "−"));
}

/** An error or a change: two digits, and no more than anybody can picture. As the command line has it. */
export function formatPercent(percent: number): string {
  if (!Number.isFinite(percent) || percent > 1000) return "over 1000 %";
  if (percent === 0) return "0 %";
  return percent < 0.01 ? "below 0.01 %" : `${Number(percent.toPrecision(2))} %`;
}

/** The same of an estimate: "about 12 %". */
export function aboutPercent(percent: number): string {
  const text = formatPercent(percent);
  return /^\d/.test(text) ? `about ${text}` : text;
}

export function formatSeconds(seconds: number): string {
  if (seconds < 10) return `${seconds.toFixed(1)} s`;
  if (seconds < 60) return `${seconds.toFixed(0)} s`;
  const minutes = Math.floor(seconds / 60);
  if (minutes < 60) return `${minutes} min ${Math.floor(seconds % 60).toString().padStart(2, "0")} s`;
  return `${Math.floor(minutes / 60)} h ${(minutes % 60).toString().padStart(2, "0")} min`;
}

/** "0.8 MB", "12 MB": what a download weighs. */
export function formatBytes(bytes: number): string {
  const megabytes = bytes / 1e6;
  return `${megabytes < 10 ? Math.max(0.1, megabytes).toFixed(1) : megabytes.toFixed(0)} MB`;
}

export function formatMoment(iso: string): string {
  const moment = new Date(iso);
  const today = new Date().toDateString() === moment.toDateString();
  return today
    ? moment.toLocaleTimeString(undefined, { hour: "2-digit", minute: "2-digit" })
    : moment.toLocaleString(undefined, { dateStyle: "medium", timeStyle: "short" });
}

/** Whether a message holds its advice already, be it in the middle of a sentence. */
export function isSaid(advice: string, message: string): boolean {
  return message.toLowerCase().includes(advice.replace(/\.$/, "").toLowerCase());
}

export function capital(text: string): string {
  return text.charAt(0).toUpperCase() + text.slice(1);
}

/** Begins with a capital, ends with a full stop. */
export function sentence(text: string): string {
  return capital(text) + (/[.!?]$/.test(text) ? "" : ".");
}
