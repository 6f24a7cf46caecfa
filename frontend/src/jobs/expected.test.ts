// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import { isLate } from "./expected";

const expected = { value: 1.3, low: 0.99, high: 10 };

describe("a running job", () => {
  it("is late once the upper end of what was expected is passed, and only while it runs", () => {
    expect(isLate({ state: "running" }, 9.9, expected)).toBe(false);
    expect(isLate({ state: "running" }, 10.1, expected)).toBe(true);
    expect(isLate({ state: "done" }, 82, expected)).toBe(false);
    expect(isLate({ state: "running" }, null, expected)).toBe(false);
    expect(isLate({ state: "running" }, 82, null)).toBe(false);
  });
});
