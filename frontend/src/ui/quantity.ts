/** Quantities as typed: a number, or a number with a unit of the field's kind. */
import { parseNumber } from "./numbers";

/** Each kind of unit, with what one of it is in the kind's first unit. */
const KINDS: readonly Readonly<Record<string, number>>[] = [
  { mm: 1, cm: 10, dm: 100, m: 1000, µm: 1e-3, um: 1e-3, in: 25.4 },
  { kPa: 1, Pa: 1e-3, hPa: 0.1, MPa: 1000, mbar: 0.1, bar: 100, psi: 6.894757293 },
  { ml: 1, l: 1000, L: 1000, cm3: 1, "cm³": 1, mm3: 1e-3, "mm³": 1e-3, m3: 1e6, "m³": 1e6 },
  { N: 1, mN: 1e-3, kN: 1000 },
  { "m/s²": 1, "m/s2": 1 },
  { "%": 1 },
  { s: 1, ms: 1e-3, min: 60, h: 3600 },
  { deg: 1, "°": 1, rad: 180 / Math.PI },
];

function unitsLike(unit: string): Readonly<Record<string, number>> {
  return KINDS.find((kind) => unit in kind) ?? {};
}

/** "12 cm" in a field of mm is 120; null for anything that is no number of that kind. */
export function parseQuantity(text: string, unit: string): number | null {
  const plain = parseNumber(text);
  if (plain !== null) return plain;
  const parts = /^(.*[\d.])\s*([^\d\s.]+)$/.exec(text.trim());
  const value = parseNumber(parts?.[1] ?? "");
  const written = (parts?.[2] ?? "").replace("μ", "µ");
  const units = unitsLike(unit);
  const exact = Object.hasOwn(units, written) ? written : undefined;
  // "12 CM", "500 pa": only where no other unit is spelt so.
  const alike = Object.keys(units).filter((each) => each.toLowerCase() === written.toLowerCase());
  const from = units[exact ?? (alike.length === 1 ? (alike[0] ?? "") : "")];
  const to = units[unit];
  if (value === null || from === undefined || to === undefined) return null;
  const converted = Number(((value * from) / to).toPrecision(10));
  return Number.isFinite(converted) ? converted : null;
}

/** What to say where the text cannot be taken; null where it can. */
export function refusalOf(text: string, unit: string, integer: boolean): string | null {
  const value = parseQuantity(text, unit);
  if (integer) return value !== null && Number.isInteger(value) ? null : "Write a whole number.";
  if (value !== null) return null;
  if (!unit) return "Write a number.";
  return `Write a number in ${unit === "deg" ? "degrees" : unit}.`;
}
