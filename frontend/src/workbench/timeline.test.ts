import { describe, expect, it } from "vitest";

import type { Work } from "./document";
import { pressureLoads } from "./loads";
import { edit, endGesture, isChanged, redo, replace, saved, start, undo, type Snapshot } from "./timeline";

const work: Work = { name: "Finger", design: { family: "slab", bottom_thickness_mm: 4 }, loads: pressureLoads(40) };
const origin = { kind: "preset", preset: "slab-rectangle-low", title: "Slab" } as const;
const opened: Snapshot = { work, baseline: work, origin };
const thick = (value: number): Work => ({ ...work, design: { ...work.design, bottom_thickness_mm: value } });

describe("timeline", () => {
  it("takes one drag of a slider as one step", () => {
    let line = start(opened);
    for (const [value, now] of [[4.1, 0], [4.2, 16], [4.3, 700], [4.4, 1400]] as const) {
      line = edit(line, thick(value), "bottom_thickness_mm", now);
    }
    expect(line.past).toHaveLength(1);
    expect(undo(line).present.work).toEqual(work);
  });

  it("begins a new step when the slider is let go, rests, or another is moved", () => {
    let line = edit(start(opened), thick(5), "bottom_thickness_mm", 0);
    line = edit(endGesture(line), thick(6), "bottom_thickness_mm", 10);
    line = edit(line, thick(7), "bottom_thickness_mm", 5000);
    line = edit(line, { ...thick(7), loads: pressureLoads(10) }, "pressure", 5001);
    expect(line.past).toHaveLength(4);
  });

  it("redoes what was undone, until something else is edited", () => {
    const edited = edit(start(opened), thick(5), "a", 0);
    const undone = undo(edited);
    expect(redo(undone).present.work).toEqual(thick(5));
    const other = edit(undone, thick(9), "a", 10_000);
    expect(redo(other)).toBe(other);
  });

  it("does nothing at either end", () => {
    const line = start(opened);
    expect(undo(line)).toBe(line);
    expect(redo(line)).toBe(line);
  });

  it("keeps the design before a preset one undo away, with its own baseline", () => {
    const other = thick(8);
    const line = replace(edit(start(opened), thick(5), "a", 0), { work: other, baseline: other, origin });
    expect(isChanged(line.present)).toBe(false);
    expect(undo(line).present.work).toEqual(thick(5));
    expect(isChanged(undo(line).present)).toBe(true);
  });

  it("is unchanged after saving, and changed again after undoing past the save", () => {
    const version = { kind: "version", versionId: "v", designId: "d", number: 1, label: null } as const;
    const line = saved(edit(start(opened), thick(5), "a", 0), version, { ...thick(5), name: "Gripper" });
    expect(isChanged(line.present)).toBe(false);
    const back = undo(line).present;
    expect(back.origin).toEqual(version);
    expect(back.work.name).toBe("Gripper");
    expect(isChanged(back)).toBe(true);
  });

  it("does not count a name as a change of the design", () => {
    expect(isChanged({ ...opened, work: { ...work, name: "Other" } })).toBe(false);
  });
});
