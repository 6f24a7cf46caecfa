import { useEffect, useId, useState } from "react";

import { useStore } from "../api/store";
import { markUnreadable, occasion } from "./drafts";
import { formatNumber, grouped } from "./numbers";
import { parseQuantity, refusalOf } from "./quantity";

interface NumberFieldProps {
  value: number;
  step: number;
  unit: string;
  /** Shown before the number in place of the unit after it: the axis of a component. */
  prefix?: string;
  label: string;
  /** Entry that the field edits, where there is more to say about it than the field does. */
  place?: string;
  invalid?: boolean;
  integer?: boolean;
  /** Bounds that the field itself keeps to: above this, and at most that. */
  above?: number;
  most?: number;
  /** Not of the design or its loads: a text that cannot be taken hinders nothing. */
  standsAside?: boolean;
  /** Id of the element that says what is wrong. */
  describedBy?: string | undefined;
  onCommit: (value: number) => void;
  onFocus?: () => void;
  testId?: string;
}

/** What is being typed, over which value and on which occasion, and whether it was tried and could not be taken. */
interface Draft {
  text: string;
  over: number;
  on: number;
  refused: boolean;
}

/** What to say where a number lies outside the field's own bounds; null where it does not. */
function boundRefusal(text: string, { unit, above, most }: NumberFieldProps): string | null {
  const value = parseQuantity(text, unit);
  if (value === null) return null;
  const low = above !== undefined && value <= above;
  if (!low && (most === undefined || value <= most)) return null;
  const bounds = [above === undefined ? "" : `above ${formatNumber(above)}`, most === undefined ? "" : `at most ${grouped(formatNumber(most))} ${unit}`];
  return `Must be ${bounds.filter(Boolean).join(" and ")}.`;
}

/** Text field for a number, or a number with a unit: Enter or leaving takes the value, Escape or
 * undo gives the old one back, the arrow keys step (with Shift ten steps). What cannot be read stays, marked. */
export function NumberField(props: NumberFieldProps) {
  const [kept, setDraft] = useState<Draft | null>(null);
  const id = useId();
  const on = useStore(occasion);
  // A value that came from elsewhere (slider, undo) ends what was being typed, and so does another design.
  const draft = kept?.over === props.value && kept.on === on ? kept : null;
  const shown = draft?.text ?? formatNumber(props.value);
  const refuse = (text: string) => refusalOf(text, props.unit, props.integer ?? false) ?? boundRefusal(text, props);
  const refusal = draft && refuse(draft.text);
  const said = draft?.refused ? refusal : null;
  const { label, place, standsAside = false } = props;

  useEffect(() => {
    if (refusal === null || standsAside) return;
    return markUnreadable({ label, place, words: refusal, said: said !== null });
  }, [label, place, refusal, said, standsAside]);

  function take(): void {
    if (!draft) return;
    const value = parseQuantity(draft.text, props.unit);
    if (refusal !== null || value === null) {
      setDraft({ ...draft, refused: true });
      return;
    }
    setDraft(null);
    if (value !== props.value) props.onCommit(value);
  }

  function nudge(direction: number, large: boolean): void {
    const from = parseQuantity(shown, props.unit) ?? props.value;
    const next = Number((from + direction * props.step * (large ? 10 : 1)).toPrecision(10));
    const text = formatNumber(next);
    const beyond = boundRefusal(text, props) !== null;
    setDraft(beyond ? { text, over: props.value, on, refused: true } : null);
    if (!beyond) props.onCommit(next);
  }

  const field = (
    <span className={`number-field${props.invalid || refusal ? " invalid" : ""}`}>
      {props.prefix && <span className="unit prefix">{props.prefix}</span>}
      <input
        type="text"
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        value={shown}
        aria-label={props.unit ? `${props.label} in ${props.unit}` : props.label}
        aria-invalid={(props.invalid ?? false) || refusal !== null}
        aria-describedby={[props.describedBy, said && id].filter(Boolean).join(" ") || undefined}
        data-testid={props.testId}
        data-settled={draft === null}
        onFocus={(event) => {
          event.currentTarget.select();
          props.onFocus?.();
        }}
        onChange={(event) => {
          // Once refused, the words stand until the text is mended.
          setDraft({ text: event.currentTarget.value, over: props.value, on, refused: draft?.refused ?? false });
        }}
        onBlur={take}
        onKeyDown={(event) => {
          if ((event.ctrlKey || event.metaKey) && event.key.toLowerCase() === "z" && draft) {
            // The browser's own undo knows values that the page has put there, and mixes them up.
            event.preventDefault();
            event.stopPropagation();
            setDraft(null);
          } else if (event.key === "Enter") take();
          else if (event.key === "Escape") setDraft(null);
          else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
            event.preventDefault();
            nudge(event.key === "ArrowUp" ? 1 : -1, event.shiftKey);
          }
        }}
      />
      {props.unit && !props.prefix && <span className="unit">{props.unit === "deg" ? "°" : props.unit}</span>}
    </span>
  );
  return (
    <>
      {field}
      {said && (
        <p className="field-refusal" id={id} role="alert">
          {said}
        </p>
      )}
    </>
  );
}
