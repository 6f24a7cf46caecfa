import type { DesignCheck } from "../api/types";

/** One tone for each region's part in the body: the layer below, and what stands on it. */
export function toneOf(check: DesignCheck, region: string | null): string {
  const index = check.drawing.regions.findIndex((each) => each.name === region);
  return ["stiff", "soft"][index] ?? "air";
}
