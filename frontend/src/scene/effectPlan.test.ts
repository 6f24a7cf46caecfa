// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import type { EffectDecision } from "../api/types";
import { isThere } from "./effectPlan";

const none: EffectDecision = {
  name: "tip_force", on: false, reason: "the scene has none", estimated_change_percent: 0, cost_s: null,
  cost_factor: null, forced: "auto", watched: false,
};

describe("effects of a question", () => {
  it("are there when on, watched, chosen by hand, or left out though they change something", () => {
    expect(isThere(none)).toBe(false);
    expect(isThere({ ...none, on: true })).toBe(true);
    expect(isThere({ ...none, watched: true })).toBe(true);
    expect(isThere({ ...none, forced: "off" })).toBe(true);
    expect(isThere({ ...none, estimated_change_percent: 0.4, cost_factor: 1.15 })).toBe(true);
  });
});
