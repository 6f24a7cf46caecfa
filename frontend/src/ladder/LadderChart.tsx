import { useState, type KeyboardEvent } from "react";

import { usePick } from "../api/store";
import { useLateness } from "../jobs/expected";
import type { Ladder, LadderPoint } from "../api/types";
import { useSize } from "../ui/useSize";
import { refined } from "../workbench/refined";
import { placeNames, type Placed } from "./labels";
import { EARLIER, PointCard } from "./PointCard";
import { about, actionOf, alsoAnswers, isEarly, placeOf, plotted, rungName, shortName, standing } from "./points";
import { decades, logScale, marks, timeMarks, type LogScale } from "./scale";
import { takeRung } from "./take";

const SPACE = { left: 46, right: 12, top: 8, bottom: 20 };
/** Errors and times below these are not told apart. */
const LEAST_ERROR = 0.01;
const LEAST_SECONDS = 1e-3;
const LETTER = 5.9;

interface Drawn {
  point: LadderPoint;
  x: number;
  y: number;
  name: Placed;
}

interface Picture {
  across: LogScale;
  up: LogScale;
  drawn: Drawn[];
}

/** Of a point's dot, and of the ring around one that a limit chose [px]. */
const DOT = 5.5;
const RING = 9;
/** A name further above or below its point has a line to it [px]. */
const NEAR = 14;

function pictureOf(ladder: Ladder, picks: readonly string[], width: number, height: number): Picture {
  const points = plotted(ladder);
  const seconds = points.flatMap(({ seconds: range }) => (range ? [range.value, range.high] : []));
  const errors = points.flatMap(({ error_percent: range }) => (range ? [range.value] : []));
  const across = logScale(decades(seconds, LEAST_SECONDS), SPACE.left, width - SPACE.right);
  const up = logScale(decades(errors, LEAST_ERROR), height - SPACE.bottom - 6, SPACE.top);
  const at = points.map((point) => {
    const place = placeOf(point) ?? { seconds: LEAST_SECONDS, error: LEAST_ERROR };
    // A run whose error nobody can tell stands at the upper edge, its line down through all errors.
    const y = place.error === null ? SPACE.top : up.place(place.error);
    const radius = picks.includes(point.label) ? RING + 1 : DOT;
    return { x: across.place(place.seconds), y, width: LETTER * shortName(point).length, radius };
  });
  const area = { x: SPACE.left, y: 0, width: width - SPACE.left - 2, height: height - SPACE.bottom + 6 };
  const names = placeNames(at, area);
  const drawn = points.map((point, index) => ({
    point,
    x: at[index]?.x ?? 0,
    y: at[index]?.y ?? 0,
    name: names[index] ?? { x: 0, y: 0, anchor: "start" as const },
  }));
  return { across, up, drawn };
}

interface LadderChartProps {
  ladder: Ladder;
  /** Whether its values answer an earlier question than the one on the bench. */
  stale: boolean;
  /** Whether those of the question on the bench are on their way. */
  asking: boolean;
  /** Label of the rung whose curve is drawn. */
  drawnRung: string | null;
  /** Labels of the rungs chosen by the limits. */
  picks: readonly string[];
}

/** Error over seconds, both logarithmic: filled points have run, hollow ones are predicted. */
export function LadderChart({ ladder, stale, asking, drawnRung, picks }: LadderChartProps) {
  const [ref, { width, height }] = useSize();
  const [open, setOpen] = useState<string | null>(null);
  const ready = width > 80 && height > 60;
  const picture = ready ? pictureOf(ladder, picks, width, height) : null;
  const shown = picture?.drawn.find(({ point }) => point.label === open);
  return (
    <div className={`ladder-chart${stale ? " stale" : ""}`} ref={ref} data-testid="ladder-chart" data-stale={stale}>
      {picture && (
        <svg width={width} height={height} role="group" aria-label="Error against seconds of every model">
          <Axes across={picture.across} up={picture.up} width={width} height={height} />
          {picture.drawn.map((each) => (
            <Bands key={each.point.label} {...each} {...picture} floor={height - SPACE.bottom} />
          ))}
          {picture.drawn.map((each) => (
            <Point
              key={each.point.label}
              {...each}
              also={alsoAnswers(ladder, each.point)}
              isDrawn={each.point.label === drawnRung}
              isPicked={picks.includes(each.point.label)}
              stale={stale}
              onOpen={setOpen}
            />
          ))}
        </svg>
      )}
      {stale && (
        <p className="ladder-stale" role="status" data-testid="ladder-stale">
          {asking && <span className="spinner" aria-hidden="true" />} Of the earlier question{asking ? ", comparing anew" : ""}
        </p>
      )}
      {shown && <PointCard point={shown.point} also={alsoAnswers(ladder, shown.point)} stale={stale} at={shown} width={width} height={height} />}
    </div>
  );
}

