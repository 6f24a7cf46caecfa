import { describe, expect, it } from "vitest";

import type { Preset } from "../api/types";
import { densityOf, densityValues } from "./density";
import { problemInWords } from "./problemInWords";
import { isRelevant } from "./relevance";

function preset(name: string, chambers: number): Preset {
  const design = { family: "slab", planform: "rectangle", chamber_count: chambers, root_wall_mm: 6, tip_wall_mm: 3,
    channel_width_mm: 4, side_wall_mm: 3.5, length_mm: 89 };
  return { name, title: name, description: "", source: "", design, pressure_to_kPa: 40 };
}

const presets = [preset("slab-rectangle-low", 6), preset("slab-rectangle-high", 11)];

describe("density of a slab", () => {
  it("is read off the chambers, whatever the rest is", () => {
    const design = { ...presets[0]?.design, length_mm: 120 } as Record<string, number | string>;
    expect(densityOf(presets, design)).toBe("low");
    expect(densityOf(presets, { ...design, chamber_count: 11 })).toBe("high");
    expect(densityOf(presets, { ...design, chamber_count: 7 })).toBe("own");
  });

  it("sets chambers, channel and walls only", () => {
    expect(densityValues(presets, "rectangle", "high")).toEqual({
      chamber_count: 11, root_wall_mm: 6, tip_wall_mm: 3, channel_width_mm: 4, side_wall_mm: 3.5,
    });
    expect(densityValues(presets, "hexagon", "high")).toBeNull();
  });
});

describe("relevance", () => {
  it("hides what a planform does not use", () => {
    expect(isRelevant("tip_width", { family: "slab", planform: "rectangle" })).toBe(false);
    expect(isRelevant("tip_width", { family: "slab", planform: "triangle" })).toBe(true);
    expect(isRelevant("side_radius", { family: "slab", planform: "ellipse" })).toBe(true);
    expect(isRelevant("theta", { family: "oblique" })).toBe(true);
    expect(isRelevant("layer_height", { family: "printed", layer: "inextensible" })).toBe(true);
    expect(isRelevant("layer_height", { family: "printed", layer: "none" })).toBe(false);
  });
});

describe("a refusal in words", () => {
  const parameters = [{ name: "side_wall", label: "Side wall" }, { name: "length", label: "Length" }];

  it("calls parameters as the page does", () => {
    const problem = { message: "side_wall is 30 mm.", field: "side_wall", value: "30 mm", mend: "Reduce side_wall or other_thing.", kind: "design" as const, changes: [] };
    expect(problemInWords(problem, parameters)).toEqual({
      message: "Side wall is 30 mm.",
      mend: "Reduce side wall or other_thing.",
    });
  });

  it("does not say the mend twice", () => {
    const problem = { message: "length is 5 mm. Raise length.", field: "length", value: "", mend: "Raise length.", kind: "design" as const, changes: [] };
    expect(problemInWords(problem, parameters).mend).toBe("");
    const within = { ...problem, message: "length is missing; raise length.", mend: "Raise length." };
    expect(problemInWords(within, parameters).mend).toBe("");
  });
});
