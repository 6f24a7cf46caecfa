/** Entries of a scene as the page shows them, and where a refusal belongs. */
import type { Loads } from "../workbench/loads";

const LABELS = {
  control: "Inflate by",
  pressure: "Pressure to",
  volume: "Volume to",
  gravity: "Gravity",
  outside_pressure: "Outside pressure",
  tip_force: "Tip force",
  "plate.gap": "Plate, gap",
  "plate.normal": "Plate, side",
  "cylinder.radius": "Cylinder, radius",
  "cylinder.centre": "Cylinder, centre",
  "cylinder.axis": "Cylinder, axis",
  effects: "Effects",
} as const;

export type ScenePlace = keyof typeof LABELS;

const PLACES = Object.keys(LABELS) as ScenePlace[];

/** "scene.plate.gap_mm" is "plate.gap"; null for what is no entry of a scene. */
export function placeInScene(field: string, loads: Loads): ScenePlace | null {
  const path = field
    .replace(/^scene\./, "")
    .replace(/_(kPa|ml|mm|N|m_s2)(?=\.|$)/g, "")
    .replace(/\.to$/, "");
  if (path === "steps") return loads.control;
  if (path === "plate") return "plate.gap";
  if (path === "cylinder") return "cylinder.centre";
  if (path.startsWith("effects") || path === "self_contact") return "effects";
  return PLACES.find((place) => place === path) ?? null;
}

export function labelOf(place: ScenePlace): string {
  return LABELS[place];
}
