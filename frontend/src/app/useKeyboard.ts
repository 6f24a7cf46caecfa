import { useEffect } from "react";

import { hindrance } from "../workbench/hindrance";
import { isChanged } from "../workbench/timeline";
import { frameIndex, scrubber, scrubToFrame, togglePlay } from "../workbench/scrubber";
import { bench, redo, undo } from "../workbench/workbench";
import { showToast } from "../ui/toasts";
import { layer } from "./layers";

function isTyping(target: EventTarget | null): boolean {
  if (!(target instanceof HTMLElement)) return false;
  if (target instanceof HTMLInputElement) return !["range", "checkbox", "radio"].includes(target.type);
  return target instanceof HTMLSelectElement || target instanceof HTMLTextAreaElement;
}

/** A number field in which nothing is being typed: undo is the bench's there. */
function isSettled(target: EventTarget | null): boolean {
  return target instanceof HTMLInputElement && target.dataset.settled === "true";
}

/** Space presses the button that has the focus; there it is not ours. */
function takesSpace(target: EventTarget | null): boolean {
  return target instanceof HTMLElement && (target.closest("button, a, input[type=checkbox], input[type=radio]") !== null);
}

function openSave(): void {
  const present = bench.get()?.present;
  if (!present) return;
  const hindered = hindrance();
  if (hindered !== null) {
    showToast({ tone: "info", text: hindered });
  } else if (present.origin.kind === "version" && !isChanged(present)) {
    showToast({ tone: "info", text: `Nothing has changed since v${present.origin.number}.` });
  } else layer.set("save");
}

function step(by: number): void {
  const state = scrubber.get();
  const next = Math.min(state.frames.length - 1, Math.max(0, frameIndex(state) + by));
  scrubToFrame(next);
}

const SINGLE: Record<string, () => void> = {
  " ": togglePlay,
  h: () => layer.set("history"),
  "?": () => layer.set("keys"),
  ",": () => step(-1),
  ".": () => step(1),
};

function onKey(event: KeyboardEvent): void {
  const command = event.ctrlKey || event.metaKey;
  const key = event.key.toLowerCase();
  if (command && key === "s") {
    event.preventDefault();
    if (layer.get() === "none") openSave();
    return;
  }
  if (layer.get() !== "none" || document.querySelector("dialog[open]")) return;
  if (command && (key === "z" || key === "y") && (!isTyping(event.target) || isSettled(event.target))) {
    event.preventDefault();
    if (key === "y" || event.shiftKey) redo();
    else undo();
    return;
  }
  if (command || event.altKey || isTyping(event.target)) return;
  const act = SINGLE[key];
  if (!act || (key === " " && takesSpace(event.target))) return;
  // Or the letter that opens a layer would be typed into its first field.
  event.preventDefault();
  act();
}

export function useKeyboard(): void {
  useEffect(() => {
    window.addEventListener("keydown", onKey);
    return () => window.removeEventListener("keydown", onKey);
  }, []);
}
