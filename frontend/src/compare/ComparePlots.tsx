import type { ComparedSide, Comparison } from "../api/types";
import { anglePoints, tipPoints, type Curve } from "../charts/curve";
import { CurveChart } from "../charts/CurveChart";
import { ChartLegend } from "../charts/Legend";
import { loadsInWords } from "../results/words";
import { Notice } from "../ui/Notice";

function sideCurves(side: ComparedSide, which: "left" | "right", points: typeof anglePoints): Curve[] {
  const color = which === "left" ? "--series-instant" : "--series-fe";
  const name = `${which === "left" ? "Left" : "Right"} v${side.version.number}`;
  const curves: Curve[] = [];
  if (side.instant_result) {
    const style = which === "left" ? "line" : "dashed";
    const { trusted_to_kPa: trustedTo } = side.instant_result;
    curves.push({ id: `${which}-instant`, label: name, color, points: points(side.instant_result), style, trustedTo });
  }
  if (side.fe_result) {
    curves.push({ id: `${which}-fe`, label: `${name}, FE`, color, points: points(side.fe_result), style: "dots" });
  }
  return curves;
}

/** Curves of both versions over one another. */
export function ComparePlots(props: { comparison: Comparison; pressure: number | null; onPick: (pressure: number) => void }) {
  const { comparison, pressure, onPick } = props;
  const { left, right } = comparison;
  const angle = [...sideCurves(left, "left", anglePoints), ...sideCurves(right, "right", anglePoints)];
  const tip = [...sideCurves(left, "left", tipPoints), ...sideCurves(right, "right", tipPoints)];
  return (
    <div className="compare-plots">
      {[left, right].map(
        (side) =>
          side.instant_error && (
            <Notice key={side.version.id} tone="warn">
              {side.version.design_name} v{side.version.number}: {side.instant_error}
            </Notice>
          ),
      )}
      {[left, right].map(
        (side) =>
          side.instant_left_out.length > 0 && (
            <Notice key={side.version.id} tone="info">
              {side.version.design_name} v{side.version.number}: the instant answer is without{" "}
              {loadsInWords(side.instant_left_out)}.
            </Notice>
          ),
      )}
      <div className="plot-head">
        <h2>Bending angle (°)</h2>
        <ChartLegend curves={angle} />
      </div>
      <CurveChart
        curves={angle}
        xTitle="p (kPa)"
        marked={pressure}
        onPick={onPick}
        label="Bending angle of both versions over pressure"
        testId="compare-angle"
      />
      <div className="plot-head">
        <h2>Tip trajectory, X₃ (mm)</h2>
      </div>
      <CurveChart
        curves={tip}
        xTitle="X₁ (mm)"
        equal
        marked={pressure}
        onPick={onPick}
        label="Tip path of both versions"
        testId="compare-tip"
      />
    </div>
  );
}
