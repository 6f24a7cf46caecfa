import { describe, expect, it } from "vitest";

import type { PathPoint, Result } from "../api/types";
import { anglePoints, trustedPlace, valueAt } from "../charts/curve";
import { reached, within } from "./reached";
import { earlyEnd } from "./words";

function result(path: [pressure: number, volume: number][], trusted: number | null = null): Result {
  const points = path.map(
    ([pressure, volume]): PathPoint => ({
      pressure_kPa: pressure, tip_mm: [0, 0, 0], tip_displacement_mm: [0, 0, 0], tip_rotation_deg: null,
      bending_angle_deg: volume, curvature_per_m: null, torsion_per_m: null, helix_radius_mm: null,
      helix_pitch_mm: null, cavity_volume_ml: volume, max_principal_stretch: null, plate_force_N: null,
      cylinder_force_N: null, max_contact_pressure_kPa: null,
    }),
  );
  return {
    design: {}, scene: {}, rung: "fe", outcome: "converged", advice: null, path: points, error_estimate_percent: null,
    error_estimates_percent: {}, limit_pressure_kPa: null, trusted_to_kPa: trusted, wall_s: null, unknowns: 0,
    newton_iterations: 0, effects: [], assumptions: [], notes: [], body_files: null,
  };
}

/** Through a limit pressure of 12 kPa and down again. */
const through = result([[0, 10], [8, 20], [12, 40], [11, 50]], 8);

describe("the place on a path", () => {
  it("is a volume where pressures come twice", () => {
    expect(reached(through, "volume")).toBe(50);
    expect(anglePoints(through, "volume").map((point) => point.at)).toEqual([10, 20, 40, 50]);
    expect(valueAt(through, 45, (point) => point.pressure_kPa, "volume")).toBeCloseTo(11.5, 12);
    expect(trustedPlace(through, "volume")).toBe(20);
  });

  it("ends at the highest pressure, and under suction at the lowest", () => {
    expect(reached(through, "pressure")).toBe(12);
    expect(reached(result([[0, 10], [-5, 8]]), "pressure")).toBe(-5);
  });

  it("ends at the smallest volume where a cavity is emptied", () => {
    const emptied = { ...result([[0.1, 6], [-3, 4], [-9, 1.2]]), outcome: "limit_point" };
    expect(reached(emptied, "volume")).toBe(1.2);
    expect(earlyEnd(emptied, 0.5, "volume")).toContain("found down to 1.20 of 0.50 ml");
  });

  it("beyond the end is the end", () => {
    expect(within(through, 30, "pressure")).toBe(12);
    expect(within(through, 3, "pressure")).toBe(3);
    expect(within(result([[0, 10], [-5, 8]]), -9, "pressure")).toBe(-5);
    expect(within(result([]), 3, "pressure")).toBe(3);
  });
});
