import type uPlot from "uplot";

import { token } from "../theme/theme";

function font(size: number): string {
  return `${size}px ${token("--font")}`;
}

function text(value: number): string {
  return String(Number(value.toPrecision(6))).replace("-", "−");
}

export function axesOf(xLabel: string, yLabel: string): uPlot.Axis[] {
  const common = {
    stroke: token("--muted"),
    font: font(11),
    labelFont: font(11),
    grid: { stroke: token("--grid"), width: 1 },
    ticks: { stroke: token("--line"), width: 1, size: 4 },
    border: { show: true, stroke: token("--line-strong"), width: 1 },
    values: (_: uPlot, splits: number[]) => splits.map(text),
    labelGap: 0,
  };
  return [
    { ...common, label: xLabel, size: 26, labelSize: 15, gap: 3, space: 46 },
    { ...common, label: yLabel, size: 36, labelSize: 15, gap: 3, space: 28 },
  ];
}
