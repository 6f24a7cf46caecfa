import { useState } from "react";

import type { Result } from "../api/types";
import { anglePoints, overControl, pointAt, tipPoints, trustedPlace, type Curve, type CurvePoint, type PointsOf } from "../charts/curve";
import { CurveChart } from "../charts/CurveChart";
import type { Rule } from "../charts/draw";
import { ChartLegend } from "../charts/Legend";
import { Icon } from "../ui/Icon";
import { Segmented } from "../ui/Segmented";
import { markPlotted } from "../workbench/latency";
import { modelName } from "../workbench/model";
import type { Control } from "../workbench/loads";
import { scrubTo } from "../workbench/scrubber";
import { BENDING_ANGLE } from "./quantities";
import { reached } from "./reached";
import type { ShownFe } from "./shown";
import { feLabel, kPa } from "./words";

interface PlotsProps {
  instant: Result | null;
  /** An instant answer that `instant` has taken over from. */
  replaced: Result | null;
  fe: ShownFe | null;
  control: Control;
  at: number | null;
  input: number;
  stale: boolean;
}

const plateForce = overControl((point) => point.plate_force_N);
const cylinderForce = overControl((point) => point.cylinder_force_N);
const pressurePoints = overControl((point) => point.pressure_kPa);

function curvesOf({ instant, replaced, fe, control, stale }: PlotsProps, points: PointsOf): Curve[] {
  const curves: Curve[] = [];
  if (replaced) {
    curves.push({
      id: "replaced",
      label: modelName(replaced.rung),
      color: "--series-instant",
      // what it draws beyond the end of a path that ended early would leave that path no room
      points: upTo(points(replaced, control), instant, control),
      style: "dashed",
      faded: true,
    });
  }
  if (instant) {
    curves.push({
      id: "instant",
      label: modelName(instant.rung),
      color: "--series-instant",
      points: points(instant, control),
      style: "line",
      faded: stale,
      trustedTo: trustedPlace(instant, control),
    });
  }
  if (fe) {
    curves.push({
      id: "fe",
      label: fe.matches ? `3D ${feLabel(fe.job)}` : `3D ${feLabel(fe.job)}, of the design as it was saved`,
      short: fe.matches ? "FE" : "FE as saved",
      color: "--series-fe",
      points: points(fe.result, control),
      style: "dots",
      faded: !fe.matches,
    });
  }
  return curves;
}

/** The points up to the end of an answer whose path ended before what was asked for. */
function upTo(points: readonly CurvePoint[], answer: Result | null, control: Control): readonly CurvePoint[] {
  if (answer === null || answer.outcome === "converged") return points;
  const end = reached(answer, control);
  const last = end === null ? null : pointAt(points, end);
  if (end === null || last === null) return points;
  return [...points.filter(({ at }) => Math.abs(at) < Math.abs(end)), last];
}

/** Forces come from finite elements only: one curve for each obstacle there is. */
function forceCurves({ fe, control }: PlotsProps): Curve[] {
  if (!fe) return [];
  const curves: Curve[] = [
    { id: "plate", label: "on plate", color: "--series-fe", points: plateForce(fe.result, control), style: "dots", faded: !fe.matches },
    { id: "cylinder", label: "on cylinder", color: "--series-other", points: cylinderForce(fe.result, control), style: "dots", faded: !fe.matches },
  ];
  return curves.filter((curve) => curve.points.length > 0);
}

/** The largest pressure there is an equilibrium for, as far as finite elements know. */
function limitRule(fe: ShownFe | null, axis: Rule["axis"]): Rule[] {
  const limit = fe?.matches === true ? fe.result.limit_pressure_kPa : null;
  if (limit === null) return [];
  return [{ axis, value: limit, label: `no equilibrium above ${kPa(limit)}`, short: `limit ${kPa(limit)}`, color: "--series-fe" }];
}

