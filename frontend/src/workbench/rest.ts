/** What is asked only once the hand rests, so that it never delays the answer to a moving slider. */
import { dragging } from "../ui/dragging";
import { answers, isAsking, isRefused } from "./answers";
import { sameQuestion, type Work } from "./document";
import { bench } from "./workbench";

const AGAIN_MS = 60;

interface AtRest {
  /** Without a change of the question. */
  afterMs: number;
  /** Called at once when the question changes: what was asked before is no longer wanted. */
  onMove?: () => void;
  onRest: (work: Work) => void;
  /** Called instead where the question is refused already. */
  onRefused?: () => void;
}

/** Follows the bench; the function returned asks again for what lies on it, after the same rest. */
export function followAtRest({ afterMs, onMove, onRest, onRefused }: AtRest): () => void {
  let before: Work | null = null;
  let timer = 0;

  function rest(): void {
    const work = bench.get()?.present.work;
    if (!work) return;
    if (dragging.get() || isAsking()) {
      timer = window.setTimeout(rest, AGAIN_MS);
      return;
    }
    // Of what is known to be refused nobody has more to say; its mend is a change of the question.
    if (isRefused(answers.get())) onRefused?.();
    else onRest(work);
  }

  function wait(): void {
    window.clearTimeout(timer);
    timer = window.setTimeout(rest, afterMs);
  }

  function follow(): void {
    const work = bench.get()?.present.work ?? null;
    if (work === null || (before && sameQuestion(before, work))) return;
    before = work;
    onMove?.();
    wait();
  }

  bench.subscribe(follow);
  follow();
  return wait;
}
