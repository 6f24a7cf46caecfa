import { describe, expect, it } from "vitest";

import { decimalsOf, formatNumber, formatQuantity, formatSeconds, formatUncertainty, grouped, parseNumber, sentence } from "./numbers";
import { parseQuantity } from "./quantity";
import { subscript, symbolParts } from "./symbols";

describe("numbers", () => {
  it("have their thousands apart from ten thousand on, and no powers of ten below ten million", () => {
    expect(formatQuantity(10000)).toBe("10\u202f000");
    expect(formatQuantity(-1234567)).toBe("−1\u202f234\u202f567");
    expect(formatQuantity(9999)).toBe("9999");
    expect(grouped("115.34567")).toBe("115.34567");
    expect(grouped("10000.5")).toBe("10\u202f000.5");
  });

  it("show at least one digit of what they may be off by, and as many decimals themselves", () => {
    const sizes = [0, 4e-6, 0.0004, 0.0052, 0.0301, 0.27, 0.97, 1.04, 9.97, 12.3, 340];
    expect(sizes.map(formatUncertainty)).toEqual(["0", "< 0.0001", "0.0004", "0.005", "0.03", "0.3", "1.0", "1.0", "10", "12", "340"]);
    expect(formatQuantity(0.2741, 4, decimalsOf(0.0052))).toBe("0.274");
    expect(formatQuantity(86.0412, 4, decimalsOf(0.0052))).toBe("86.041");
  });

  it("are read with point or comma, and nothing else is a number", () => {
    expect(parseNumber(" 7,3 ")).toBe(7.3);
    expect(parseNumber("-.5")).toBe(-0.5);
    for (const text of ["", "4 mm", "1.2.3", "Infinity", "0x10", "1e999"]) expect(parseNumber(text)).toBeNull();
  });

  it("may carry a unit of the field's kind", () => {
    expect(parseQuantity("12 cm", "mm")).toBe(120);
    expect(parseQuantity("0.1m", "mm")).toBe(100);
    expect(parseQuantity("4 mm", "mm")).toBe(4);
    expect(parseQuantity("2 bar", "kPa")).toBe(200);
    expect(parseQuantity("500 Pa", "kPa")).toBe(0.5);
    expect(parseQuantity("45°", "deg")).toBe(45);
    expect(parseQuantity("0.5 rad", "deg")).toBeCloseTo(28.6479, 4);
    for (const text of ["2 kPa", "4 mm mm", "cm", "12 furlongs", "NaN", "3 constructor"]) {
      expect(parseQuantity(text, "mm")).toBeNull();
    }
    expect(parseQuantity("6 mm", "")).toBeNull();
  });

  it("are written without what floating point leaves behind", () => {
    expect(formatNumber(7.300000000000001)).toBe("7.3");
    expect(formatNumber(107)).toBe("107");
  });

  it("keep their digits by size", () => {
    expect(formatQuantity(12.3456)).toBe("12.3");
    expect(formatQuantity(-0.01234, 4)).toBe("−0.012");
    expect(formatQuantity(-2.9e-11, 4)).toBe("0.000");
    expect(formatQuantity(12345678)).toBe("1.23e+7");
  });

  it("show what is not known as a dash, never as zero", () => {
    expect(formatQuantity(null)).toBe("—");
    expect(formatQuantity(undefined)).toBe("—");
    expect(formatQuantity(Number.NaN)).toBe("—");
    expect(formatQuantity(0)).toBe("0.00");
  });

  it("say times as one speaks of them", () => {
    expect(formatSeconds(3.21)).toBe("3.2 s");
    expect(formatSeconds(59.4)).toBe("59 s");
    expect(formatSeconds(125)).toBe("2 min 05 s");
    expect(formatSeconds(3720)).toBe("1 h 02 min");
  });

  it("make sentences", () => {
    expect(sentence("the scene has it")).toBe("The scene has it.");
  });
});

describe("symbols", () => {
  it("have their subscripts and Greek letters", () => {
    expect(symbolParts("h1")).toEqual([{ base: "h", sub: "1" }]);
    expect(symbolParts("w_o")).toEqual([{ base: "w", sub: "o" }]);
    expect(symbolParts("theta")).toEqual([{ base: "θ", sub: "" }]);
    expect(symbolParts("h2/h1").map((part) => part.sub)).toEqual(["2", "1"]);
    expect(symbolParts("n")).toEqual([{ base: "n", sub: "" }]);
    expect(subscript("12")).toBe("₁₂");
  });
});