const STALE_MARK = (
  <span className="stale-mark" role="status" data-testid="stale-answer">
    <Icon name="warning" size={12} /> last answer, not this design
  </span>
);

type Lower = "tip" | "force" | "pressure";

/** Bending angle above; below the tip's path, or the force on an obstacle, or pressure over volume. */
export function Plots(props: PlotsProps) {
  const { control, fe, at } = props;
  const angle = curvesOf(props, anglePoints);
  const xTitle = control === "pressure" ? "p (kPa)" : "V (ml)";
  return (
    <div className="plots">
      <div className="plot-head">
        <h2 title={BENDING_ANGLE}>Bending angle (°)</h2>
        {props.stale ? STALE_MARK : <ChartLegend curves={angle} part={fe ? "curves" : "all"} />}
      </div>
      <CurveChart
        curves={angle}
        xTitle={xTitle}
        fromZero={control === "pressure"}
        marked={at}
        rules={control === "pressure" ? limitRule(fe, "x") : []}
        onPick={scrubTo}
        onDrawn={() => markPlotted(props.input)}
        label={`Bending angle over ${control}`}
        testId="chart-angle"
      />
      <LowerPlot {...props} angle={angle} xTitle={xTitle} />
    </div>
  );
}

function LowerPlot(props: PlotsProps & { angle: readonly Curve[]; xTitle: string }) {
  const { control, fe, stale, at, angle, xTitle } = props;
  const [chosen, choose] = useState<Lower | null>(null);
  const force = forceCurves(props);
  const kinds: { value: Lower; label: string; title: string }[] = [
    { value: "tip", label: "Tip path", title: "Path of the middle of the free end's bottom edge" },
  ];
  if (force.length > 0) kinds.push({ value: "force", label: "Force", title: "Between actuator and obstacle" });
  if (control === "volume") kinds.push({ value: "pressure", label: "Pressure", title: "Pressure at which the cavity has a volume" });
  // What was added to the scene is what there is to see, until something else is chosen.
  const kind = kinds.find((each) => each.value === chosen)?.value ?? kinds.at(-1)?.value ?? "tip";
  const range = !stale && fe !== null && props.instant !== null;
  return (
    <>
      <div className="plot-head">
        {kinds.length === 1 ? (
          <h2 title={kinds[0]?.title}>{HEADINGS.tip}</h2>
        ) : (
          <>
            <Segmented label="Lower plot" value={kind} options={kinds} onChange={choose} testId="lower-plot" />
            <h2>{SHORT_HEADINGS[kind]}</h2>
          </>
        )}
        {stale && <ChartLegend curves={angle} part="curves" />}
        {kind === "force" && !stale && <ChartLegend curves={force} part="curves" />}
        {kind !== "force" && range && <ChartLegend curves={angle} part="range" />}
      </div>
      {kind === "tip" && (
        <CurveChart
          key="tip"
          curves={curvesOf(props, tipPoints)}
          xTitle="X₁ (mm)"
          equal
          marked={at}
          onPick={scrubTo}
          label="Path of the tip, X3 over X1"
          testId="chart-tip"
        />
      )}
      {kind === "force" && (
        <CurveChart
          key="force"
          curves={force}
          xTitle={xTitle}
        fromZero={control === "pressure"}
          marked={at}
          onPick={scrubTo}
          label={`Force on obstacles over ${control}`}
          testId="chart-force"
        />
      )}
      {kind === "pressure" && (
        <CurveChart
          key="pressure"
          curves={curvesOf(props, pressurePoints)}
          xTitle={xTitle}
        fromZero={control === "pressure"}
          marked={at}
          rules={limitRule(fe, "y")}
          onPick={scrubTo}
          label="Pressure over volume"
          testId="chart-pressure"
        />
      )}
    </>
  );
}

const HEADINGS = { tip: "Tip trajectory, X₃ (mm)" } as const;
const SHORT_HEADINGS: Record<Lower, string> = { tip: "X₃ (mm)", force: "F (N)", pressure: "p (kPa)" };
