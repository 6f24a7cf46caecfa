import { useEffect, useId, useState } from "react";

import { useStore } from "../api/store";
import { markUnreadable, occasion } from "./drafts";
import { formatNumber } from "./numbers";
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

/** Text field for a number, or a number with a unit: Enter or leaving takes the value, Escape or
 * undo gives the old one back, the arrow keys step (with Shift ten steps). What cannot be read stays, marked. */
export function NumberField(props: NumberFieldProps) {
  const [kept, setDraft] = useState<Draft | null>(null);
  const id = useId();
  const on = useStore(occasion);
  // A value that came from elsewhere (slider, undo) ends what was being typed, and so does another design.
  const draft = kept?.over === props.value && kept.on === on ? kept : null;
  const shown = draft?.text ?? formatNumber(props.value);
  const refusal = draft && refusalOf(draft.text, props.unit, props.integer ?? false);
  const said = draft?.refused ? refusal : null;
  const { label, place } = props;

  useEffect(() => {
    if (refusal === null) return;
    return markUnreadable({ label, place, words: refusal, said: said !== null });
  }, [label, place, refusal, said]);

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
    const next = from + direction * props.step * (large ? 10 : 1);
    setDraft(null);
    props.onCommit(Number(next.toPrecision(10)));
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