function Axes({ across, up, width, height }: { across: LogScale; up: LogScale; width: number; height: number }) {
  const right = width - SPACE.right;
  const floor = height - SPACE.bottom;
  return (
    <g className="ladder-axes" aria-hidden="true">
      {timeMarks(across, Math.max(2, Math.floor((right - SPACE.left) / 46))).map(({ at, text }) => (
        <g key={at}>
          <line x1={across.place(at)} x2={across.place(at)} y1={SPACE.top} y2={floor} />
          <text x={across.place(at)} y={height - 5} textAnchor={across.place(at) > right - 12 ? "end" : "middle"}>
            {text}
          </text>
        </g>
      ))}
      {marks(up, Math.max(2, Math.floor((floor - SPACE.top) / 20))).map((value) => (
        <g key={value}>
          <line x1={SPACE.left} x2={right} y1={up.place(value)} y2={up.place(value)} />
          <text x={SPACE.left - 5} y={up.place(value)} dy="0.32em" textAnchor="end">
            {value} %
          </text>
        </g>
      ))}
    </g>
  );
}

interface PointProps extends Drawn {
  also: readonly string[];
  isDrawn: boolean;
  isPicked: boolean;
  stale: boolean;
  onOpen: (label: string | null) => void;
}

function Point({ point, x, y, name, also, isDrawn, isPicked, stale, onOpen }: PointProps) {
  const computing = usePick(refined, (now) => now.asking) && point.rung === "cell-rod";
  const busy = computing || point.job_id !== null;
  const late = useLateness(point.job_id);
  const action = actionOf(point, stale);
  const warned = isEarly(point) || late !== null;
  const classes = ["ladder-point", point.rung, point.state, busy && "busy", isDrawn && "drawn", warned && "early"];
  const activate = () => void takeRung(point);
  const told = [...about(point, also), late === null ? "" : `${late}.`, stale ? EARLIER : "", action && `${action}.`];
  const label = `${rungName(point)}, ${standing(point)}. ${told.filter(Boolean).join(" ")}`;
  return (
    <g
      className={classes.filter(Boolean).join(" ")}
      role="button"
      tabIndex={0}
      aria-label={label}
      data-testid={`ladder-${point.label.replaceAll(" ", "").replace("%", "")}`}
      data-state={point.state}
      data-picked={isPicked}
      onPointerEnter={() => onOpen(point.label)}
      onPointerLeave={() => onOpen(null)}
      onFocus={() => onOpen(point.label)}
      onBlur={() => onOpen(null)}
      onClick={activate}
      onKeyDown={(event: KeyboardEvent) => {
        if (event.key !== "Enter" && event.key !== " ") return;
        // Space plays the pressure elsewhere on the page.
        event.preventDefault();
        event.stopPropagation();
        activate();
      }}
    >
      {Math.abs(name.y - y) > NEAR && <line className="leader" x1={x} y1={y} x2={name.x} y2={name.y + (name.y < y ? 5 : -5)} />}
      {isPicked && <circle className="pick" cx={x} cy={y} r={RING} />}
      <circle className="hit" cx={x} cy={y} r={10} />
      <circle className="dot" cx={x} cy={y} r={isDrawn ? DOT : 4.5} />
      <text x={name.x} y={name.y} dy="0.32em" textAnchor={name.anchor}>
        {shortName(point)}
      </text>
    </g>
  );
}

interface BandsProps extends Drawn {
  across: LogScale;
  up: LogScale;
  floor: number;
}

/** The error's band upright, the seconds expected across; under all points, so that names can be read. */
function Bands({ point, x, y, across, up, floor }: BandsProps) {
  const { error_percent: error, seconds, state } = point;
  return (
    <g className={`ladder-bands ${point.rung}`} aria-hidden="true">
      {!error && <line className="span" x1={x} x2={x} y1={y} y2={floor} />}
      {error && error.high > error.low && <line className="band" x1={x} x2={x} y1={up.place(error.low)} y2={up.place(error.high)} />}
      {state === "predicted" && seconds && <line className="span" x1={across.place(seconds.low)} x2={across.place(seconds.high)} y1={y} y2={y} />}
    </g>
  );
}
