import { describe, expect, it } from "vitest";

import { formatPercent } from "../ui/numbers";
import { decades, logScale, marks, shortSeconds, timeMarks } from "./scale";

describe("logarithmic axes", () => {
  it("span whole decades around the values, at least two", () => {
    expect(decades([0.02, 45], 1e-3).map(Math.log10).map(Math.round)).toEqual([-2, 2]);
    expect(decades([1], 1e-3)).toEqual([1, 100]);
    expect(decades([10, 100], 1e-3)).toEqual([10, 1000]);
    expect(decades([0, 3], 0.01)[0]).toBeCloseTo(0.01, 12);
    expect(decades([], 0.01)).toEqual([0.01, 1]);
  });

  it("give every factor of ten the same length, and keep what lies beyond at the ends", () => {
    const scale = logScale([0.01, 100], 40, 240);
    expect(scale.place(1) - scale.place(0.1)).toBeCloseTo(scale.place(100) - scale.place(10), 9);
    expect(scale.place(0)).toBeCloseTo(40, 9);
    expect(scale.place(1e6)).toBeCloseTo(240, 9);
  });

  it("mark decades, leaving out evenly where there is no room", () => {
    expect(marks({ low: 1, high: 1000 }, 10)).toEqual([1, 10, 100, 1000]);
    expect(marks({ low: 1e-3, high: 1e3 }, 4).map(Math.log10).map(Math.round)).toEqual([-3, -1, 1, 3]);
  });

  it("mark times in the units that people count in", () => {
    const texts = (low: number, high: number, most: number) => timeMarks({ low, high }, most).map(({ text }) => text);
    expect(texts(1, 1e5, 10)).toEqual(["1 s", "10 s", "1 min", "10 min", "1 h", "10 h"]);
    expect(texts(1e-3, 1e5, 5)).toEqual(["1 ms", "0.1 s", "10 s", "10 min", "10 h"]);
    for (const { at, text } of timeMarks({ low: 1e-3, high: 10 }, 10)) expect(shortSeconds(at)).toBe(text);
  });

  it("write times and errors with their units", () => {
    expect([0.004, 0.1, 12.34, 99.4, 150, 7200].map(shortSeconds)).toEqual(["4 ms", "0.1 s", "12 s", "99 s", "2.5 min", "2 h"]);
    expect([0, 0.004, 0.5, 12.6, 99.7, 128.4, 34000].map(formatPercent)).toEqual(["0 %", "below 0.01 %", "0.5 %", "13 %", "100 %", "130 %", "over 1000 %"]);
  });
});
