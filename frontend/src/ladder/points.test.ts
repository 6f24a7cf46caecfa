// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import type { Ladder, LadderPoint } from "../api/types";
import { beside } from "./Picks";
import { about, actionOf, isEarly, listed, placeOf, plotted, rungName, standing } from "./points";

const range = (value: number, low = value, high = value) => ({ value, low, high });

function point(change: Partial<LadderPoint>): LadderPoint {
  return {
    rung: "fe", accuracy_percent: 5, mesh: null, label: "fe 5 %", state: "predicted", seconds: range(12, 6, 25),
    error_percent: range(5, 0, 5), error_kind: "asked for", error_source: null, apart_percent: null, compared_at_kPa: null,
    is_best: false, outcome: null, advice: null, reason: null, same_as: null, tip_displacement_mm: null, ends_at_kPa: null,
    leaves_out: [], is_older: false, job_id: null, ...change,
  };
}

const energy = point({
  rung: "energy", label: "energy", accuracy_percent: null, state: "measured", outcome: "converged", seconds: range(0.01),
  error_percent: range(8, 6, 10), error_kind: "against best", error_source: "fe 10 %", compared_at_kPa: 12, leaves_out: ["contact"],
});
const refused = point({ rung: "closed-form", label: "closed-form", state: "refused", seconds: null, error_percent: null, error_kind: null, reason: "plate is 5 mm away" });
const best = point({ label: "fe 10 %", accuracy_percent: 10, state: "measured", outcome: "converged", is_best: true, error_kind: "own estimate" });
const repeated = point({ same_as: "fe 10 %" });
const ladder: Ladder = {
  design: {}, scene: {}, points: [refused, energy, best, repeated], best: "fe 10 %", expected_strain_percent: 30,
  learned_from_jobs: 0, choices: [],
};

describe("points of the ladder", () => {
  it("are drawn where both numbers are known, once for each answer", () => {
    expect(plotted(ladder).map((each) => each.label)).toEqual(["energy", "fe 10 %"]);
    expect(listed(ladder).map((each) => each.label)).toEqual(["closed-form"]);
  });

  it("say time, error with its band, and what is left out", () => {
    const words = about(energy, []).join(" ");
    expect(words).toContain("8 % from the best answer so far (FE 10 %) at 12 kPa");
    expect(words).toContain("at most 10 %");
    expect(words).toContain("10 ms, measured");
    expect(words).toContain("Leaves out: contact.");
    expect(about(point({}), []).join(" ")).toContain("about 12 s, four of five jobs between 6 s and 25 s");
  });

  it("say that the cell and rod may be anywhere where its estimate is all of the way", () => {
    const rod = (value: number) => about(point({ rung: "cell-rod", state: "measured", error_kind: "own estimate", error_percent: range(value) }), [])[0];
    expect(rod(5)).toBe("Tip's error: at most 5 % by its own estimate.");
    expect(rod(100)).toBe("Tip's error: it may be anywhere by its own estimate.");
    const picked = point({ rung: "cell-rod", state: "measured", seconds: range(1), error_kind: "own estimate", error_percent: range(100) });
    expect(beside("seconds", picked).replaceAll("\u00a0", " ")).toBe("may be anywhere, there already, 1 s");
  });

  it("say why one is refused, and name a failed job as one to be run again", () => {
    expect(about(refused, [])).toEqual(["Plate is 5 mm away."]);
    expect(actionOf(refused)).toBe("");
    expect(actionOf(point({ state: "refused", reason: "no equilibrium" }))).toBe("Click to run it again");
    expect(actionOf(point({ job_id: "j" }))).toBe("Is being computed");
  });

  it("are named beside a limit, and whether their answer is there already", () => {
    const words = (limit: "percent" | "seconds", change: Partial<LadderPoint>) => beside(limit, point(change)).replaceAll("\u00a0", " ");
    expect(words("percent", {})).toBe("~ 12 s (to 25 s)");
    expect(words("seconds", {})).toBe("up to 5 %, ~ 12 s (to 25 s)");
    expect(words("percent", { seconds: { value: 12, low: 10, high: 15 } })).toBe("~ 12 s");
    const there = { state: "measured", seconds: range(46), error_percent: range(3, 0, 3) } as const;
    expect(words("percent", there)).toBe("there already, 46 s");
    expect(words("seconds", there)).toBe("up to 3 %, there already, 46 s");
    expect(words("seconds", { same_as: "fe 10 %", seconds: range(9), error_percent: range(1, 0, 1) })).toBe("up to 1 %, there already, 9 s");
  });

  it("of an earlier question promise no answer", () => {
    expect(actionOf(best)).toBe("Click to show its answer");
    expect(actionOf(best, true)).toBe("Click to run it");
    expect(actionOf(energy, true)).toBe("Click to draw it");
  });

  it("say that an answer ended early, and how to go on", () => {
    const stalled = point({ state: "measured", outcome: "stalled", advice: "Take a coarser mesh." });
    expect(about(stalled, []).join(" ")).toContain("Stopped early: no equilibrium was found beyond the last point. Take a coarser mesh.");
    const limit = point({ state: "measured", outcome: "limit_point", ends_at_kPa: 12.37 });
    const cut = point({ outcome: "cancelled", ends_at_kPa: 3.2 });
    expect([limit, stalled, cut, best, point({})].map(standing)).toEqual([
      "measured, up to its limit at 12.4 kPa", "stalled", "cancelled at 3.2 kPa", "measured", "predicted",
    ]);
    expect(about(limit, []).join(" ")).toContain("Reached a limit point");
    expect(about(cut, []).join(" ")).toContain("Time of the whole path: about 12 s");
    expect([limit, stalled, cut].map(isEarly)).toEqual([false, true, true]);
  });

  it("are drawn though nobody can tell their error, at their measured seconds", () => {
    const coarse = point({ state: "measured", outcome: "converged", mesh: "coarse", label: "fe coarse mesh", error_percent: null, error_kind: null, seconds: range(7) });
    expect(plotted({ ...ladder, points: [coarse] })).toEqual([coarse]);
    expect(placeOf(coarse)).toEqual({ seconds: 7, error: null });
    expect(about(coarse, [])[0]).toBe("Tip's error: not known, for one mesh by itself cannot tell it.");
  });

  it("have names for people", () => {
    expect([energy, best, point({ rung: "cell-rod", label: "cell-rod" })].map(rungName)).toEqual(["Energy", "3D FE 10 %", "Cell + rod"]);
  });
});
