import { useStore } from "../api/store";
import type { Result } from "../api/types";
import { ladder } from "../ladder/ask";
import { effectName } from "../scene/effectPlan";
import { Icon } from "../ui/Icon";
import { sentence } from "../ui/numbers";
import { sameQuestion } from "../workbench/document";
import type { Control } from "../workbench/loads";
import { modelName } from "../workbench/model";
import type { Drawn } from "./drawn";
import { offInWords } from "./off";

interface TypicalProps {
  drawn: Drawn;
  control: Control;
  /** Place on the path; null stands for its end. */
  at: number | null;
}

/** How far off the answer drawn is from 3D. */
export function Typical({ drawn, control, at }: TypicalProps) {
  const { result } = drawn;
  const state = useStore(ladder);
  const fits = state.answered !== null && sameQuestion(state.answered, drawn.answered);
  const held = fits ? state.ladder?.points.find((point) => point.rung === result.rung) : undefined;
  const off = offInWords(drawn, at, control, held);
  // what the validation page says of this family against experiments stands among its assumptions
  const measured = result.assumptions.find((each) => each.includes("docs/validation.md"));
  if (off === null && measured === undefined) return null;
  return (
    <span className="typical" data-testid="typical-error" title={off?.title}>
      {modelName(result.rung)}: {off?.text}
      {measured !== undefined && (
        <em className="not-measured" title={sentence(measured)} data-testid="known-mismatch">
          {off === null ? "" : "; "}bodies that were measured differ far more, see the notes
        </em>
      )}
    </span>
  );
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
