import type { ReactNode } from "react";

import { Problem, SeeOther } from "../parameters/Problem";
import { IconButton } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { Slider } from "../ui/Slider";
import { MathSymbol } from "../ui/Symbol";
import type { Triple } from "../workbench/loads";
import { endGesture } from "../workbench/workbench";
import type { SceneRows } from "./SceneGroup";
import type { ScenePlace } from "./places";

interface LoadRowProps extends SceneRows {
  place: ScenePlace;
  label: string;
  title?: string | undefined;
  symbol?: string | undefined;
  unit?: string | undefined;
  changed: boolean;
  kind?: "choice" | "vector" | "vector part" | "part";
  onReset?: (() => void) | undefined;
  onRemove?: (() => void) | undefined;
  children: ReactNode;
}

/** Name, control, and at the end what takes the load away, or its value back. */
export function LoadRow(props: LoadRowProps) {
  const { place, label, title, symbol, unit, changed, kind, onReset, onRemove, children } = props;
  const problem = props.problemAt(place);
  const elsewhere = props.elsewhereAt(place);
  return (
    <div
      className={`parameter ${kind ?? ""}${changed ? " changed" : ""}${problem ? " invalid" : ""}`}
      data-testid={`parameter-${place}`}
    >
      <span className="parameter-name" title={title}>
        <span className="parameter-label">{label}</span>
        {symbol && <MathSymbol symbol={symbol} />}
        {unit && <span className="unit">{unit}</span>}
      </span>
      {children}
      {onRemove ? (
        <IconButton className="reset" icon="close" size={11} label={`Take ${label.toLowerCase()} away`} data-testid={`remove-${place}`} onClick={onRemove} />
      ) : (
        <IconButton className="reset" icon="reset" size={13} label={`Reset ${label.toLowerCase()}`} disabled={!changed || !onReset} data-testid={`reset-${place}`} onClick={onReset} />
      )}
      {problem && <Problem id={`${place}-problem`} problem={problem} name={place} />}
      {elsewhere && <SeeOther name={elsewhere.name} label={elsewhere.label} />}
    </div>
  );
}

interface NumberRowProps extends SceneRows {
  place: ScenePlace;
  label: string;
  title?: string | undefined;
  symbol?: string | undefined;
  unit: string;
  value: number;
  /** Value the design was opened with; null where it had none. */
  opened: number | null;
  step: number;
  range: readonly [number, number];
  kind?: "part";
  onChange: (value: number) => void;
  onRemove?: (() => void) | undefined;
}

/** A load that is one number. */
export function NumberRow(props: NumberRowProps) {
  const { place, value, opened, step, range, label, unit, onChange } = props;
  const round = (next: number) => Number(next.toPrecision(10));
  return (
    <LoadRow {...props} unit="" changed={value !== opened} onReset={opened === null ? undefined : () => onChange(opened)} onRemove={props.onRemove}>
      <Slider
        value={value}
        min={Math.min(range[0], value)}
        max={Math.max(range[1], value)}
        step={step}
        mark={opened ?? undefined}
        label={label}
        onInput={(next) => onChange(round(next))}
        onCommit={endGesture}
        testId={`slider-${place}`}
      />
      <NumberField
        value={value}
        step={step}
        unit={unit}
        label={label}
        place={place}
        invalid={props.problemAt(place) !== null}
        describedBy={props.problemAt(place) ? `${place}-problem` : undefined}
        onCommit={(next) => {
          endGesture();
          onChange(round(next));
        }}
        testId={`field-${place}`}
      />
    </LoadRow>
  );
}

interface VectorRowProps extends SceneRows {
  place: ScenePlace;
  label: string;
  title?: string | undefined;
  unit: string;
  value: Triple;
  opened: Triple | null;
  step: number;
  kind?: "part";
  onChange: (value: Triple) => void;
  onRemove?: (() => void) | undefined;
}

const AXES = ["X₁", "X₂", "X₃"] as const;

/** A load with a direction: its three components. */
export function VectorRow(props: VectorRowProps) {
  const { place, value, opened, label, unit, step, onChange } = props;
  const problem = props.problemAt(place);
  const changed = opened === null || value.some((part, axis) => part !== opened[axis]);
  return (
    <LoadRow {...props} kind={props.kind === "part" ? "vector part" : "vector"} changed={changed} onReset={opened === null ? undefined : () => onChange(opened)} onRemove={props.onRemove}>
      {AXES.map((axis, index) => (
        <NumberField
          key={axis}
          value={value[index] ?? 0}
          step={step}
          unit={unit}
          prefix={axis}
          label={`${label}, ${axis}`}
          place={place}
          invalid={problem !== null}
          describedBy={problem ? `${place}-problem` : undefined}
          onCommit={(next) => {
            const [x, y, z] = value.map((part, each) => (each === index ? next : part));
            onChange([x ?? 0, y ?? 0, z ?? 0]);
          }}
          testId={`field-${place}-${index + 1}`}
        />
      ))}
    </LoadRow>
  );
}
