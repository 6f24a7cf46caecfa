/** Points of the ladder as the chart shows them, and what is said about each. */
import type { Ladder, LadderPoint } from "../api/types";
import { outcomeInWords } from "../results/words";
import { sentence } from "../ui/numbers";
import { shortPercent, shortSeconds } from "./scale";

/** Where a point stands on both axes; null where one of them is unknown. */
export interface Place {
  readonly seconds: number;
  readonly error: number;
}

export function placeOf(point: LadderPoint): Place | null {
  if (!point.seconds || !point.error_percent || point.state === "refused") return null;
  return { seconds: point.seconds.value, error: point.error_percent.value };
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

/** Beside its point: "cell + rod", "FE 5 %" */
export function shortName(point: Pick<LadderPoint, "rung" | "label">): string {
  if (point.rung === "cell-rod") return "cell + rod";
  if (point.rung === "fe") return point.label.replace(/^fe/, "FE");
  return point.label.replaceAll("-", " ");
}

/** A label as the API writes it, as people read it: for the rungs that sentences name. */
export function inWords(text: string): string {
  return text.replace(/\bfe (?=\d)/g, "FE ").replace(/\bcell-rod\b/g, "cell + rod").replace(/\bclosed-form\b/g, "closed form");
}

export function isEarly(point: LadderPoint): boolean {
  return point.state === "measured" && point.outcome !== "converged" && point.outcome !== "limit_point";
}

export function secondsInWords({ seconds, state }: LadderPoint): string {
  if (!seconds) return "";
  if (state === "measured") return `${shortSeconds(seconds.value)}, measured`;
  return `about ${shortSeconds(seconds.value)}, four of five jobs between ${shortSeconds(seconds.low)} and ${shortSeconds(seconds.high)}`;
}

export function errorInWords(point: LadderPoint): string {
  const { error_percent: error, error_kind: kind } = point;
  if (!error) return "error not known";
  const value = shortPercent(error.value);
  if (kind === "against best") {
    const at = point.compared_at_kPa === null ? "" : ` at ${Number(point.compared_at_kPa.toPrecision(3))} kPa`;
    return `${value} from the best answer so far (${inWords(point.error_source ?? "")})${at}; with that one's own error at most ${shortPercent(error.high)}`;
  }
  if (kind === "own estimate") return `at most ${value} by its own estimate`;
  if (kind === "typical") return `typically ${value}; below ${shortPercent(error.high)} for four of five such designs`;
  return `at most ${value}, asked for`;
}

/** Everything about a point in sentences. `also`: rungs it stands for as well. */
export function about(point: LadderPoint, also: readonly string[]): string[] {
  const lines: string[] = [];
  if (point.state === "refused") lines.push(sentence(inWords(point.reason ?? "it cannot carry this scene")));
  else {
    lines.push(`Tip's error: ${errorInWords(point)}.`);
    if (point.seconds) lines.push(`Time: ${secondsInWords(point)}.`);
    if (point.state === "predicted" && point.reason) lines.push(sentence(point.reason));
  }
  if (isEarly(point)) lines.push([outcomeInWords(point.outcome ?? ""), point.advice ?? ""].join(" ").trim());
  if (point.is_best) lines.push("The best answer so far.");
  if (point.state !== "refused" && point.leaves_out.length > 0) lines.push(`Leaves out: ${point.leaves_out.join(", ")}.`);
  if (also.length > 0) lines.push(`Also answers ${also.join(", ")}.`);
  if (point.is_older) lines.push("Computed by an earlier version of the science.");
  return lines;
}

/** What a click does. */
export function actionOf(point: LadderPoint): string {
  if (point.job_id !== null) return "Is being computed";
  if (point.rung !== "fe") return point.state === "refused" ? "" : "Click to draw it";
  if (point.state === "measured") return "Click to show its answer";
  return point.state === "refused" ? "Click to run it again" : "Click to run it";
}
