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

/** Where the text of a dimension stands: beside its middle on the side away from the body (which
 * lies towards `body`), inside the picture. */
export function placeLabel(
  from: Pixel,
  to: Pixel,
  text: string,
  bounds: { width: number; height: number },
  body: Pixel | null,
): Label {
  const width = text.length * 6.4 + 10;
  const x = (from[0] + to[0]) / 2;
  const y = (from[1] + to[1]) / 2;
  const upright = Math.abs(to[1] - from[1]) > Math.abs(to[0] - from[0]);
  const across = upright ? width / 2 + 8 : 0;
  const up = !upright && (body === null || body[1] >= y - 1) && y - CLEAR - HALF >= 1;
  const left = (body !== null && body[0] > x + 1) || x + across + width / 2 > bounds.width - 2;
  const besideX = left && x - across - width / 2 > 0 ? x - across : x + across;
  return {
    x: clamp(upright ? besideX : x, width / 2 + 2, bounds.width - width / 2 - 2),
    y: clamp(upright ? y : up ? y - CLEAR : y + CLEAR, HALF + 1, bounds.height - HALF - 1),
    width,
  };
}
