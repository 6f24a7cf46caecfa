import { useState } from "react";

import { usePick, useStore } from "../api/store";
import type { Ladder, LadderPoint } from "../api/types";
import { useDrawn } from "../results/drawn";
import { IconButton } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Busy } from "../ui/Notice";
import { sameQuestion } from "../workbench/document";
import { askRefined, refined } from "../workbench/refined";
import { bench } from "../workbench/workbench";
import { ladder } from "./ask";
import { LadderChart } from "./LadderChart";
import { limits, sameLimits } from "./limits";
import { Picks } from "./Picks";
import { about, actionOf, listed, rungName } from "./points";
import { takeRung } from "./take";

const KEY = "pneustudio.ladder";

/** What every model costs in seconds and how far off it is, for the design on the bench. */
export function LadderPanel() {
  const [open, setOpen] = useState(() => localStorage.getItem(KEY) !== "closed");
  const state = useStore(ladder);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  const { ladder: found, problem } = state;
  const stale = work === null || state.answered === null || !sameQuestion(state.answered, work);
  const wanted = useStore(limits);
  const picks = found?.choices.flatMap((choice) => choice.rung ?? []) ?? [];
  const drawn = useDrawn();
  return (
    <section className={`ladder${open ? "" : " closed"}`} aria-label="Error against seconds" data-testid="ladder" data-asking={state.asking || stale}>
      <header className="panel-head">
        <IconButton
          icon="chevron"
          label={open ? "Fold the ladder away" : "Show the ladder"}
          className={open ? "" : "turned"}
          aria-expanded={open}
          onClick={() => {
            localStorage.setItem(KEY, open ? "closed" : "open");
            setOpen(!open);
          }}
        />
        <h2 title={learned(found)}>Error against seconds</h2>
        <ul className="ladder-key" aria-label="Key">
          <li className="measured">has run</li>
          <li className="predicted">predicted</li>
        </ul>
      </header>
      {open && (
        <>
          {found ? (
            <LadderChart ladder={found} stale={stale} asking={problem === null} drawnRung={drawn?.result.rung ?? null} picks={picks} />
          ) : (
            <div className="ladder-chart">{problem === null ? <Busy label="Comparing the models" /> : null}</div>
          )}
          {problem !== null && (
            <p className="ladder-problem" role="status" data-testid="ladder-problem">
              <Icon name="warning" size={12} /> {problem}
            </p>
          )}
          <Unrefined />
          {found && <Picks ladder={found} stale={stale || !sameLimits(state.asked, wanted)} />}
          {found && <Unplotted points={listed(found)} stale={stale} />}
        </>
      )}
    </section>
  );
}

/** The cell and rod could not be computed, though it is not refused. */
function Unrefined() {
  const problem = usePick(refined, (now) => now.problem);
  if (problem === null) return null;
  return (
    <p className="ladder-problem" role="status" data-testid="refined-problem">
      <Icon name="warning" size={12} /> <span>{problem}</span>
      <button type="button" className="link" onClick={askRefined}>
        Ask again
      </button>
    </p>
  );
}

function learned(found: Ladder | null): string {
  const jobs = found?.learned_from_jobs ?? 0;
  return `The tip's error, in percent of the tip's whole way from the straight body, its sag under weight included, and the time of every model for this design in this scene. Predicted times rest on ${jobs === 1 ? "1 past job" : `${jobs} past jobs`} of this machine, beside the shipped record.`;
}

/** Rungs without a place in the plane, each with its reason. */
function Unplotted({ points, stale }: { points: readonly LadderPoint[]; stale: boolean }) {
  if (points.length === 0) return null;
  return (
    <ul className={`unplotted${stale ? " stale" : ""}`} data-testid="ladder-unplotted">
      {points.map((point) => {
        const words = about(point, []).join(" ");
        const again = point.rung === "fe";
        return (
          <li key={point.label}>
            <button
              type="button"
              className={`link ${point.state}`}
              title={again ? `${words} ${actionOf(point)}.` : words}
              aria-label={`${rungName(point)}: ${words}`}
              data-testid={`ladder-${point.label.replaceAll(" ", "").replace("%", "")}`}
              onClick={() => {
                if (again) void takeRung(point);
              }}
            >
              <Icon name="warning" size={11} /> {rungName(point)} {point.state === "refused" ? (again ? "failed" : "cannot") : "error unknown"}
            </button>
            <span className="muted">{words}</span>
          </li>
        );
      })}
    </ul>
  );
}
