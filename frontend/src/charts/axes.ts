import type uPlot from "uplot";

import { token } from "../theme/theme";
import { grouped } from "../ui/numbers";

/** Space the axes take [px]; fixed, so that equal scales can be worked out beforehand. */
export const SPACE = { left: 40, bottom: 20, top: 6, right: 14 };

function text(value: number): string {
  return grouped(String(Number(value.toPrecision(6))).replace("-", "−"));
}

export function axesOf(xTitle: string): uPlot.Axis[] {
  const common = {
    stroke: token("--muted"),
    font: `11px ${token("--font")}`,
    grid: { stroke: token("--grid"), width: 1 },
    ticks: { show: false },
    border: { show: true, stroke: token("--line-strong"), width: 1 },
  };
  // The axis title stands in the row of numbers, at its end; numbers make room for it.
  const reserved = xTitle.length * 6 + 16;
  return [
    {
      ...common,
      size: SPACE.bottom,
      gap: 5,
      space: 46,
      values: (u, splits) =>
        splits.map((value) => (isUnderTitle(u, value, reserved) ? "" : text(value))),
    },
    { ...common, size: SPACE.left, gap: 5, space: 26, values: (_, splits) => splits.map(text) },
  ];
}

function isUnderTitle(u: uPlot, value: number, reserved: number): boolean {
  const { min, max } = u.scales.x ?? {};
  const from = min ?? 0;
  const to = max ?? 1;
  const width = u.width - SPACE.left - SPACE.right;
  const share = (value - from) / Math.max(to - from, 1e-12);
  return share * width > width - reserved;
}

export function drawAxisTitle(u: uPlot, title: string): void {
  const { ctx, bbox } = u;
  const ratio = window.devicePixelRatio;
  ctx.save();
  ctx.font = `${11 * ratio}px ${token("--font")}`;
  ctx.fillStyle = token("--muted");
  ctx.textAlign = "right";
  ctx.textBaseline = "top";
  ctx.fillText(title, bbox.left + bbox.width + 8 * ratio, bbox.top + bbox.height + 5 * ratio);
  ctx.restore();
}
