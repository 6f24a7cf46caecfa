// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import type { LadderPoint, Result } from "../api/types";
import type { Work } from "../workbench/document";
import { pressureLoads } from "../workbench/loads";
import type { Drawn } from "./drawn";
import { offInWords } from "./off";

const answered: Work = { name: "Finger", design: { family: "slab" }, loads: pressureLoads(20) };
const path = [0, 10, 20].map((pressure_kPa) => ({ pressure_kPa, cavity_volume_ml: 10 + pressure_kPa, tip_displacement_mm: [0, 0, -pressure_kPa] }));
const typical = [5, 8, 25].map((below) => ({ half_below_percent: below / 2, four_of_five_below_percent: below, source: "Measured." }));

function drawn(change: Partial<Result>, more: Partial<Drawn> = {}): Drawn {
  const result = { rung: "energy", path, trusted_to_kPa: null, error_estimate_percent: null, ...change } as unknown as Result;
  return { result, answered, typical, leftOut: [], totalMs: null, replaced: null, ...more };
}

const tips = (...x3: number[]): Result["path"] =>
  x3.map((z, n) => ({ ...path[n], tip_displacement_mm: [0, 0, z] })) as unknown as Result["path"];

it("says what an error of the whole way means for inflation where weight makes most of it", () => {
  const rod = (moved: Result["path"]) => words(drawn({ rung: "cell-rod", error_estimate_percent: 10, path: moved }), null);
  expect(rod(tips(-36, -35.8, -35.6))).toBe("within 10 % of 3D by its own estimate, up to 900 % of what inflation does");
  expect(rod(tips(-36, -35.9, -35.8))).toBe("within 10 % of 3D by its own estimate, over 1000 % of what inflation does");
  expect(rod(tips(-10, -20, -40))).toBe("within 10 % of 3D by its own estimate");
});

function words(of: Drawn, at: number | null, held: LadderPoint | null = null): string | undefined {
  return offInWords(of, at, "pressure", held)?.text;
}

describe("how far the energy model is off", () => {
  it("is told as designs alike were, here and at the end", () => {
    expect(words(drawn({}), 10)).toBe("typically within 8 % of 3D here, 25 % at 20.0 kPa");
    expect(words(drawn({}), null)).toBe("typically within 25 % of 3D here");
  });

  it("is not told beyond its range, nor where a load is left out", () => {
    expect(words(drawn({ trusted_to_kPa: 12 }), 20)).toBeUndefined();
    expect(words(drawn({ trusted_to_kPa: 12 }), 10)).toBe("typically within 8 % of 3D here, beyond its range at 20.0 kPa");
    expect(words(drawn({}, { leftOut: [{ field: "plate", value: "3 mm" }] as unknown as Drawn["leftOut"] }), 10)).toBeUndefined();
  });
});

describe("how far the cell and rod is off", () => {
  const rod = (change: Partial<Result>) => drawn({ rung: "cell-rod", ...change });

  it("is its own estimate, whatever others of its kind were", () => {
    expect(words(rod({ error_estimate_percent: 5 }), 10)).toBe("within 5 % of 3D by its own estimate");
    expect(words(rod({ error_estimate_percent: 100 }), 10)).toBe("may be anywhere by its own estimate");
    expect(words(rod({}), 10)).toBeUndefined();
  });

  it("leaves what lies beyond its range to the mark that says so", () => {
    const far = rod({ error_estimate_percent: 100, trusted_to_kPa: 12 });
    expect(words(far, 10)).toBe("may be anywhere beyond 12.0 kPa");
    expect(words(far, 20)).toBeUndefined();
  });

  it("is what finite elements measured, where they have", () => {
    const held = { rung: "cell-rod", error_kind: "against best", error_source: "fe 5 %", error_percent: { value: 2.34, low: 0, high: 7 }, compared_at_kPa: 20 } as unknown as LadderPoint;
    expect(words(rod({ error_estimate_percent: 5 }), 10, held)).toBe("2.3 % from FE 5 % at 20.0 kPa");
    expect(words(rod({}), 10, { ...held, error_source: "fe medium mesh" })).toBe("2.3 % from FE medium mesh at 20.0 kPa");
    expect(words(rod({ error_estimate_percent: 5 }), 10, { ...held, error_kind: "own estimate" })).toBe("within 5 % of 3D by its own estimate");
  });
});
