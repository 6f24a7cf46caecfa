/** Chamber density of a slab: the two rows of the source's table for each planform, or one's own.
 * The values are the presets'; nothing is repeated here. */
import type { Preset } from "../api/types";
import { readDesign, type DesignDocument } from "../workbench/document";

export type Density = "low" | "high" | "own";

const DECIDED_BY = ["chamber_count", "root_wall_mm", "tip_wall_mm", "channel_width_mm", "side_wall_mm"];

export function densityValues(
  presets: readonly Preset[],
  planform: string,
  density: "low" | "high",
): DesignDocument | null {
  const preset = presets.find((each) => each.name === `slab-${planform}-${density}`);
  if (!preset) return null;
  const design = readDesign(preset.design);
  return Object.fromEntries(
    DECIDED_BY.flatMap((name) => {
      const value = design[name];
      return value === undefined ? [] : [[name, value]];
    }),
  );
}

export function densityOf(presets: readonly Preset[], design: DesignDocument): Density {
  for (const density of ["low", "high"] as const) {
    const values = densityValues(presets, String(design.planform), density);
    if (values && Object.entries(values).every(([name, value]) => design[name] === value)) return density;
  }
  return "own";
}
