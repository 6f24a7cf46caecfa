import { describe, expect, it } from "vitest";

import { placeNames, type Placed } from "./labels";

const area = { x: 0, y: 0, width: 300, height: 150 };
const WIDTH = 40;

function box({ x, y, anchor }: Placed) {
  const left = anchor === "start" ? x : anchor === "end" ? x - WIDTH : x - WIDTH / 2;
  return { left, right: left + WIDTH, top: y - 6, bottom: y + 6 };
}

function cover(a: Placed, b: Placed): boolean {
  const [p, q] = [box(a), box(b)];
  return p.left < q.right && q.left < p.right && p.top < q.bottom && q.top < p.bottom;
}

describe("names of points", () => {
  it("stand to the right where there is room", () => {
    expect(placeNames([{ x: 100, y: 70, width: WIDTH, radius: 5 }], area)[0]).toEqual({ x: 108, y: 70, anchor: "start" });
  });

  it("stay inside the plot", () => {
    const [placed] = placeNames([{ x: 290, y: 70, width: WIDTH, radius: 5 }], area);
    expect(placed?.anchor).toBe("end");
  });

  it("cover neither each other nor the other points", () => {
    const points = [
      { x: 100, y: 70, width: WIDTH, radius: 5 },
      { x: 118, y: 72, width: WIDTH, radius: 5 },
      { x: 122, y: 88, width: WIDTH, radius: 5 },
    ];
    const placed = placeNames(points, area);
    for (const one of placed) for (const other of placed) if (one !== other) expect(cover(one, other)).toBe(false);
  });

  it("cover nothing where six points crowd at the edge, two of them ringed", () => {
    const points = [
      [262, 30, 5.5], [270, 34, 5.5], [271, 60, 10], [280, 62, 5.5], [286, 84, 10], [288, 90, 5.5],
    ].map(([x = 0, y = 0, radius = 0]) => ({ x, y, width: WIDTH, radius }));
    const placed = placeNames(points, area);
    for (const one of placed) {
      for (const other of placed) if (one !== other) expect(cover(one, other)).toBe(false);
      const { left, right, top, bottom } = box(one);
      expect(left).toBeGreaterThanOrEqual(0);
      expect(right).toBeLessThanOrEqual(area.width);
      for (const { x, y, radius } of points) {
        expect(left < x + radius && right > x - radius && top < y + radius && bottom > y - radius).toBe(false);
      }
    }
  });
});
