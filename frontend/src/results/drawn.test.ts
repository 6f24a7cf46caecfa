// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import type { Prediction, Result } from "../api/types";
import type { Answers } from "../workbench/answers";
import type { Work } from "../workbench/document";
import { pressureLoads } from "../workbench/loads";
import type { Refined } from "../workbench/refined";
import { drawnOf } from "./drawn";

const work: Work = { name: "Finger", design: { family: "slab" }, loads: pressureLoads(12) };
const moved: Work = { ...work, loads: pressureLoads(13) };

function result(rung: string): Result {
  return { rung, path: [{}, {}] } as unknown as Result;
}

const now = { result: result("energy"), answered: work, instantProblem: null, typical: [], totalMs: 9 } as unknown as Answers;
const prediction = { result: result("cell-rod"), typical_errors: [], timings_ms: { total: 400 } } as unknown as Prediction;
const finer: Refined = { prediction, answered: work, problem: null, asking: false };

describe("the instant answer that is drawn", () => {
  it("is the cell and rod once it is there, over the paler energy curve", () => {
    const drawn = drawnOf(now, finer, work, "auto");
    expect([drawn?.result.rung, drawn?.replaced?.rung, drawn?.totalMs]).toEqual(["cell-rod", "energy", 400]);
  });

  it("is the energy model again as soon as the question differs", () => {
    expect(drawnOf(now, finer, moved, "auto")).toMatchObject({ result: { rung: "energy" }, replaced: null });
  });

  it("is what was chosen by hand", () => {
    expect(drawnOf(now, finer, work, "energy")?.result.rung).toBe("energy");
  });

  it("is the cell and rod alone where the energy model has no answer, and nothing without both", () => {
    const without = { ...now, instantProblem: { message: "", field: "", value: "", mend: "", kind: "question" } } as Answers;
    expect(drawnOf(without, finer, work, "auto")).toMatchObject({ result: { rung: "cell-rod" }, replaced: null });
    expect(drawnOf(without, finer, moved, "auto")).toBeNull();
  });
});
