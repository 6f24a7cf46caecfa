import type { Result } from "../api/types";
import { isBeyondTrust, placeOf } from "../charts/curve";
import { effectName } from "../scene/effectPlan";
import { Icon } from "../ui/Icon";
import { formatPercent, sentence } from "../ui/numbers";
import type { Control } from "../workbench/loads";
import { modelName, type TypicalErrors } from "../workbench/model";
import type { Drawn } from "./drawn";
import { placeInWords } from "./words";

interface TypicalProps {
  drawn: Drawn;
  control: Control;
  /** Place on the path; null stands for its end. */
  at: number | null;
}

/** How far off such answers typically are: at the place looked at, and at the end of the path. */
export function Typical({ drawn, control, at }: TypicalProps) {
  const { result } = drawn;
  const last = result.path.length - 1;
  const here = at === null ? last : nearestPoint(result, at, control);
  const errors = [typicalAt(drawn, here, control), typicalAt(drawn, last, control)] as const;
  const [now, end] = errors;
  const source = (now ?? end)?.source;
  // what the validation page says of this family against experiments stands among its assumptions
  const measured = result.assumptions.find((each) => each.includes("docs/validation.md"));
  if (source === undefined) return null;
  const endPlace = result.path[last] && placeOf(result.path[last], control);
  const parts = [
    now === null ? "not measured here" : `typically ${offBy(now.four_of_five_below_percent)} of 3D here`,
    here === last || typeof endPlace !== "number"
      ? ""
      : end === null
        ? `not measured at ${placeInWords(endPlace, control)}`
        : `${formatPercent(end.four_of_five_below_percent)} at ${placeInWords(endPlace, control)}`,
  ];
  return (
    <span
      className="typical"
      data-testid="typical-error"
      title={`Of the tip's displacement: four of five such designs lie within it. ${source}`}
    >
      {modelName(result.rung)}: {parts.filter(Boolean).join(", ")}
      {measured !== undefined && (
        <em className="not-measured" title={sentence(measured)} data-testid="known-mismatch">
          {"; "}bodies that were measured differ far more, see the notes
        </em>
      )}
    </span>
  );
}

/** Beyond its own range the cell and rod may be off by anything, whatever others of its kind were. */
function typicalAt({ result, typical }: Drawn, index: number, control: Control): TypicalErrors[number] {
  const place = result.path[index] && placeOf(result.path[index], control);
  const beyond = result.rung === "cell-rod" && typeof place === "number" && isBeyondTrust(result, place, control);
  return beyond ? null : (typical[index] ?? null);
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

/** What was switched by hand in the answers shown. */
export function Forced({ results }: { results: readonly (Result | null)[] }) {
  const named = new Set(
    results.flatMap((result) => result?.effects ?? []).flatMap((effect) => (effect.forced === "auto" ? [] : [`${effectName(effect.name).toLowerCase()} ${effect.forced}`])),
  );
  if (named.size === 0) return null;
  return (
    <span className="stale-mark" title="Chosen by hand under Effects, not decided by the studio" data-testid="forced-effects">
      <Icon name="edit" size={11} /> By hand: {[...named].join(", ")}
    </span>
  );
}
