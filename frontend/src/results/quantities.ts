/** The numbers of a path point that the page lists. */
import type { PathPoint } from "../api/types";

export interface Quantity {
  name: string;
  label: string;
  symbol: string;
  unit: string;
  help: string;
  value: (point: PathPoint) => number | null | undefined;
}

export const BENDING_ANGLE =
  "Bending angle: between X₁ and the straight line from the clamp to the tip point; positive towards the bottom layer.";

export const QUANTITIES: readonly Quantity[] = [
  {
    name: "bending_angle",
    label: "Bending angle",
    symbol: "θ",
    unit: "°",
    help: BENDING_ANGLE,
    value: (point) => point.bending_angle_deg,
  },
  {
    name: "tip_rotation",
    label: "Tip rotation",
    symbol: "φ",
    unit: "°",
    help: "Tip rotation: how far the face at the free end has turned about X₂.",
    value: (point) => point.tip_rotation_deg,
  },
  ...([1, 2, 3] as const).map((axis) => ({
    name: `tip_${axis}`,
    label: `Tip X${["₁", "₂", "₃"][axis - 1] ?? ""}`,
    symbol: "",
    unit: "mm",
    help: "Middle of the free end's bottom edge.",
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
];
