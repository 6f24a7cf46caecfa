/** A curve to plot: points whose place on the path is known, so that a cursor can find its way. */
import type { PathPoint, Result } from "../api/types";
import type { Control } from "../workbench/loads";

export interface CurvePoint {
  x: number;
  y: number;
  /** Place on the path: pressure [kPa] or volume [ml], whichever is in control. */
  at: number;
}

export interface Curve {
  id: string;
  label: string;
  /** What the legend shows instead, its tooltip being the label. */
  short?: string;
  /** Name of the colour's design token. */
  color: string;
  points: readonly CurvePoint[];
  style: "line" | "dashed" | "dots";
  faded?: boolean;
  /** The model's assumptions hold up to this place on the path; drawn dashed and paler beyond it. */
  trustedTo?: number | null;
}

/** The place up to which the answer's own assumptions hold; null where they hold on the whole path. */
export function trustedPlace(result: Result, control: Control): number | null {
  const trusted = result.trusted_to_kPa;
  if (trusted === null || control === "pressure") return trusted;
  return valueAt(result, trusted, (point) => point.cavity_volume_ml);
}

/** Whether a place on the path lies where the answer's own assumptions no longer hold. */
export function isBeyondTrust(result: Result, at: number, control: Control = "pressure"): boolean {
  const trusted = trustedPlace(result, control);
  const places = result.path.map((point) => placeOf(point, control) ?? 0);
  const onward = (places.at(-1) ?? 0) < (places[0] ?? 0) ? -1 : 1; // suction, and emptying, go down
  return trusted !== null && onward * (at - trusted) > 1e-6 * Math.abs(trusted);
}

/** The points up to the trusted pressure and those beyond it; both hold the point between. */
export function splitAtTrust(curve: Curve): { within: readonly CurvePoint[]; beyond: readonly CurvePoint[] } {
  const { points, trustedTo = null } = curve;
  if (trustedTo === null) return { within: points, beyond: [] };
  const onward = (points.at(-1)?.at ?? 0) < (points[0]?.at ?? 0) ? -1 : 1; // suction, and emptying, go down
  const first = points.findIndex((point) => onward * (point.at - trustedTo) > 0);
  if (first < 0) return { within: points, beyond: [] };
  const border = pointAt(points, trustedTo);
  const shared = border ? [border] : [];
  return { within: [...points.slice(0, first), ...shared], beyond: [...shared, ...points.slice(first)] };
}

/** Where on a path a point stands: its pressure [kPa], or the cavity's volume [ml] where that is in
 * control; a path through a limit point has pressures twice, but each volume once. */
export function placeOf(point: PathPoint, control: Control): number | null {
  return (control === "volume" ? point.cavity_volume_ml : point.pressure_kPa) ?? null;
}

export type PointsOf = (result: Result, control?: Control) => CurvePoint[];

/** A quantity over what is in control. */
export function overControl(quantity: Quantity): PointsOf {
  return (result, control = "pressure") =>
    result.path.flatMap((point) => {
      const at = placeOf(point, control);
      const y = quantity(point) ?? null;
      return at === null || y === null ? [] : [{ x: at, y, at }];
    });
}

export const anglePoints: PointsOf = overControl((point) => point.bending_angle_deg);

/** Tip path in the plane of bending: X1 to the right, X3 up. */
export const tipPoints: PointsOf = (result, control = "pressure") =>
  result.path.flatMap((point) => {
    const [x1, , x3] = point.tip_mm;
    const at = placeOf(point, control);
    if (at === null || x1 === null || x3 === null || x1 === undefined || x3 === undefined) return [];
    return [{ x: x1, y: x3, at }];
  });

/** Frames of the 3D view are told to six digits: the last one may lie a hair beyond the path, whose end is meant. */
function isEnd(place: number | null | undefined, at: number): boolean {
  return typeof place === "number" && Math.abs(place - at) <= 1e-5 * Math.abs(place);
}

export type Quantity = (point: PathPoint) => number | null | undefined;

/** Value at a pressure (or a volume), linear between the path's points; null beyond the path, or
 * where the rung does not know the quantity. */
export function valueAt(result: Result, at: number, quantity: Quantity, control: Control = "pressure"): number | null {
  const places = result.path.map((point) => placeOf(point, control));
  const exact = places.findIndex((place) => place !== null && Math.abs(place - at) < 1e-9);
  const found = result.path[exact];
  if (found) return quantity(found) ?? null;
  for (let index = 0; index + 1 < places.length; index++) {
    const [here, there] = [places[index] ?? null, places[index + 1] ?? null];
    const [point, next] = [result.path[index], result.path[index + 1]];
    if (!point || !next || here === null || there === null) continue;
    if ((at - here) * (at - there) > 0) continue;
    const from = quantity(point);
    const to = quantity(next);
    if (from === null || from === undefined || to === null || to === undefined) return null;
    return from + ((at - here) / (there - here)) * (to - from);
  }
  const last = result.path.at(-1);
  return last && isEnd(places.at(-1), at) ? (quantity(last) ?? null) : null;
}

export function pointAt(points: readonly CurvePoint[], at: number): CurvePoint | null {
  for (let index = 0; index < points.length; index++) {
    const point = points[index];
    if (!point) continue;
    if (Math.abs(point.at - at) < 1e-9) return point;
    const next = points[index + 1];
    if (!next || (at - point.at) * (at - next.at) > 0) continue;
    const share = (at - point.at) / (next.at - point.at);
    return { x: point.x + share * (next.x - point.x), y: point.y + share * (next.y - point.y), at };
  }
  const last = points.at(-1);
  return last && isEnd(last.at, at) ? last : null;
}
