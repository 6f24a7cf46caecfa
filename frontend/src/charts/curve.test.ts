import { describe, expect, it } from "vitest";

import type { PathPoint, Result } from "../api/types";
import { anglePoints, isBeyondTrust, pointAt, tipPoints, valueAt, splitAtTrust } from "./curve";
import { equalRanges, freeRanges } from "./scales";

function point(pressure: number, angle: number, stretch: number | null = null): PathPoint {
  return {
    pressure_kPa: pressure, tip_mm: [100 - pressure, 0, -pressure], tip_displacement_mm: [0, 0, 0],
    tip_rotation_deg: null, bending_angle_deg: angle, curvature_per_m: null, torsion_per_m: null,
    helix_radius_mm: null, helix_pitch_mm: null, cavity_volume_ml: null, max_principal_stretch: stretch,
    plate_force_N: null, cylinder_force_N: null, max_contact_pressure_kPa: null,
  };
}

function result(path: PathPoint[]): Result {
  return {
    design: {}, scene: {}, rung: "energy", outcome: "converged", advice: null, path, error_estimate_percent: null,
    trusted_to_kPa: null, error_estimates_percent: {}, limit_pressure_kPa: null,
    wall_s: null, unknowns: 0, newton_iterations: 0, effects: [], assumptions: [], notes: [], body_files: null,
  };
}

const answer = result([point(0, 10, 1), point(10, 20), point(20, 40, 1.4)]);
const angle = (each: PathPoint) => each.bending_angle_deg;
const stretch = (each: PathPoint) => each.max_principal_stretch;

describe("reading a path at a pressure", () => {
  it("is exact at its points and linear between them", () => {
    expect(valueAt(answer, 10, angle)).toBe(20);
    expect(valueAt(answer, 15, angle)).toBeCloseTo(30, 12);
  });

  it("knows nothing beyond the path", () => {
    expect(valueAt(answer, 20.1, angle)).toBeNull();
    // the last frame of the 3D view, in six digits
    const limit = result([point(0, 10), point(13.714652010348054, 40)]);
    expect(valueAt(limit, 13.7147, angle)).toBe(40);
    expect(valueAt(result([]), 0, angle)).toBeNull();
  });

  it("never makes a number of an unknown", () => {
    expect(valueAt(answer, 10, stretch)).toBeNull();
    expect(valueAt(answer, 5, stretch)).toBeNull();
    expect(valueAt(answer, 20, stretch)).toBe(1.4);
  });

  it("marks the same place on a curve", () => {
    expect(pointAt(tipPoints(answer), 5)).toEqual({ x: 95, y: -5, at: 5 });
    expect(pointAt(anglePoints(answer), 30)).toBeNull();
  });
});

describe("ranges of plots", () => {
  const curve = { id: "a", label: "", color: "", style: "line" as const, points: tipPoints(answer) };

  it("give a millimetre the same length on both axes", () => {
    const { x, y } = equalRanges([curve], 300, 150);
    expect((x[1] - x[0]) / 300).toBeCloseTo((y[1] - y[0]) / 150, 12);
    expect(x[0]).toBeLessThan(80);
    expect(x[1]).toBeGreaterThan(100);
    expect(y[0]).toBeLessThan(-20);
    expect(y[1]).toBeGreaterThan(0);
  });

  it("begin at zero where all values are positive", () => {
    const { x, y } = freeRanges([{ ...curve, points: anglePoints(answer) }]);
    expect(x).toEqual([0, 20]);
    expect(y[0]).toBe(0);
    expect(y[1]).toBeGreaterThan(40);
  });

  it("exist without any points", () => {
    expect(freeRanges([]).x[1]).toBeGreaterThan(0);
    expect(Number.isFinite(equalRanges([], 100, 100).x[0])).toBe(true);
  });
});

describe("the end of what a model is meant for", () => {
  const points = [0, 2, 4].map((pressure) => ({ x: pressure, y: 10 * pressure, at: pressure }));
  const curve = { id: "c", label: "Instant", color: "--c", points, style: "line" as const };

  it("parts the curve at that very pressure", () => {
    const { within, beyond } = splitAtTrust({ ...curve, trustedTo: 3 });
    expect(within.map((point) => point.at)).toEqual([0, 2, 3]);
    expect(beyond.map((point) => point.at)).toEqual([3, 4]);
    expect(beyond[0]?.y).toBe(30);
  });

  it("goes down with suction", () => {
    const sucked = points.map(({ x, y, at }) => ({ x: -x, y, at: -at }));
    const { within, beyond } = splitAtTrust({ ...curve, points: sucked, trustedTo: -3 });
    expect(within.map((point) => point.at)).toEqual([-0, -2, -3]);
    expect(beyond.map((point) => point.at)).toEqual([-3, -4]);
    const answer = { ...result([point(0, 1), point(-2, 2), point(-4, 3)]), trusted_to_kPa: -3 };
    expect([-1, -3, -3.5].map((at) => isBeyondTrust(answer, at))).toEqual([false, false, true]);
  });

  it("leaves a curve whole that ends before it, or has none", () => {
    expect(splitAtTrust({ ...curve, trustedTo: 4 }).beyond).toEqual([]);
    expect(splitAtTrust({ ...curve, trustedTo: null }).within).toEqual(points);
  });
});
