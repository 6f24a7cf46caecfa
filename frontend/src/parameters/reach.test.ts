import { describe, expect, it } from "vitest";

import type { Parameter } from "../api/types";
import { alignReach, reachOf } from "./reach";

function parameter(change: Partial<Parameter>): Parameter {
  return {
    name: "length", border_name: "length_mm", label: "Length", symbol: "", group: "Outline", kind: "length",
    unit: "mm", lower: 10, upper: 1000, step: 1, choices: [], help: "", source: "", assumed: "", default: 89,
    ...change,
  };
}

describe("reach of a slider", () => {
  it("spans a window around the opened value, not the whole limits", () => {
    const reach = reachOf(parameter({}), 89, 89);
    expect(reach).toEqual({ min: 22, max: 223, step: 1 });
  });

  it("stays within the limits", () => {
    const reach = reachOf(parameter({ lower: 80, upper: 100 }), 89, 89);
    expect([reach.min, reach.max]).toEqual([80, 100]);
  });

  it("grows to hold a value typed beyond it", () => {
    expect(reachOf(parameter({}), 89, 600).max).toBe(600);
    expect(reachOf(parameter({}), 89, 12).min).toBe(12);
  });

  it("gives an angle its full range", () => {
    const angle = parameter({ kind: "angle", unit: "deg", lower: 15, upper: 90 });
    expect(reachOf(angle, 45, 45)).toEqual({ min: 15, max: 90, step: 1 });
  });

  it("counts whole chambers", () => {
    const count = parameter({ kind: "count", unit: "", lower: 1, upper: 60 });
    const reach = reachOf(count, 6, 6);
    expect([reach.min, reach.max]).toEqual([2, 15]);
  });

  it("works for a dimension opened at zero", () => {
    const reach = reachOf(parameter({ lower: 0, upper: 50, step: 0.1 }), 0, 0);
    expect(reach.min).toBe(0);
    expect(reach.max).toBeGreaterThan(reach.min);
  });

  it("keeps the opened value on the slider's grid", () => {
    const reach = alignReach({ min: 0.3, max: 4, step: 0.05 }, 1.415);
    const steps = (1.415 - reach.min) / reach.step;
    expect(Math.abs(steps - Math.round(steps))).toBeLessThan(1e-6);
    expect(reach.min).toBeGreaterThanOrEqual(0.3);
  });
});
