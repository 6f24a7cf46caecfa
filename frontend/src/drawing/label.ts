import type { Pixel } from "./layout";

interface Label {
  x: number;
  y: number;
  width: number;
}

const CLEAR = 14;
const HALF = 8.5;
/** Past an arrow that stands outside. */
const BEYOND = 24;

/** The name of a view, which no text of a dimension may cover [px]. */
export interface NamePlate {
  left: number;
  top: number;
  right: number;
  bottom: number;
}

/** Where a view's name stands whose band begins at `top`. */
export function namePlate(top: number): NamePlate {
  return { left: 4, top, right: 48, bottom: top + 14 };
}

function clearOf(label: Label, plates: readonly NamePlate[], upright: boolean): Label {
  const hit = plates.find(
    (plate) =>
      label.x - label.width / 2 < plate.right &&
      label.x + label.width / 2 > plate.left &&
      label.y - HALF < plate.bottom &&
      label.y + HALF > plate.top,
  );
  if (!hit) return label;
  return upright ? { ...label, y: hit.bottom + HALF + 1 } : { ...label, x: hit.right + label.width / 2 + 2 };
}

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
  plates: readonly NamePlate[] = [],
): Label {
  const width = text.length * 6.4 + 10;
  const x = (from[0] + to[0]) / 2;
  const y = (from[1] + to[1]) / 2;
  const upright = Math.abs(to[1] - from[1]) > Math.abs(to[0] - from[0]);
  const inside = (at: { x: number; y: number }): Label =>
    clearOf(
      {
        x: clamp(at.x, width / 2 + 2, bounds.width - width / 2 - 2),
        y: clamp(at.y, HALF + 1, bounds.height - HALF - 1),
        width,
      },
      plates,
      upright,
    );
  if (!upright) {
    const up = (body === null || body[1] >= y - 1) && y - CLEAR - HALF >= 1;
    return inside({ x, y: up ? y - CLEAR : y + CLEAR });
  }
  const across = width / 2 + 8;
  const roomLeft = x - across - width / 2 > 0;
  const roomRight = x + across + width / 2 < bounds.width;
  const bodyRight = body !== null && body[0] > x + 1;
  if (bodyRight ? roomLeft : !roomRight && roomLeft) return inside({ x: x - across, y });
  if (!bodyRight && roomRight) return inside({ x: x + across, y });
  // No room at its side: below the lower arrow, or above the upper one.
  const low = Math.max(from[1], to[1]) + BEYOND;
  const fits = low + HALF + 1 < bounds.height;
  return inside({ x, y: fits ? low : Math.min(from[1], to[1]) - BEYOND });
}
