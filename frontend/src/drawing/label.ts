import type { Pixel } from "./layout";

interface Label {
  x: number;
  y: number;
  width: number;
}

const CLEAR = 14;
const HALF = 8.5;

function clamp(value: number, low: number, high: number): number {
  return Math.min(Math.max(value, low), Math.max(low, high));
}

/** Where the text of a dimension stands: beside its middle, inside the picture. */
export function placeLabel(
  from: Pixel,
  to: Pixel,
  text: string,
  bounds: { width: number; height: number },
): Label {
  const width = text.length * 6.4 + 10;
  const x = (from[0] + to[0]) / 2;
  const y = (from[1] + to[1]) / 2;
  const upright = Math.abs(to[1] - from[1]) > Math.abs(to[0] - from[0]);
  const across = upright ? width / 2 + 8 : 0;
  const right = x + across + width / 2 <= bounds.width - 2;
  const above = y - CLEAR - HALF >= 1;
  return {
    x: clamp(upright ? (right ? x + across : x - across) : x, width / 2 + 2, bounds.width - width / 2 - 2),
    y: clamp(upright ? y : above ? y - CLEAR : y + CLEAR, HALF + 1, bounds.height - HALF - 1),
    width,
  };
}
