/** Millimetres to pixels: both views share one scale and one X1 axis, section above planform. */
import type { Drawing, DrawingView } from "../api/types";

export type ViewName = "section" | "planform";

export interface PlacedView {
  name: ViewName;
  view: DrawingView;
  /** Pixel of X1 = 0, and of the vertical axis' 0. */
  origin: Pixel;
  /** Edges of the view's band [px]. */
  top: number;
  height: number;
}

export interface Layout {
  /** Pixels for a millimetre. */
  scale: number;
  views: PlacedView[];
}

export type Pixel = readonly [number, number];

/** Left of the body stand the names of the views and the values of the layers. */
const MARGIN = { left: 34, right: 8, top: 4, between: 2, bottom: 4 };

function edges(view: DrawingView): { left: number; bottom: number; right: number; top: number } {
  const [left = 0, bottom = 0, right = 0, top = 0] = view.bounds;
  return { left, bottom, right, top };
}

export function layOut(drawing: Drawing, width: number, height: number): Layout {
  const names: ViewName[] = ["section", "planform"];
  const all = names.map((name) => ({ name, view: drawing.views[name], ...edges(drawing.views[name]) }));
  const left = Math.min(...all.map((each) => each.left));
  const right = Math.max(...all.map((each) => each.right));
  const upright = all.reduce((sum, each) => sum + each.top - each.bottom, 0);
  const gaps = MARGIN.top + MARGIN.bottom + MARGIN.between;
  const scale = Math.max(
    1e-3,
    Math.min((width - MARGIN.left - MARGIN.right) / Math.max(right - left, 1e-6), (height - gaps) / Math.max(upright, 1e-6)),
  );
  const x0 = (width + MARGIN.left - MARGIN.right - (right - left) * scale) / 2 - left * scale;
  let top = MARGIN.top + Math.max(0, (height - gaps - upright * scale) / 2);
  const views = all.map((each) => {
    const placed: PlacedView = {
      name: each.name,
      view: each.view,
      origin: [x0, top + each.top * scale],
      top,
      height: (each.top - each.bottom) * scale,
    };
    top += placed.height + MARGIN.between;
    return placed;
  });
  return { scale, views };
}

export function toPixel(placed: PlacedView, scale: number, point: readonly number[]): Pixel {
  const [x = 0, y = 0] = point;
  return [placed.origin[0] + x * scale, placed.origin[1] - y * scale];
}

/** Rows of the rubber at X1 = 0, from the shapes: where the clamp is drawn, as pixels. */
export function clampSpan(placed: PlacedView, scale: number): readonly [number, number] {
  const heights = placed.view.shapes
    .filter((shape) => shape.kind === "rubber")
    .flatMap((shape) => shape.rings.flat())
    .filter(([x = 1]) => Math.abs(x) < 1e-6)
    .map(([, y = 0]) => y);
  const [, low] = toPixel(placed, scale, [0, Math.min(...heights, 0)]);
  const [, high] = toPixel(placed, scale, [0, Math.max(...heights, 0)]);
  return [high, low];
}
