/** Why what the page shows cannot be kept or computed as it stands. */
import { usePick } from "../api/store";
import { unreadable, type Unreadable } from "../ui/drafts";
import { answers, isRefused, type Answers } from "./answers";

function inWords(fields: readonly Unreadable[]): string | null {
  const [first] = fields;
  return first ? `${first.label} cannot be read. ${first.words}` : null;
}

function ofRefusal(now: Answers): string | null {
  return isRefused(now) ? "Correct the marked parameter first." : null;
}

/** A text that is no number comes first: the bench holds another value than the field shows. */
export function hindrance(): string | null {
  return inWords(unreadable.get()) ?? ofRefusal(answers.get());
}

export function useHindrance(): string | null {
  const text = usePick(unreadable, inWords);
  const refusal = usePick(answers, ofRefusal);
  return text ?? refusal;
}
