/** The instant answer and the checked drawing of what is on the bench, asked anew at every change. */
import { api, ApiProblem, take } from "../api/client";
import { Lane } from "../api/lane";
import { reconnections } from "../api/live";
import { Store } from "../api/store";
import type { DesignCheck, LeftOut, Prediction, ProblemDetail, Result } from "../api/types";
import { dragging } from "../ui/dragging";
import { sameDesign, sameQuestion, type DesignDocument, type Work } from "./document";
import { sceneOf } from "./loads";
import { latestInput } from "./latency";
import { modelChoice, movingRung, type TypicalErrors } from "./model";
import { bench } from "./workbench";

export interface Answers {
  readonly result: Result | null;
  /** The work that `result` answers; differs from the bench while asking, or after a refusal. */
  readonly answered: Work | null;
  readonly input: number;
  readonly totalMs: number | null;
  /** How far off such answers typically are, at every point of `result`. */
  readonly typical: TypicalErrors;
  readonly check: DesignCheck | null;
  readonly checked: DesignDocument | null;
  /** What is wrong with the design on the bench, from either question. */
  readonly designProblem: ProblemDetail | null;
  readonly sceneProblem: ProblemDetail | null;
  /** What these two are about; differs from the bench while a mend of it is asked about. */
  readonly refusedDesign: DesignDocument | null;
  readonly refusedWork: Work | null;
  /** Why the instant model has no answer to a question that finite elements may answer. */
  readonly instantProblem: ProblemDetail | null;
  /** Loads that the instant model cannot carry: `result` does not hold them. */
  readonly leftOut: readonly LeftOut[];
  readonly unreachable: boolean;
}

const NOTHING: Answers = {
  result: null,
  answered: null,
  input: 0,
  totalMs: null,
  typical: [],
  check: null,
  checked: null,
  designProblem: null,
  sceneProblem: null,
  refusedDesign: null,
  refusedWork: null,
  instantProblem: null,
  leftOut: [],
  unreachable: false,
};

export const answers = new Store<Answers>(NOTHING);

/** Whether the design or its load cannot be answered as it stands. */
export function isRefused(now: Answers): boolean {
  return (now.designProblem ?? now.sceneProblem) !== null;
}

/** Whether the refusal is of what lay on the bench before: of what lies there now nobody knows yet. */
export function isRefusalOutdated(now: Answers, work: Work): boolean {
  if (now.designProblem !== null) return now.refusedDesign !== null && !sameDesign(now.refusedDesign, work.design);
  return now.sceneProblem !== null && now.refusedWork !== null && !sameQuestion(now.refusedWork, work);
}

interface Question {
  work: Work;
  input: number;
}

function asProblem(error: unknown): ProblemDetail | null {
  if (error instanceof ApiProblem) return error.detail;
  return null;
}

const predictions = new Lane<Question, Prediction>(
  ({ work }) => {
    const rung = movingRung(modelChoice.get());
    const body = { design: work.design, scene: sceneOf(work.loads), rung, c: "computed", beyond: "leave out" } as const;
    return take(api.POST("/api/predict", { body }));
  },
  ({ work, input }, answer) => {
    answers.update((now) => ({
      ...now,
      result: answer.result,
      answered: work,
      input,
      totalMs: answer.timings_ms.total ?? null,
      typical: answer.typical_errors,
      sceneProblem: null,
      instantProblem: null,
      leftOut: answer.left_out,
      unreachable: false,
    }));
    checkNext();
  },
  ({ work }, error) => {
    const problem = asProblem(error);
    const beyond = problem?.kind === "question";
    answers.update((now) => ({
      ...now,
      sceneProblem: beyond ? null : problem,
      refusedWork: work,
      instantProblem: beyond ? problem : null,
      unreachable: problem === null,
    }));
    checkNext();
  },
);

const checks = new Lane<DesignDocument, DesignCheck>(
  (design) => take(api.POST("/api/designs/check", { body: { design } })),
  (design, check) =>
    answers.update((now) => ({ ...now, check, checked: design, designProblem: null, unreachable: false })),
  (design, error) => {
    const problem = asProblem(error);
    answers.update((now) => ({ ...now, designProblem: problem, refusedDesign: design, unreachable: problem === null }));
  },
);

/** The drawing waits for the curve, and while a slider moves it follows at this distance: both are
 * computed by one process and drawn by one thread. */
const CHECK_WHILE_DRAGGING_MS = 400;
let unchecked: DesignDocument | null = null;
let lastCheck = 0;

function checkNext(): void {
  if (!unchecked || (dragging.get() && performance.now() - lastCheck < CHECK_WHILE_DRAGGING_MS)) return;
  lastCheck = performance.now();
  checks.ask(unchecked);
  unchecked = null;
}

dragging.subscribe(() => {
  if (!dragging.get() && !predictions.pending) checkNext();
});

let asked: Work | null = null;

function ask(again: boolean): void {
  const work = bench.get()?.present.work;
  if (!work) return;
  const before = again ? null : asked;
  asked = work;
  if (!before || !sameDesign(before.design, work.design)) unchecked = work.design;
  if (!before || !sameQuestion(before, work)) predictions.ask({ work, input: latestInput() });
  else checkNext();
}

/** Start following the bench; called once. */
export function followBench(): void {
  bench.subscribe(() => ask(false));
  reconnections.subscribe(() => ask(true));
  modelChoice.subscribe(() => ask(true));
  ask(false);
}

/** True while an instant answer or a drawing is on its way. */
export function isAsking(): boolean {
  return predictions.pending || checks.pending;
}

/** True when the plotted answer is not the answer to what is on the bench. */
export function isStale(now: Answers, work: Work): boolean {
  return now.answered === null || !sameQuestion(now.answered, work);
}
