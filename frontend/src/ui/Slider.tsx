import type { CSSProperties } from "react";

import { dragging } from "./dragging";

interface SliderProps {
  value: number;
  min: number;
  max: number;
  step: number;
  /** Value marked on the track: where the design was opened. */
  mark?: number | undefined;
  label: string;
  onInput: (value: number) => void;
  onCommit?: () => void;
  onFocus?: () => void;
  testId?: string;
  disabled?: boolean;
}

function share(value: number, min: number, max: number): number {
  return max > min ? Math.min(1, Math.max(0, (value - min) / (max - min))) : 0;
}

export function Slider(props: SliderProps) {
  const { value, min, max, step, mark } = props;
  const style = {
    "--fill": share(value, min, max),
    "--mark": mark === undefined ? -1 : share(mark, min, max),
  } as CSSProperties;
  return (
    <span className={mark === undefined ? "slider" : "slider marked"} style={style}>
      <input
        type="range"
        min={min}
        max={max}
        step={step}
        value={value}
        aria-label={props.label}
        data-testid={props.testId}
        disabled={props.disabled ?? false}
        onInput={(event) => props.onInput(event.currentTarget.valueAsNumber)}
        onChange={() => undefined}
        onPointerDown={() => dragging.set(true)}
        onLostPointerCapture={() => dragging.set(false)}
        onPointerCancel={() => dragging.set(false)}
        onPointerUp={() => {
          dragging.set(false);
          props.onCommit?.();
        }}
        onKeyUp={props.onCommit}
        onFocus={props.onFocus}
      />
    </span>
  );
}
