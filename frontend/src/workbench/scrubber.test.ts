import { beforeEach, describe, expect, it } from "vitest";

import { frameIndex, scrubber, scrubToFrame, scrubToPressure, setFrames, shownPressure } from "./scrubber";

describe("scrubber", () => {
  beforeEach(() => {
    scrubber.set({ pressure: null, frames: [], playing: false });
    setFrames([0, 10, 20, 30]);
  });

  it("stands at the end of the path until it is moved, and stays there when the path grows", () => {
    expect(shownPressure(scrubber.get())).toBe(30);
    setFrames([0, 20, 40]);
    expect(shownPressure(scrubber.get())).toBe(40);
  });

  it("keeps its pressure when the frames change", () => {
    scrubToFrame(1);
    setFrames([0, 5, 10, 15]);
    expect(shownPressure(scrubber.get())).toBe(10);
    expect(frameIndex(scrubber.get())).toBe(2);
  });

  it("goes to the end when the path now ends before it", () => {
    scrubToFrame(2);
    setFrames([0, 5]);
    expect(shownPressure(scrubber.get())).toBe(5);
  });

  it("takes the nearest frame of a pressure", () => {
    scrubToPressure(13);
    expect(shownPressure(scrubber.get())).toBe(10);
  });
});
