import { describe, expect, it } from "vitest";

import type { Drawing } from "../api/types";
import { namePlate, placeLabel } from "./label";
import { layOut, toPixel } from "./layout";

const drawing: Drawing = {
  unit: "mm",
  views: {
    section: { title: "", horizontal: "X1", vertical: "X3", bounds: [-8, -3, 92, 19], shapes: [] },
    planform: { title: "", horizontal: "X1", vertical: "X2", bounds: [-8, -30, 97, 30], shapes: [] },
  },
  dimensions: [],
  regions: [],
};

describe("drawing", () => {
  it("puts both views at one scale over one X1 axis, inside the picture", () => {
    const { scale, views } = layOut(drawing, 340, 180);
    const [section, planform] = views;
    if (!section || !planform) throw new Error("two views expected");
    expect(section.name).toBe("section");
    expect(toPixel(section, scale, [50, 0])[0]).toBeCloseTo(toPixel(planform, scale, [50, 0])[0], 9);
    for (const placed of views) {
      const [left, bottom, right, top] = placed.view.bounds;
      const [x0, y0] = toPixel(placed, scale, [left ?? 0, top ?? 0]);
      const [x1, y1] = toPixel(placed, scale, [right ?? 0, bottom ?? 0]);
      expect(x0).toBeGreaterThanOrEqual(0);
      expect(x1).toBeLessThanOrEqual(340);
      expect(y0).toBeGreaterThanOrEqual(0);
      expect(y1).toBeLessThanOrEqual(180);
    }
    expect(toPixel(planform, scale, [0, 30])[1]).toBeGreaterThan(toPixel(section, scale, [0, -3])[1]);
  });

  it("writes a dimension beside its line, away from the body and inside the picture", () => {
    const bounds = { width: 340, height: 180 };
    const left = placeLabel([100, 40], [100, 80], "h1 = 4 mm", bounds, [120, 40]);
    expect(left.x + left.width / 2).toBeLessThan(100);
    const edge = placeLabel([20, 40], [20, 80], "h1 = 4 mm", bounds, [90, 40]);
    expect(edge.x - edge.width / 2).toBeGreaterThanOrEqual(0);
    expect(edge.y).toBeGreaterThan(80);
    const inner = placeLabel([100, 40], [100, 44], "2 mm", bounds, [100, 40]);
    expect(inner.x - inner.width / 2).toBeGreaterThan(100);
    const below = placeLabel([40, 176], [300, 176], "89 mm", bounds, [40, 120]);
    expect(below.y).toBeLessThan(180);
    const plate = namePlate(4);
    const roof = placeLabel([50, 8], [50, 24], "6 mm", bounds, [62, 8], [plate]);
    expect(roof.y - 8.5).toBeGreaterThanOrEqual(plate.bottom);
    const root = placeLabel([40, 30], [58, 30], "6 mm", bounds, [40, 60], [plate]);
    expect(root.x - root.width / 2).toBeGreaterThanOrEqual(plate.right);
  });
});
