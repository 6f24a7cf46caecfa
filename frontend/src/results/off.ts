/** How far an instant answer is off from 3D, in words. */
import type { LadderPoint, Result } from "../api/types";
import { isBeyondTrust, placeOf, trustedPlace } from "../charts/curve";
import { ANYWHERE, errorInWords, inWords } from "../ladder/points";
import { formatPercent, sentence } from "../ui/numbers";
import type { Control } from "../workbench/loads";
import type { TypicalErrors } from "../workbench/model";
import type { Drawn } from "./drawn";
import { kPa, placeInWords } from "./words";

export interface Off {
  text: string;
  title: string;
}

/** At a place of the path, null standing for its end; null where nothing can be said, or where the
 * range's own mark says it. `held`: the drawn rung's point of the ladder for this very question. */
export function offInWords(drawn: Drawn, at: number | null, control: Control, held: LadderPoint | null = null): Off | null {
  const { result } = drawn;
  const last = result.path.length - 1;
  const here = at === null ? last : nearestPoint(result, at, control);
  if (result.rung === "cell-rod") return held?.error_kind === "against best" ? measured(held, result) : estimated(result, here, control);
  return drawn.leftOut.length > 0 || isBeyond(result, here, control) ? null : typically(drawn, here, last, control);
}

/** The whole way of the tip over what inflation makes of it, from which on it is said what an error of the way means
 * for that (docs/theory.md: loads come first, then inflation). */
const MOSTLY_SAG = 2;

/** ", up to 940 % of what inflation does" where the loads before inflation make most of the tip's way; else nothing. */
function ofInflation(result: Result, percent: number): string {
  const tips = result.path.map((point) => point.tip_displacement_mm.map((x) => x ?? 0));
  const start = tips[0] ?? [0, 0, 0];
  const way = Math.max(0, ...tips.map((tip) => Math.hypot(...tip)));
  const inflation = Math.max(0, ...tips.map((tip) => Math.hypot(...tip.map((x, n) => x - (start[n] ?? 0)))));
  if (inflation === 0 || way < MOSTLY_SAG * inflation) return "";
  const share = formatPercent((percent * way) / inflation);
  return `, ${/^\d/.test(share) ? `up to ${share}` : share} of what inflation does`;
}

function measured(point: LadderPoint, result: Result): Off | null {
  if (point.error_percent === null) return null;
  const at = point.compared_at_kPa === null ? "" : ` at ${kPa(point.compared_at_kPa)}`;
  return {
    text: `${formatPercent(point.error_percent.value)} from ${inWords(point.error_source ?? "the best answer")}${at}${ofInflation(result, point.error_percent.value)}`,
    title: `Of the tip's displacement: ${sentence(errorInWords(point))}`,
  };
}

function estimated(result: Result, here: number, control: Control): Off | null {
  const percent = result.error_estimate_percent;
  if (percent === null) return null;
  const title = "Of the tip's displacement: the most that such bodies were off from 3D. No bound.";
  if (percent < ANYWHERE) return { text: `within ${formatPercent(percent)} of 3D by its own estimate${ofInflation(result, percent)}`, title };
  const trusted = trustedPlace(result, control);
  if (trusted === null) return { text: "may be anywhere by its own estimate", title: "Its notes say why." };
  if (isBeyond(result, here, control)) return null;
  return { text: `may be anywhere beyond ${placeInWords(trusted, control)}`, title: "Its notes say how far off it may be before." };
}

/** As designs alike were, at the place looked at and at the end of the path. */
function typically({ result, typical }: Drawn, here: number, last: number, control: Control): Off | null {
  const [now, end] = [typical[here] ?? null, isBeyond(result, last, control) ? null : (typical[last] ?? null)];
  const source = (now ?? end)?.source;
  if (source === undefined) return null;
  const parts = [
    now === null ? "not measured here" : `typically ${offBy(now.four_of_five_below_percent)} of 3D here`,
    here === last ? "" : atEnd(result, last, end, control),
  ];
  return { text: parts.filter(Boolean).join(", "), title: `Of the tip's displacement: four of five such designs lie within it. ${source}` };
}

function atEnd(result: Result, last: number, end: TypicalErrors[number], control: Control): string {
  const place = result.path[last] && placeOf(result.path[last], control);
  if (typeof place !== "number") return "";
  const where = placeInWords(place, control);
  if (isBeyond(result, last, control)) return `beyond its range at ${where}`;
  return end === null ? `not measured at ${where}` : `${formatPercent(end.four_of_five_below_percent)} at ${where}`;
}

function isBeyond(result: Result, index: number, control: Control): boolean {
  const place = result.path[index] && placeOf(result.path[index], control);
  return typeof place === "number" && isBeyondTrust(result, place, control);
}

function offBy(percent: number): string {
  const most = formatPercent(percent);
  return /^\d/.test(most) ? `within ${most}` : `off by ${most}`;
}

/** Index of the point of the path nearest to a place on it. */
export function nearestPoint(result: Result, at: number, control: Control): number {
  let best = 0;
  let distance = Infinity;
  result.path.forEach((point, index) => {
    const place = placeOf(point, control);
    if (place === null || Math.abs(place - at) >= distance) return;
    distance = Math.abs(place - at);
    best = index;
  });
  return best;
}
