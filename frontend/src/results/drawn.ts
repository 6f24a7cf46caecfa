/** Which instant answer the plots and numbers show. */
import { useStore, usePick } from "../api/store";
import type { LeftOut, Result } from "../api/types";
import { answers, type Answers } from "../workbench/answers";
import { sameQuestion, type Work } from "../workbench/document";
import { modelChoice, type ModelChoice, type TypicalErrors } from "../workbench/model";
import { refined, type Refined } from "../workbench/refined";
import { bench } from "../workbench/workbench";

export interface Drawn {
  result: Result;
  /** The question that it answers. */
  answered: Work;
  typical: TypicalErrors;
  /** Loads of the scene that it does not hold. */
  leftOut: readonly LeftOut[];
  totalMs: number | null;
  /** The answer that it has replaced; kept in the plots, paler. */
  replaced: Result | null;
}

/** The cell and rod where it answers the very question on the bench, else what answers while the
 * hand moves; null where there is neither. */
export function drawnOf(now: Answers, finer: Refined, work: Work | null, choice: ModelChoice): Drawn | null {
  const moving = now.instantProblem === null ? now.result : null;
  const { prediction, answered } = finer;
  const fits = prediction !== null && answered !== null && work !== null && sameQuestion(answered, work);
  if (choice === "auto" && fits && prediction.result.path.length > 1) {
    return {
      result: prediction.result,
      answered,
      typical: prediction.typical_errors,
      leftOut: prediction.left_out,
      totalMs: prediction.timings_ms.total ?? null,
      replaced: now.answered !== null && sameQuestion(now.answered, work) ? moving : null,
    };
  }
  if (moving === null || now.answered === null) return null;
  const { answered: asked, typical, leftOut, totalMs } = now;
  return { result: moving, answered: asked, typical, leftOut, totalMs, replaced: null };
}

export function useDrawn(): Drawn | null {
  const now = useStore(answers);
  const finer = useStore(refined);
  const choice = useStore(modelChoice);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  return drawnOf(now, finer, work, choice);
}
