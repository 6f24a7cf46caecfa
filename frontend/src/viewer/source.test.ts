// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import { sourceOf } from "./source";

const ANSWER = { matches: true };
const OTHER = { matches: false };

describe("source of the 3D view", () => {
  it("turns to the answer of a job that was just run, when it is there", () => {
    expect(sourceOf("newest", null, false)).toBe("instant");
    expect(sourceOf("newest", ANSWER, false)).toBe("fe");
  });

  it("follows the hand again once the design is changed", () => {
    expect(sourceOf("newest", ANSWER, true)).toBe("instant");
    expect(sourceOf("newest", OTHER, false)).toBe("instant");
  });

  it("keeps to what was chosen", () => {
    expect(sourceOf("instant", ANSWER, false)).toBe("instant");
    expect(sourceOf("fe", OTHER, true)).toBe("fe");
    expect(sourceOf("fe", null, false)).toBe("instant");
  });
});
