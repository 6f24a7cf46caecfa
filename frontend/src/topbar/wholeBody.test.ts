import { describe, expect, it } from "vitest";

import { wholeBody } from "./wholeBody";

const result = { design: { family: "slab", name: "it's" }, scene: { pressure_kPa: { to: 40 } } };

describe("the command for fields of the whole body", () => {
  it("holds design, scene and mesh or accuracy, quoted for a shell", () => {
    expect(wholeBody({ mesh: "coarse", accuracy: 0.05 }, result)).toBe(
      String.raw`pneustudio export <(echo '{"family":"slab","name":"it'\''s"}') --scene <(echo '{"pressure_kPa":{"to":40}}') --mesh coarse --what vtu --to fields`,
    );
    expect(wholeBody({ mesh: null, accuracy: 0.07 }, result)).toContain("--accuracy 7% --what vtu");
  });
});
