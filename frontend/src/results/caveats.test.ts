// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import type { Result } from "../api/types";
import { caveatOf, QUANTITIES } from "./quantities";
import { beyondInWords } from "./words";

const NOTE = "The largest stretch has no error estimate: it sits at the inner edges of the chambers.";

describe("what must be read beside a number", () => {
  it("is what the answer's notes say of it", () => {
    const result = { notes: ["Ecoflex 00-30 is stretched to 4.06.", NOTE] };
    const said = Object.fromEntries(QUANTITIES.map((quantity) => [quantity.name, caveatOf(result, quantity)]));
    expect(said.max_stretch).toBe(NOTE);
    expect(Object.values(said).filter((note) => note !== null)).toHaveLength(1);
  });

  it("is that the model's range ends before the place", () => {
    const path = [0, 10, 20].map((pressure_kPa) => ({ pressure_kPa, cavity_volume_ml: 10 + pressure_kPa }));
    const result = { rung: "energy", trusted_to_kPa: 8, path } as unknown as Result;
    expect(beyondInWords(result, 7, "pressure")).toBeUndefined();
    expect(beyondInWords(result, 12, "pressure")).toBe("Beyond the range of energy (8.0 kPa): its assumptions do not hold here");
    expect(beyondInWords(result, 25, "volume")).toContain("(18.0 ml)");
    expect(beyondInWords({ ...result, trusted_to_kPa: null }, 12, "pressure")).toBeUndefined();
  });
});
