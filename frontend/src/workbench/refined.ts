/** The cell and rod, asked as soon as the hand rests: it takes over from the energy model until a
 * slider moves again. */
import { api, ApiProblem, messageOf, take } from "../api/client";
import { reconnections } from "../api/live";
import { Store } from "../api/store";
import type { Prediction } from "../api/types";
import type { Work } from "./document";
import { sceneOf } from "./loads";
import { followAtRest } from "./rest";
import { bench } from "./workbench";

export interface Refined {
  readonly prediction: Prediction | null;
  /** The work that `prediction` answers. */
  readonly answered: Work | null;
  /** Why there is none for what is on the bench, save a refusal of this question: the ladder says that. */
  readonly problem: string | null;
  readonly asking: boolean;
}

const NOTHING: Refined = { prediction: null, answered: null, problem: null, asking: false };

export const refined = new Store<Refined>(NOTHING);

const REST_MS = 600;
let under: AbortController | null = null;

function drop(): void {
  under?.abort();
  under = null;
  refined.update((now) => (now.asking || now.problem !== null ? { ...now, asking: false, problem: null } : now));
}

/** Asks at once for what is on the bench. */
export function askRefined(): void {
  const work = bench.get()?.present.work;
  if (work) void ask(work);
}

async function ask(work: Work): Promise<void> {
  drop();
  const mine = new AbortController();
  under = mine;
  refined.update((now) => ({ ...now, asking: true }));
  const body = { design: work.design, scene: sceneOf(work.loads, "auto"), rung: "cell-rod", c: "computed", beyond: "refuse" } as const;
  try {
    const prediction = await take(api.POST("/api/predict", { body, signal: mine.signal }));
    if (under === mine) refined.set({ prediction, answered: work, problem: null, asking: false });
  } catch (error) {
    // An aborted question was replaced by a newer one, which has its own answer.
    if (under !== mine) return;
    const refused = error instanceof ApiProblem && error.status === 422;
    const problem = refused ? null : messageOf(error);
    refined.set({ prediction: null, answered: null, problem, asking: false });
  }
}

/** Start following the bench; called once. */
export function followForRefined(): void {
  const again = followAtRest({ afterMs: REST_MS, onMove: drop, onRest: (work) => void ask(work) });
  reconnections.subscribe(again);
}
