/** The parameter in focus or under the pointer: what the drawing highlights. */
import { Store } from "../api/store";

interface Attention {
  readonly focused: string | null;
  readonly hovered: string | null;
}

export const attention = new Store<Attention>({ focused: null, hovered: null });

export function focusOn(name: string): void {
  attention.update((now) => (now.focused === name ? now : { ...now, focused: name }));
}

export function hover(name: string | null): void {
  attention.update((now) => (now.hovered === name ? now : { ...now, hovered: name }));
}

export function attended(now: Attention): string | null {
  return now.hovered ?? now.focused;
}
