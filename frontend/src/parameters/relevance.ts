/** Parameters that a choice leaves without effect; the family's help texts say the same. */
import type { DesignDocument } from "../workbench/document";

type Rule = (design: DesignDocument) => boolean;

const ONLY_FOR: Record<string, Record<string, Rule>> = {
  slab: {
    tip_width: (design) => design.planform === "triangle",
    side_radius: (design) => design.planform === "ellipse",
  },
  printed: {
    layer_thickness: (design) => design.layer !== "none",
    layer_height: (design) => design.layer !== "none",
  },
};

export function isRelevant(name: string, design: DesignDocument): boolean {
  const rule = ONLY_FOR[String(design.family)]?.[name];
  return rule === undefined || rule(design);
}
