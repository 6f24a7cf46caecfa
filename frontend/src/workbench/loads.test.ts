import { describe, expect, it } from "vitest";

import { choosing, firstCylinder, firstPlate, pressureLoads, readLoads, sameButEnd, sameLoads, sceneOf, type Loads } from "./loads";

const everything: Loads = {
  ...pressureLoads(12),
  gravity: [9.81, 0, 0],
  outsidePressure: 0.1,
  tipForce: [0, 0, 0.05],
  plate: firstPlate(),
  cylinder: firstCylinder(89),
  forced: { self_contact: "off", gravity: "on" },
};

describe("the loads of a scene", () => {
  it("say which effects are chosen by hand, whatever their order", () => {
    const chosen = { ...pressureLoads(12), forced: choosing({ gravity: "off" }, "self_contact", "on") };
    expect(sceneOf(chosen).effects).toEqual({ gravity: "off", self_contact: "on" });
    expect(sameLoads(chosen, { ...chosen, forced: { self_contact: "on", gravity: "off" } })).toBe(true);
    expect(sameLoads(chosen, pressureLoads(12))).toBe(false);
    expect(choosing(chosen.forced, "gravity", "auto")).toEqual({ self_contact: "on" });
    expect(readLoads({ pressure_kPa: { to: 12 }, effects: { gravity: "auto" } }).forced).toEqual({});
  });

  it("come back from their document", () => {
    expect(readLoads(sceneOf(everything))).toEqual(everything);
    const volume: Loads = { ...everything, control: "volume", pressureTo: 30, volumeTo: 40 };
    expect(readLoads(sceneOf(volume))).toEqual(volume);
  });

  it("write nothing of what is not there", () => {
    expect(Object.keys(sceneOf(pressureLoads(12)))).toEqual(["pressure_kPa", "gravity_m_s2"]);
  });

  it("read versions saved before there was more than pressure and gravity", () => {
    expect(readLoads({ pressure_kPa: { to: 12, steps: "auto" }, gravity_m_s2: null })).toEqual({
      ...pressureLoads(12),
      gravity: null,
    });
    expect(readLoads({ pressure_kPa: { to: 12 } })).toEqual(pressureLoads(12));
  });

  it("are the same question whatever the length of a direction, or a load of nothing", () => {
    const long = { ...everything, plate: { gap: 5, normal: [0, 0, 2] as const } };
    expect(sameLoads(long, everything)).toBe(true);
    expect(sameLoads({ ...everything, plate: { gap: 6, normal: [0, 0, 1] } }, everything)).toBe(false);
    expect(sameLoads({ ...pressureLoads(12), tipForce: [0, 0, 0] }, pressureLoads(12))).toBe(true);
  });

  it("differ in their end only, or in more", () => {
    expect(sameButEnd(pressureLoads(12), { ...pressureLoads(20), control: "volume", volumeTo: 9 })).toBe(true);
    expect(sameButEnd(pressureLoads(12), everything)).toBe(false);
  });
});
