/** Points of the ladder as the chart shows them, and what is said about each. */
import type { Ladder, LadderPoint } from "../api/types";
import { kPa, outcomeInWords } from "../results/words";
import { formatPercent, sentence } from "../ui/numbers";
import { rangeInWords, shortSeconds } from "./scale";

/** Where a point stands on both axes. A run whose error nobody can tell has its seconds only. */
export interface Place {
  readonly seconds: number;
  readonly error: number | null;
}

export function placeOf(point: LadderPoint): Place | null {
  if (!point.seconds || point.state === "refused") return null;
  if (!point.error_percent && point.state !== "measured") return null;
  return { seconds: point.seconds.value, error: point.error_percent?.value ?? null };
}

/** Drawn in the plane; an answer that stands for several rungs is drawn once. */
export function plotted(ladder: Ladder): LadderPoint[] {
  return ladder.points.filter((point) => placeOf(point) !== null && point.same_as === null);
}

/** Named beside the plane: refused, failed, or without an error that is known. */
export function listed(ladder: Ladder): LadderPoint[] {
  return ladder.points.filter((point) => placeOf(point) === null && point.same_as === null);
}

/** Rungs that this answer is accurate enough for. */
export function alsoAnswers(ladder: Ladder, point: LadderPoint): string[] {
  return ladder.points.filter((other) => other.same_as === point.label).map((other) => rungName(other));
}

/** "Closed form", "3D FE 5 %" */
export function rungName(point: Pick<LadderPoint, "rung" | "label">): string {
  if (point.rung === "fe") return point.label.replace(/^fe/, "3D FE");
  return shortName(point).replace(/^./, (letter) => letter.toUpperCase());
}

/** Beside its point: "cell + rod", "FE 5 %", "FE coarse" */
export function shortName(point: Pick<LadderPoint, "rung" | "label">): string {
  if (point.rung === "cell-rod") return "cell + rod";
  if (point.rung === "fe") return point.label.replace(/^fe/, "FE").replace(/ mesh$/, "");
  return point.label.replaceAll("-", " ");
}

/** A label as the API writes it, as people read it: for the rungs that sentences name. */
export function inWords(text: string): string {
  return text.replace(/\bfe (?=\d|\w+ mesh\b)/g, "FE ").replace(/\bcell-rod\b/g, "cell + rod").replace(/\bclosed-form\b/g, "closed form");
}

/** Whether it has run and its path ended before what was asked for; a limit point is an end of its own. */
export function isEarly(point: LadderPoint): boolean {
  return point.outcome !== null && point.outcome !== "converged" && point.outcome !== "limit_point";
}

const ENDS: Record<string, string> = {
  limit_point: "measured, up to its limit",
  stalled: "stalled",
  cancelled: "cancelled",
  budget_spent: "stopped, time used up",
};

/** Whether it has run, and how far: "measured", "predicted", "cancelled at 3.2 kPa". */
export function standing({ state, outcome, ends_at_kPa: end }: LadderPoint): string {
  if (outcome === null || outcome === "converged" || state === "refused") return state;
  const how = ENDS[outcome] ?? outcome.replaceAll("_", " ");
  return end === null ? how : `${how} at ${kPa(end)}`;
}

/** Stopped by hand or by its budget: what is told of it is still a prediction. */
export function isOpen({ state, outcome }: LadderPoint): boolean {
  return state === "predicted" && outcome !== null;
}

export function secondsInWords({ seconds, state }: LadderPoint): string {
  if (!seconds) return "";
  if (state === "measured") return `${shortSeconds(seconds.value)}, measured`;
  return rangeInWords(seconds);
}

/** What is more than nobody tells apart [%]. */
const MOST = 1000;

/** An estimate of all of the tip's way says that nothing is known [%]. */
export const ANYWHERE = 100;

/** Whether nothing better judges the cell and rod than an estimate of its own that says so. */
export function mayBeAnywhere({ rung, error_kind: kind, error_percent: error }: LadderPoint): boolean {
  return kind === "own estimate" && rung === "cell-rod" && error !== null && error.value >= ANYWHERE;
}

export function errorInWords(point: LadderPoint): string {
  const { error_percent: error, error_kind: kind } = point;
  if (!error) return point.mesh === null ? "not known" : "not known, for one mesh by itself cannot tell it";
  const value = formatPercent(error.value);
  if (kind === "against best") {
    const at = point.compared_at_kPa === null ? "" : ` at ${Number(point.compared_at_kPa.toPrecision(3))} kPa`;
    return `${value} from the best answer so far (${inWords(point.error_source ?? "")})${at}; with that one's own error at most ${formatPercent(error.high)}`;
  }
  if (error.high > MOST) return value;
  if (mayBeAnywhere(point)) return "it may be anywhere by its own estimate";
  if (kind === "own estimate") return `at most ${value} by its own estimate`;
  if (kind === "typical") return `typically ${value}; below ${formatPercent(error.high)} for four of five such designs`;
  return `at most ${value}, asked for`;
}

/** Everything about a point in sentences. `also`: rungs it stands for as well. */
export function about(point: LadderPoint, also: readonly string[]): string[] {
  const lines: string[] = [];
  if (point.state === "refused") lines.push(sentence(inWords(point.reason ?? "it cannot carry this scene")));
  else {
    lines.push(`Tip's error: ${errorInWords(point)}.`);
    if (point.seconds) lines.push(`${isOpen(point) ? "Time of the whole path" : "Time"}: ${secondsInWords(point)}.`);
    if (point.state === "predicted" && point.outcome !== "cancelled" && point.reason) lines.push(sentence(point.reason));
  }
  if (isEarly(point) || point.outcome === "limit_point") lines.push([outcomeInWords(point.outcome ?? ""), point.advice ?? ""].join(" ").trim());
  if (point.is_best) lines.push("The best answer so far.");
  if (point.state !== "refused" && point.leaves_out.length > 0) lines.push(`Leaves out: ${point.leaves_out.join(", ")}.`);
  if (also.length > 0) lines.push(`Also answers ${also.join(", ")}.`);
  if (point.is_older) lines.push("Computed by an earlier version of the science.");
  return lines;
}

/** What a click does. `stale`: the point is of an earlier question, whose answer may not be that of this one. */
export function actionOf(point: LadderPoint, stale = false): string {
  if (point.job_id !== null) return "Is being computed";
  if (point.rung !== "fe") return point.state === "refused" ? "" : "Click to draw it";
  if (point.state === "measured") return stale ? "Click to run it" : "Click to show its answer";
  return point.state === "refused" ? "Click to run it again" : "Click to run it";
}
