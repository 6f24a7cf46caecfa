// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import { onMesh } from "./RunControl";

describe("a mesh chosen by hand", () => {
  it("has no estimate where it is the coarsest, else the coarsest beside it", () => {
    expect(onMesh("coarse").text).toContain("not estimated");
    for (const mesh of ["medium", "fine", "finest"]) {
      expect(onMesh(mesh).text).toBe("Its error is estimated from the coarsest mesh beside it");
    }
  });
});
