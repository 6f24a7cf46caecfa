import { describe, expect, it } from "vitest";

import type { PathPoint, Result } from "../api/types";
import { QUANTITIES, type Quantity } from "./quantities";
import { uncertainty } from "./uncertainty";

function point(pressure: number, part: Partial<PathPoint>): PathPoint {
  return {
    pressure_kPa: pressure, tip_mm: [90, 0, 0], tip_displacement_mm: [0, 0, 0], tip_rotation_deg: 0, bending_angle_deg: 0,
    curvature_per_m: null, torsion_per_m: null, helix_radius_mm: null, helix_pitch_mm: null, cavity_volume_ml: 20,
    max_principal_stretch: null, plate_force_N: null, cylinder_force_N: null, max_contact_pressure_kPa: null, ...part,
  };
}

const answer: Result = {
  design: {}, scene: {}, rung: "fe", outcome: "converged", advice: null, error_estimate_percent: 2, limit_pressure_kPa: null,
  path: [
    point(0, {}),
    point(10, {
      tip_mm: [60, 0, -40], tip_displacement_mm: [-30, 0, -40], tip_rotation_deg: 50, cavity_volume_ml: 25, plate_force_N: 0.5,
    }),
  ],
  error_estimates_percent: { tip: 2, angle: 4, volume: 10, force: 6 }, trusted_to_kPa: null, wall_s: null, unknowns: 0,
  newton_iterations: 0, effects: [], assumptions: [], notes: [], body_files: null,
};

function named(name: string): Quantity {
  const found = QUANTITIES.find((quantity) => quantity.name === name);
  if (found === undefined) throw new Error(`no quantity ${name}`);
  return found;
}

describe("an estimated error", () => {
  it.each([
    ["tip_1", 10, 1.0],
    ["tip_3", 10, 1.0],
    ["tip_3", 5, 0.5],
    ["tip_rotation", 10, 2.0],
    ["cavity_volume", 10, 0.5],
    ["plate_force", 10, 0.03],
  ])("of %s at %d kPa is a share of the way to it, in its own unit", (name, place, size) => {
    expect(uncertainty(answer, named(name), place, "pressure")?.size).toBeCloseTo(size, 12);
  });

  it("is told of the cell and rod's force as well, however large it is", () => {
    const rod: Result = { ...answer, rung: "cell-rod", error_estimates_percent: { tip: 5, force: 110 } };
    expect(uncertainty(rod, named("plate_force"), 10, "pressure")).toMatchObject({ of: "the force", percent: 110 });
    expect(uncertainty(rod, named("tip_rotation"), 10, "pressure")).toBeNull();
  });

  it("is not told of what rounding leaves of a zero", () => {
    const path = answer.path.map((each) => ({ ...each, tip_mm: [90, -8e-16, 0] }));
    expect(uncertainty({ ...answer, path }, named("tip_2"), 10, "pressure")).toBeNull();
  });

  it("is told of no place beyond the answer's range", () => {
    const short = { ...answer, trusted_to_kPa: 6 };
    expect(uncertainty(short, named("tip_rotation"), 5, "pressure")?.size).toBeCloseTo(1, 12);
    expect(uncertainty(short, named("tip_rotation"), 10, "pressure")).toBeNull();
  });

  it("is not known of what symmetry keeps at 0, nor of what is not estimated", () => {
    expect(uncertainty(answer, named("tip_2"), 10, "pressure")).toBeNull();
    expect(uncertainty(answer, named("curvature"), 10, "pressure")).toBeNull();
  });
});
