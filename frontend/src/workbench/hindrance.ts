/** Why what the page shows cannot be kept or computed as it stands. */
import { usePick } from "../api/store";
import { unreadable, type Unreadable } from "../ui/drafts";
import { answers, isRefusalOutdated, isRefused, type Answers } from "./answers";
import type { Work } from "./document";
import { bench } from "./workbench";

function inWords(fields: readonly Unreadable[]): string | null {
  const [first] = fields;
  return first ? `${first.label} cannot be read. ${first.words}` : null;
}

function ofRefusal(now: Answers, work: Work | null): string | null {
  if (!isRefused(now)) return null;
  const checked = work === null || !isRefusalOutdated(now, work);
  return checked ? "Correct the marked parameter first." : "The change is being checked.";
}

function onBench(): Work | null {
  return bench.get()?.present.work ?? null;
}

/** A text that is no number comes first: the bench holds another value than the field shows. */
export function hindrance(): string | null {
  return inWords(unreadable.get()) ?? ofRefusal(answers.get(), onBench());
}

export function useHindrance(): string | null {
  const text = usePick(unreadable, inWords);
  const work = usePick(bench, onBench);
  const refusal = usePick(answers, (now) => ofRefusal(now, work));
  return text ?? refusal;
}
