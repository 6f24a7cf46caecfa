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
});
