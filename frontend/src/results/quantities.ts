/** The numbers of a path point that the page lists. */
import type { PathPoint, Result } from "../api/types";

export interface Quantity {
  name: string;
  label: string;
  symbol: string;
  unit: string;
  help: string;
  /** Key of the error estimate that holds for it. */
  estimate?: "tip" | "angle" | "force" | "volume";
  /** Listed only where an answer knows it. */
  rare?: boolean;
  value: (point: PathPoint) => number | null | undefined;
}

export const BENDING_ANGLE =
  "Bending angle: between X₁ and the straight line from the clamp to the tip point; positive towards the bottom layer.";

export const PRESSURE: Quantity = {
  name: "pressure",
  label: "Pressure",
  symbol: "p",
  unit: "kPa",
  help: "Of the air in the cavity, above the air around.",
  value: (point) => point.pressure_kPa,
};

export const QUANTITIES: readonly Quantity[] = [
  {
    name: "bending_angle",
    label: "Bending angle",
    symbol: "θ",
    unit: "°",
    help: BENDING_ANGLE,
    estimate: "angle",
    value: (point) => point.bending_angle_deg,
  },
  {
    name: "tip_rotation",
    label: "Tip rotation",
    symbol: "φ",
    unit: "°",
    help: "Tip rotation: how far the face at the free end has turned about X₂.",
    estimate: "angle",
    value: (point) => point.tip_rotation_deg,
  },
  ...([1, 2, 3] as const).map((axis) => ({
    name: `tip_${axis}`,
    label: `Tip X${["₁", "₂", "₃"][axis - 1] ?? ""}`,
    symbol: "",
    unit: "mm",
    help: "Middle of the free end's bottom edge.",
    estimate: "tip" as const,
    value: (point: PathPoint) => point.tip_mm[axis - 1],
  })),
  {
    name: "curvature",
    label: "Curvature",
    symbol: "κ",
    unit: "1/m",
    help: "Mean curvature of the rod about X2.",
    value: (point) => point.curvature_per_m,
  },
  {
    name: "torsion",
    label: "Torsion",
    symbol: "τ",
    unit: "1/m",
    help: "Right-handed about X1.",
    value: (point) => point.torsion_per_m,
  },
  {
    name: "helix_radius",
    label: "Helix radius",
    symbol: "R",
    unit: "mm",
    help: "Infinite, and shown as a dash, where the rod does not curve.",
    value: (point) => point.helix_radius_mm,
  },
  {
    name: "helix_pitch",
    label: "Helix pitch",
    symbol: "P",
    unit: "mm",
    help: "Advance of the helix in one turn.",
    value: (point) => point.helix_pitch_mm,
  },
  {
    name: "cavity_volume",
    label: "Cavity volume",
    symbol: "V",
    unit: "ml",
    help: "Air enclosed in chambers and channel.",
    estimate: "volume",
    value: (point) => point.cavity_volume_ml,
  },
  {
    name: "max_stretch",
    label: "Largest stretch",
    symbol: "λ",
    unit: "",
    help: "Largest principal stretch anywhere in the rubber.",
    value: (point) => point.max_principal_stretch,
  },
  {
    name: "plate_force",
    label: "Force on plate",
    symbol: "F",
    unit: "N",
    help: "Size of the force between actuator and plate, along the plate's normal.",
    estimate: "force",
    rare: true,
    value: (point) => point.plate_force_N,
  },
  {
    name: "cylinder_force",
    label: "Force on cylinder",
    symbol: "F_c",
    unit: "N",
    help: "Size of the force between actuator and cylinder.",
    estimate: "force",
    rare: true,
    value: (point) => point.cylinder_force_N,
  },
  {
    name: "contact_pressure",
    label: "Contact pressure",
    symbol: "p_c",
    unit: "kPa",
    help: "Largest pressure where surfaces touch.",
    rare: true,
    value: (point) => point.max_contact_pressure_kPa,
  },
];

/** What an answer's notes say of a quantity: the notes that begin with its name. */
export function caveatOf({ notes }: Pick<Result, "notes">, { label }: Pick<Quantity, "label">): string | null {
  const said = notes.filter((note) => note.toLowerCase().startsWith(`the ${label.toLowerCase()} `));
  return said.length > 0 ? said.join(" ") : null;
}
