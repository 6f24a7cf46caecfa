/** What is being designed: parameters in border units, as the API's documents carry them. */
import type { Parameter } from "../api/types";

export type Value = number | string;
export type DesignDocument = Readonly<Record<string, Value>>;

export interface Work {
  readonly name: string;
  readonly design: DesignDocument;
  /** End of the pressure path [kPa]. */
  readonly pressureTo: number;
  readonly gravity: boolean;
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

const STANDARD_GRAVITY = [0, 0, -9.81];

export interface SceneDocument {
  [key: string]: unknown;
  pressure_kPa: { to: number; steps: number | "auto" };
  gravity_m_s2: number[] | null;
}

/** Points on the path of the instant answer, zero included. */
const STEPS = 20;

export function sceneOf(work: Work, steps: number | "auto" = STEPS): SceneDocument {
  return {
    pressure_kPa: { to: work.pressureTo, steps },
    gravity_m_s2: work.gravity ? STANDARD_GRAVITY : null,
  };
}

function isRecord(value: unknown): value is Record<string, unknown> {
  return typeof value === "object" && value !== null;
}

/** The page's part of a stored scene. */
export function readScene(scene: Record<string, unknown>): Pick<Work, "pressureTo" | "gravity"> {
  const pressure = scene.pressure_kPa;
  const to = isRecord(pressure) && typeof pressure.to === "number" ? pressure.to : 30;
  return { pressureTo: to, gravity: scene.gravity_m_s2 !== null };
}

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
  return a.pressureTo === b.pressureTo && a.gravity === b.gravity && sameDesign(a.design, b.design);
}

/** Number and unit as read in a sentence: "4 mm", "45°", "6". */
export function spell(parameter: Pick<Parameter, "unit">, value: Value): string {
  if (typeof value === "string") return value;
  const unit = parameter.unit === "deg" ? "°" : parameter.unit ? ` ${parameter.unit}` : "";
  return `${Number(value.toPrecision(6))}${unit}`;
}
