import { useLayoutEffect, useRef } from "react";
import uPlot from "uplot";
import "uplot/dist/uPlot.min.css";

import { useTheme } from "../theme/theme";
import { useSize } from "../ui/useSize";
import type { Curve } from "./curve";
import { axesOf, drawAxisTitle, SPACE } from "./axes";
import { drawClamp, drawCurves, drawMarker, drawRules, type Rule } from "./draw";
import { equalRanges, freeRanges } from "./scales";

export interface CurveChartProps {
  curves: readonly Curve[];
  /** Title of the axis to the right, with its unit; the upward axis is named by the heading. */
  xTitle: string;
  /** Whether x begins at 0; it does when left out. */
  fromZero?: boolean;
  /** One unit is as long on both axes. */
  equal?: boolean;
  /** Place on the path (pressure or volume) marked on every curve. */
  marked: number | null;
  /** Values that no curve passes. */
  rules?: readonly Rule[] | undefined;
  /** A place chosen with the pointer. */
  onPick?: ((at: number) => void) | undefined;
  /** Called after the curves have been drawn. */
  onDrawn?: (() => void) | undefined;
  label: string;
  testId: string;
}

/** Curves over x and y with one marked place; the point under the pointer picks another. */
export function CurveChart(props: CurveChartProps) {
  const [ref, size] = useSize();
  const host = useRef<HTMLDivElement>(null);
  const plot = useRef<uPlot | null>(null);
  const latest = useRef(props);
  const { theme } = useTheme();
  const { xTitle, curves, marked, rules } = props;
  const ready = size.width > 20 && size.height > 20;

  useLayoutEffect(() => {
    latest.current = props;
  });

  useLayoutEffect(() => {
    if (!ready || !host.current) return;
    const made = create(host.current, () => latest.current, xTitle);
    plot.current = made;
    return () => {
      plot.current = null;
      made.destroy();
    };
  }, [ready, theme, xTitle]);

  useLayoutEffect(() => {
    plot.current?.setSize({ width: size.width, height: size.height });
    plot.current?.setData(EMPTY);
  }, [size, ready, theme]);

  useLayoutEffect(() => {
    // The data stay with the props; a new empty set makes uPlot take ranges and draw anew.
    plot.current?.setData(EMPTY);
  }, [curves, rules]);

  useLayoutEffect(() => {
    plot.current?.redraw(false);
  }, [marked]);

  return (
    <div className="chart" ref={ref} role="img" aria-label={props.label} data-testid={props.testId}>
      <div className="chart-host" ref={host} />
    </div>
  );
}

const EMPTY = [null, [[], []]] as unknown as uPlot.AlignedData;

function create(host: HTMLElement, props: () => CurveChartProps, xTitle: string): uPlot {
  const ranges = () => {
    const { curves, equal, rules, fromZero } = props();
    if (!equal) return freeRanges(curves, rules, fromZero);
    // Of the host: the plot asks for its ranges before it knows its own size.
    const { clientWidth, clientHeight } = host;
    return equalRanges(curves, clientWidth - SPACE.left - SPACE.right, clientHeight - SPACE.top - SPACE.bottom);
  };
  const plot = new uPlot(
    {
      // Mode 2 has x and y for each curve. uPlot declares its modes as an enum that is not there.
      // eslint-disable-next-line @typescript-eslint/no-unsafe-enum-assignment
      mode: 2,
      width: Math.max(40, host.clientWidth),
      height: Math.max(40, host.clientHeight),
      padding: [SPACE.top, SPACE.right, 0, 0],
      legend: { show: false },
      cursor: { show: false },
      scales: {
        x: { time: false, range: () => ranges().x },
        y: { range: () => ranges().y },
      },
      series: [{}, { paths: () => null, points: { show: false } }] as uPlot.Series[],
      axes: axesOf(xTitle),
      hooks: {
        draw: [
          (u) => {
            const { curves, marked, onDrawn, equal, rules } = props();
            drawAxisTitle(u, xTitle);
            if (equal) drawClamp(u);
            drawCurves(u, curves);
            drawRules(u, rules ?? []);
            if (marked !== null) drawMarker(u, curves, marked, !equal);
            onDrawn?.();
          },
        ],
      },
    },
    EMPTY,
    host,
  );
  followPointer(plot, props);
  return plot;
}

/** Press and drag over the plot moves the mark to the nearest point of a curve. */
function followPointer(plot: uPlot, props: () => CurveChartProps): void {
  const pick = (event: PointerEvent) => {
    if (event.buttons !== 1) return;
    const box = plot.over.getBoundingClientRect();
    const px = event.clientX - box.left;
    const py = event.clientY - box.top;
    let best: { distance: number; at: number } | null = null;
    for (const curve of props().curves) {
      for (const point of curve.points) {
        const dx = plot.valToPos(point.x, "x") - px;
        const dy = props().equal ? plot.valToPos(point.y, "y") - py : 0;
        const distance = Math.hypot(dx, dy);
        if (!best || distance < best.distance) best = { distance, at: point.at };
      }
    }
    if (best) props().onPick?.(best.at);
  };
  plot.over.addEventListener("pointerdown", pick);
  plot.over.addEventListener("pointermove", pick);
}
