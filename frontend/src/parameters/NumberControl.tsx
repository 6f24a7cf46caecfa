import type { Parameter } from "../api/types";
import { NumberField } from "../ui/NumberField";
import { Slider } from "../ui/Slider";
import { endGesture, setParameter } from "../workbench/workbench";
import { alignReach, reachOf } from "./reach";

interface NumberControlProps {
  parameter: Parameter;
  value: number;
  opened: number;
  invalid: boolean;
  describedBy: string | undefined;
}

/** Slider around the opened value and a number field over the full limits. */
export function NumberControl({ parameter, value, opened, invalid, describedBy }: NumberControlProps) {
  const reach = alignReach(reachOf(parameter, opened, value), opened);
  // A slider lands on sums like 7.300000000000001; the document shall hold 7.3.
  const take = (next: number) => setParameter(parameter.border_name, Number(next.toPrecision(10)));
  return (
    <>
      <Slider
        value={value}
        min={reach.min}
        max={reach.max}
        step={reach.step}
        mark={opened}
        label={parameter.label}
        onInput={take}
        onCommit={endGesture}
        testId={`slider-${parameter.name}`}
      />
      <NumberField
        value={value}
        step={reach.step}
        unit={parameter.unit}
        label={parameter.label}
        place={parameter.name}
        invalid={invalid}
        integer={parameter.kind === "count"}
        describedBy={describedBy}
        onCommit={(next) => {
          endGesture();
          take(next);
        }}
        testId={`field-${parameter.name}`}
      />
    </>
  );
}
