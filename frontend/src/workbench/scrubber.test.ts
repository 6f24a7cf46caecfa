import { beforeEach, describe, expect, it } from "vitest";

import { frameIndex, scrubber, scrubToFrame, scrubTo, setFrames, shownPlace } from "./scrubber";

describe("scrubber", () => {
  beforeEach(() => {
    scrubber.set({ control: "pressure", at: null, frames: [], playing: false });
    setFrames([0, 10, 20, 30]);
  });

  it("stands at the end of the path until it is moved, and stays there when the path grows", () => {
    expect(shownPlace(scrubber.get())).toBe(30);
    setFrames([0, 20, 40]);
    expect(shownPlace(scrubber.get())).toBe(40);
  });

  it("keeps its pressure when the frames change", () => {
    scrubToFrame(1);
    setFrames([0, 5, 10, 15]);
    expect(shownPlace(scrubber.get())).toBe(10);
    expect(frameIndex(scrubber.get())).toBe(2);
  });

  it("goes to the end when the path now ends before it", () => {
    scrubToFrame(2);
    setFrames([0, 5]);
    expect(shownPlace(scrubber.get())).toBe(5);
  });

  it("takes the nearest frame of a pressure", () => {
    scrubTo(13);
    expect(shownPlace(scrubber.get())).toBe(10);
  });

  it("follows a path of suction, on which pressures fall", () => {
    setFrames([0, -5, -10]);
    expect(shownPlace(scrubber.get())).toBe(-10);
    scrubToFrame(1);
    setFrames([0, -4, -8, -12]);
    expect(shownPlace(scrubber.get())).toBe(-4);
  });

  it("goes to the end when volumes take the place of pressures", () => {
    scrubToFrame(1);
    setFrames([8, 12, 16], "volume");
    expect(shownPlace(scrubber.get())).toBe(16);
  });
});
