/** A curve to plot: points over which pressure is known, so that a cursor can find its way. */
import type { PathPoint, Result } from "../api/types";

export interface CurvePoint {
  x: number;
  y: number;
  pressure: number;
}

export interface Curve {
  id: string;
  label: string;
  /** Name of the colour's design token. */
  color: string;
  points: readonly CurvePoint[];
  style: "line" | "dashed" | "dots";
  faded?: boolean;
  /** The model's assumptions hold up to this pressure [kPa]; drawn dashed and paler beyond it. */
  trustedTo?: number | null;
}

/** Whether a pressure lies where the answer's own assumptions no longer hold. */
export function isBeyondTrust(result: Result, pressure: number): boolean {
  return result.trusted_to_kPa !== null && pressure > result.trusted_to_kPa * (1 + 1e-6);
}

/** The points up to the trusted pressure and those beyond it; both hold the point between. */
export function splitAtTrust(curve: Curve): { within: readonly CurvePoint[]; beyond: readonly CurvePoint[] } {
  const { points, trustedTo = null } = curve;
  if (trustedTo === null) return { within: points, beyond: [] };
  const first = points.findIndex((point) => point.pressure > trustedTo);
  if (first < 0) return { within: points, beyond: [] };
  const border = pointAt(points, trustedTo);
  const shared = border ? [border] : [];
  return { within: [...points.slice(0, first), ...shared], beyond: [...shared, ...points.slice(first)] };
}

export function anglePoints(result: Result): CurvePoint[] {
  return result.path.flatMap((point) =>
    point.pressure_kPa === null || point.bending_angle_deg === null
      ? []
      : [{ x: point.pressure_kPa, y: point.bending_angle_deg, pressure: point.pressure_kPa }],
  );
}

/** Tip path in the plane of bending: X1 to the right, X3 up. */
export function tipPoints(result: Result): CurvePoint[] {
  return result.path.flatMap((point) => {
    const [x1, , x3] = point.tip_mm;
    if (point.pressure_kPa === null || x1 === null || x3 === null) return [];
    if (x1 === undefined || x3 === undefined) return [];
    return [{ x: x1, y: x3, pressure: point.pressure_kPa }];
  });
}

type Quantity = (point: PathPoint) => number | null | undefined;

/** Value at a pressure, linear between the path's points; null beyond the path, or where the rung
 * does not know the quantity. */
export function valueAt(result: Result, pressure: number, quantity: Quantity): number | null {
  const path = result.path;
  const exact = path.find((point) => point.pressure_kPa !== null && Math.abs(point.pressure_kPa - pressure) < 1e-9);
  if (exact) return quantity(exact) ?? null;
  for (let index = 0; index < path.length; index++) {
    const point = path[index];
    if (!point || point.pressure_kPa === null) continue;
    const next = path[index + 1];
    if (!next || next.pressure_kPa === null) continue;
    if ((pressure - point.pressure_kPa) * (pressure - next.pressure_kPa) > 0) continue;
    const from = quantity(point);
    const to = quantity(next);
    if (from === null || from === undefined || to === null || to === undefined) return null;
    const share = (pressure - point.pressure_kPa) / (next.pressure_kPa - point.pressure_kPa);
    return from + share * (to - from);
  }
  return null;
}

export function pointAt(points: readonly CurvePoint[], pressure: number): CurvePoint | null {
  for (let index = 0; index < points.length; index++) {
    const point = points[index];
    if (!point) continue;
    if (Math.abs(point.pressure - pressure) < 1e-9) return point;
    const next = points[index + 1];
    if (!next || (pressure - point.pressure) * (pressure - next.pressure) > 0) continue;
    const share = (pressure - point.pressure) / (next.pressure - point.pressure);
    return { x: point.x + share * (next.x - point.x), y: point.y + share * (next.y - point.y), pressure };
  }
  return null;
}
