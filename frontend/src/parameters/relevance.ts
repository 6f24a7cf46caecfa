/** Parameters that a choice leaves without effect; the family's help texts say the same. */
import type { DesignDocument } from "../workbench/document";

const ONLY_FOR: Record<string, (design: DesignDocument) => boolean> = {
  tip_width: (design) => design.planform === "triangle",
  side_radius: (design) => design.planform === "ellipse",
};

export function isRelevant(name: string, design: DesignDocument): boolean {
  const rule = ONLY_FOR[name];
  return rule === undefined || design.family !== "slab" || rule(design);
}
