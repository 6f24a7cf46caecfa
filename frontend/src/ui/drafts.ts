/** What is being typed into number fields: which texts cannot be read, and when all are dropped. */
import { Store } from "../api/store";

/** A field whose text is no number of its kind. */
export interface Unreadable {
  readonly label: string;
  /** Entry of the design or its load that the field edits. */
  readonly place: string | undefined;
  /** What to write instead. */
  readonly words: string;
  /** Whether the field says so already: after Enter, or when it was left. */
  readonly said: boolean;
}

/** In the order in which they became so. */
export const unreadable = new Store<readonly Unreadable[]>([]);

/** Adds a field; the function returned takes it out again. */
export function markUnreadable(field: Unreadable): () => void {
  unreadable.update((now) => [...now, field]);
  return () => unreadable.update((now) => now.filter((other) => other !== field));
}

/** Counts the times that all that was typed was dropped. */
export const occasion = new Store(0);

/** What was typed belonged to what stood on the bench before. */
export function dropDrafts(): void {
  occasion.update((count) => count + 1);
}
