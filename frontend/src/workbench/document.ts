/** What is being designed: parameters in border units, as the API's documents carry them. */
import type { Parameter } from "../api/types";
import { sameLoads, type Loads } from "./loads";

export type Value = number | string;
export type DesignDocument = Readonly<Record<string, Value>>;

export interface Work {
  readonly name: string;
  readonly design: DesignDocument;
  readonly loads: Loads;
}

export type Origin =
  | { readonly kind: "preset"; readonly preset: string; readonly title: string }
  | {
      readonly kind: "version";
      readonly versionId: string;
      readonly designId: string;
      readonly number: number;
      readonly label: string | null;
    };

export function readDesign(document: Record<string, unknown>): DesignDocument {
  const design: Record<string, Value> = {};
  for (const [key, value] of Object.entries(document)) {
    if (typeof value === "number" || typeof value === "string") design[key] = value;
  }
  return design;
}

export function familyOf(design: DesignDocument): string {
  return String(design.family);
}

export function sameDesign(a: DesignDocument, b: DesignDocument): boolean {
  const names = new Set([...Object.keys(a), ...Object.keys(b)]);
  return [...names].every((name) => a[name] === b[name]);
}

export function sameQuestion(a: Work, b: Work): boolean {
  return sameLoads(a.loads, b.loads) && sameDesign(a.design, b.design);
}

/** Number and unit as read in a sentence: "4 mm", "45°", "6". */
export function spell(parameter: Pick<Parameter, "unit">, value: Value): string {
  if (typeof value === "string") return value;
  const unit = parameter.unit === "deg" ? "°" : parameter.unit ? ` ${parameter.unit}` : "";
  return `${Number(value.toPrecision(6))}${unit}`;
}
