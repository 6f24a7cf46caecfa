import type { VersionSummary } from "../api/types";

type Change = VersionSummary["changes"][number];

function spelt(value: number | string | null, unit: string): string {
  if (value === null) return "—";
  const text = typeof value === "number" ? String(Number(value.toPrecision(6))) : value;
  if (unit === "deg") return `${text}°`;
  return unit && typeof value === "number" ? `${text} ${unit}` : text;
}

/** "Bottom layer 4 mm → 5 mm" */
export function changeInWords(change: Change): string {
  return `${change.label} ${spelt(change.from, change.unit)} → ${spelt(change.to, change.unit)}`;
}

export { spelt };
