/** Error against seconds for what is on the bench: asked when the hand rests, and again when
 * something of it may have changed. */
import { api, messageOf, take } from "../api/client";
import { Lane } from "../api/lane";
import { onJobEnd, reconnections } from "../api/live";
import { Store } from "../api/store";
import type { Ladder } from "../api/types";
import { onJobSent } from "../jobs/submit";
import type { Work } from "../workbench/document";
import { sceneOf } from "../workbench/loads";
import { refined } from "../workbench/refined";
import { followAtRest } from "../workbench/rest";
import { limits, type Limits } from "./limits";

export interface LadderState {
  readonly ladder: Ladder | null;
  /** The work that `ladder` is about. */
  readonly answered: Work | null;
  /** The limits that its choices keep to. */
  readonly asked: Limits | null;
  readonly asking: boolean;
  readonly problem: string | null;
}

export const ladder = new Store<LadderState>({ ladder: null, answered: null, asked: null, asking: true, problem: null });

interface Question {
  work: Work;
  asked: Limits;
}

const ladders = new Lane<Question, Ladder>(
  ({ work: { design, loads }, asked: { percent, seconds } }) => {
    // The cell and rod is asked for by itself; what it answered is known to the ladder.
    const run = ["closed-form", "energy"];
    const body = { design, scene: sceneOf(loads, "auto"), run, at_most_percent: [percent], at_most_s: [seconds] };
    return take(api.POST("/api/ladder", { body }));
  },
  ({ work, asked }, answer) => ladder.set({ ladder: answer, answered: work, asked, asking: false, problem: null }),
  (_, error) => ladder.update((now) => ({ ...now, asking: false, problem: messageOf(error) })),
);

const REST_MS = 350;
const REFUSED = "Correct the marked parameter first.";

/** Start following the bench; called once. */
export function followForLadder(): void {
  const again = followAtRest({
    afterMs: REST_MS,
    // What was wrong with the question before is not wrong with this one, as far as anybody knows.
    onMove: () => ladder.update((now) => ({ ...now, asking: true, problem: null })),
    onRest: (work) => ladders.ask({ work, asked: limits.get() }),
    onRefused: () => ladder.update((now) => ({ ...now, asking: false, problem: REFUSED })),
  });
  limits.subscribe(again);
  reconnections.subscribe(again);
  onJobEnd.add(again);
  onJobSent.add(again);
  let asked = refined.get().asking;
  refined.subscribe(() => {
    const { asking } = refined.get();
    if (asked && !asking) again();
    asked = asking;
  });
}
