// @vitest-environment jsdom
import { beforeEach, describe, expect, it } from "vitest";

import type { Work } from "./document";
import { pressureLoads } from "./loads";
import { clearSlot, readSlot, slotOf, writeSlot } from "./slots";
import { edit, start } from "./timeline";

const work: Work = { name: "Finger", design: { family: "slab", length_mm: 89 }, loads: pressureLoads(40) };
const opened = start({ work, baseline: work, origin: { kind: "preset", preset: "p", title: "P" } });

describe("slots", () => {
  beforeEach(() => localStorage.clear());

  it("bring back the design and the steps that led to it", () => {
    const line = edit(opened, { ...work, design: { ...work.design, length_mm: 95 } }, "length_mm", 0);
    writeSlot(slotOf("v1"), line);
    expect(readSlot("v1")).toEqual({ ...line, gesture: null });
    expect(readSlot(slotOf(null))).toBeNull();
  });

  it("forget what was cleared", () => {
    writeSlot("v1", opened);
    clearSlot("v1");
    expect(readSlot("v1")).toBeNull();
  });

  it("begin anew when the stored text is not theirs", () => {
    localStorage.setItem("pneustudio.work.2:v1", "{broken");
    expect(readSlot("v1")).toBeNull();
    localStorage.setItem("pneustudio.work.2:v1", '{"present":{"work":{},"baseline":{}}}');
    expect(readSlot("v1")).toBeNull();
  });

  it("bring over the one effect that an earlier page let choose", () => {
    const earlier = { ...work, loads: { ...work.loads, forced: undefined, selfContact: "off" } };
    const snapshot = { work: earlier, baseline: work, origin: opened.present.origin };
    localStorage.setItem("pneustudio.work.2:v1", JSON.stringify({ present: snapshot, past: [], future: [], gesture: null }));
    expect(readSlot("v1")?.present.work.loads).toEqual({ ...pressureLoads(40), forced: { self_contact: "off" } });
  });

  it("bring over what an earlier page kept: a pressure, and gravity or none", () => {
    const earlier = { name: "Finger", design: { family: "slab" }, pressureTo: 12, gravity: false };
    const snapshot = { work: earlier, baseline: { ...earlier, gravity: true }, origin: opened.present.origin };
    localStorage.setItem("pneustudio.work.2:v1", JSON.stringify({ present: snapshot, past: [], future: [], gesture: null }));
    const { work: now, baseline } = readSlot("v1")?.present ?? opened.present;
    expect(now.loads).toEqual({ ...pressureLoads(12), gravity: null });
    expect(baseline.loads).toEqual(pressureLoads(12));
  });
});
