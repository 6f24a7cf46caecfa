import { useState } from "react";

import { useStore, usePick } from "../api/store";
import { anglePoints, isBeyondTrust, tipPoints, type Curve } from "../charts/curve";
import { CurveChart } from "../charts/CurveChart";
import { ChartLegend } from "../charts/Legend";
import { Icon } from "../ui/Icon";
import { Busy, Empty } from "../ui/Notice";
import { Segmented } from "../ui/Segmented";
import { answers, isStale } from "../workbench/answers";
import { markPlotted } from "../workbench/latency";
import { scrubber, scrubToPressure, shownPressure } from "../workbench/scrubber";
import { bench } from "../workbench/workbench";
import { ModelNotes, useNoteCount } from "./ModelNotes";
import { NumbersTable } from "./NumbersTable";
import { BENDING_ANGLE } from "./quantities";
import { useShownFe, type ShownFe } from "./shown";
import { feLabel, kPa } from "./words";
import type { Result } from "../api/types";

/** Plots and numbers: the instant answer, and the finite-element answer over it. */
export function ResultsPanel() {
  const now = useStore(answers);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  const pressure = usePick(scrubber, shownPressure);
  const fe = useShownFe();
  const refused = (now.designProblem ?? now.sceneProblem) !== null || now.unreachable;
  const stale = work !== null && isStale(now, work) && refused;
  if (!now.result) {
    return (
      <section className="results" aria-label="Results">
        {refused ? (
          <Empty title="No answer yet">Correct the marked parameter to see the plots.</Empty>
        ) : (
          <Busy label="Computing the first answer" />
        )}
      </section>
    );
  }
  return (
    <section className={`results${stale ? " stale" : ""}`} aria-label="Results" data-testid="results">
      <Plots result={now.result} fe={fe} pressure={pressure} input={now.input} stale={stale} />
      <Details result={now.result} fe={fe} pressure={pressure} totalMs={now.totalMs} />
    </section>
  );
}

interface PlotsProps {
  result: Result;
  fe: ShownFe | null;
  pressure: number | null;
  input: number;
  stale: boolean;
}

function curvesOf({ result, fe, stale }: PlotsProps, points: typeof anglePoints): Curve[] {
  const curves: Curve[] = [
    { id: "instant", label: "Instant", color: "--series-instant", points: points(result), style: "line", faded: stale, trustedTo: result.trusted_to_kPa },
  ];
  if (fe) {
    curves.push({
      id: "fe",
      label: fe.matches ? feLabel(fe.job) : `${feLabel(fe.job)} (as saved)`,
      color: "--series-fe",
      points: points(fe.result),
      style: "dots",
      faded: !fe.matches,
    });
  }
  return curves;
}

const STALE_MARK = (
  <span className="stale-mark" role="status" data-testid="stale-answer">
    <Icon name="warning" size={12} /> last answer, not this design
  </span>
);

function Plots(props: PlotsProps) {
  const angle = curvesOf(props, anglePoints);
  const tip = curvesOf(props, tipPoints);
  return (
    <div className="plots">
      <div className="plot-head">
        <h2 title={BENDING_ANGLE}>Bending angle (°)</h2>
        {props.stale ? STALE_MARK : <ChartLegend curves={angle} part={props.fe ? "curves" : "all"} />}
      </div>
      <CurveChart
        curves={angle}
        xTitle="p (kPa)"
        marked={props.pressure}
        onPick={scrubToPressure}
        onDrawn={() => markPlotted(props.input)}
        label="Bending angle over pressure"
        testId="chart-angle"
      />
      <div className="plot-head">
        <h2 title="Path of the middle of the free end's bottom edge, as pressure rises">Tip trajectory, X₃ (mm)</h2>
        {props.stale && <ChartLegend curves={angle} part="curves" />}
        {!props.stale && props.fe && <ChartLegend curves={angle} part="range" />}
      </div>
      <CurveChart
        curves={tip}
        xTitle="X₁ (mm)"
        equal
        marked={props.pressure}
        onPick={scrubToPressure}
        label="Path of the tip, X3 over X1"
        testId="chart-tip"
      />
    </div>
  );
}

type Tab = "numbers" | "model";

function Details(props: { result: Result; fe: ShownFe | null; pressure: number | null; totalMs: number | null }) {
  const [tab, setTab] = useState<Tab>("numbers");
  const count = useNoteCount(props.result, props.fe);
  const { trusted_to_kPa: trustedTo } = props.result;
  const at = props.pressure ?? props.result.path.at(-1)?.pressure_kPa ?? 0;
  return (
    <div className="details">
      <div className="details-head">
        <Segmented
          label="Details"
          value={tab}
          options={[
            { value: "numbers", label: "Numbers" },
            { value: "model", label: count > 0 ? `Model and notes (${count})` : "Model" },
          ]}
          onChange={setTab}
          testId="details-tab"
        />
        {tab === "numbers" && props.pressure !== null && (
          <span className="at-pressure" data-testid="at-pressure">
            at {Number(props.pressure.toPrecision(4))} kPa
          </span>
        )}
      </div>
      {trustedTo !== null && isBeyondTrust(props.result, at) && tab === "numbers" && (
        <button
          type="button"
          className="stale-mark beyond-range"
          title="The linear model's assumptions do not hold at this pressure. Read the notes."
          data-testid="beyond-range"
          onClick={() => setTab("model")}
        >
          <Icon name="warning" size={12} /> Instant: beyond its range ({kPa(trustedTo)})
        </button>
      )}
      <div className="details-body">
        {tab === "numbers" ? (
          <NumbersTable result={props.result} fe={props.fe} pressure={props.pressure} />
        ) : (
          <ModelNotes result={props.result} fe={props.fe} totalMs={props.totalMs} />
        )}
      </div>
    </div>
  );
}
