import { describe, expect, it } from "vitest";

import { pressureLoads } from "../workbench/loads";
import { placeInScene } from "./places";

const loads = pressureLoads(12);

describe("where a refusal of the scene belongs", () => {
  it.each([
    ["pressure", "pressure"],
    ["pressure_kPa", "pressure"],
    ["scene.pressure_kPa.to", "pressure"],
    ["volume_ml", "volume"],
    ["outside_pressure_kPa", "outside_pressure"],
    ["tip_force_N", "tip_force"],
    ["plate", "plate.gap"],
    ["plate.gap_mm", "plate.gap"],
    ["plate.normal", "plate.normal"],
    ["cylinder.centre_mm", "cylinder.centre"],
    ["cylinder.radius", "cylinder.radius"],
    ["gravity_m_s2", "gravity"],
    ["effects.gravity", "effects"],
    ["effects", "effects"],
    ["self_contact", "effects"],
  ])("%s is shown at %s", (field, place) => {
    expect(placeInScene(field, loads)).toBe(place);
  });

  it("is at what is in control, for its steps", () => {
    expect(placeInScene("steps", loads)).toBe("pressure");
    expect(placeInScene("steps", { ...loads, control: "volume" })).toBe("volume");
  });

  it("is nowhere in the scene for a parameter of the design", () => {
    expect(placeInScene("roof_thickness", loads)).toBeNull();
  });
});
