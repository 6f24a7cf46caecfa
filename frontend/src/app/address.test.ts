// @vitest-environment jsdom
import { describe, expect, it } from "vitest";

import { formatAddress, parseAddress } from "./address";

const at = (path: string) => parseAddress(new URL(path, "http://studio.local"));

describe("address", () => {
  it("holds the open version and what is compared", () => {
    expect(at("/")).toEqual({ versionId: null, compare: null });
    expect(at("/v/abc")).toEqual({ versionId: "abc", compare: null });
    expect(at("/v/abc?compare=a,b")).toEqual({ versionId: "abc", compare: ["a", "b"] });
    expect(at("/?compare=a")).toEqual({ versionId: null, compare: null });
  });

  it("comes back as it was written", () => {
    for (const path of ["/", "/v/abc", "/v/a%2Fb", "/v/abc?compare=a,b"]) {
      expect(formatAddress(at(path))).toBe(path);
    }
  });
});
