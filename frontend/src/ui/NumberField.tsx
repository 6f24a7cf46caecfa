import { useState } from "react";

import { formatNumber, parseNumber } from "./numbers";

interface NumberFieldProps {
  value: number;
  step: number;
  unit: string;
  label: string;
  invalid?: boolean;
  integer?: boolean;
  /** Id of the element that says what is wrong. */
  describedBy?: string | undefined;
  onCommit: (value: number) => void;
  onFocus?: () => void;
  testId?: string;
}

/** Text field for a number: Enter or leaving takes the value, Escape gives the old one back, the
 * arrow keys step (with Shift ten steps). */
export function NumberField(props: NumberFieldProps) {
  const [draft, setDraft] = useState<string | null>(null);
  const shown = draft ?? formatNumber(props.value);
  const unreadable = draft !== null && parseNumber(draft) === null;

  function take(text: string): void {
    const number = parseNumber(text);
    setDraft(null);
    if (number === null) return;
    const value = props.integer ? Math.round(number) : number;
    if (value !== props.value) props.onCommit(value);
  }

  function nudge(direction: number, large: boolean): void {
    const from = parseNumber(shown) ?? props.value;
    const next = from + direction * props.step * (large ? 10 : 1);
    setDraft(null);
    props.onCommit(Number(next.toPrecision(10)));
  }

  return (
    <span className={`number-field${props.invalid || unreadable ? " invalid" : ""}`}>
      <input
        type="text"
        inputMode="decimal"
        autoComplete="off"
        spellCheck={false}
        value={shown}
        aria-label={props.unit ? `${props.label} in ${props.unit}` : props.label}
        aria-invalid={props.invalid ?? unreadable}
        aria-describedby={props.describedBy}
        data-testid={props.testId}
        onFocus={(event) => {
          event.currentTarget.select();
          props.onFocus?.();
        }}
        onChange={(event) => setDraft(event.currentTarget.value)}
        onBlur={() => {
          if (draft !== null) take(draft);
        }}
        onKeyDown={(event) => {
          if (event.key === "Enter") take(shown);
          else if (event.key === "Escape") setDraft(null);
          else if (event.key === "ArrowUp" || event.key === "ArrowDown") {
            event.preventDefault();
            nudge(event.key === "ArrowUp" ? 1 : -1, event.shiftKey);
          }
        }}
      />
      {props.unit && <span className="unit">{props.unit === "deg" ? "°" : props.unit}</span>}
    </span>
  );
}
