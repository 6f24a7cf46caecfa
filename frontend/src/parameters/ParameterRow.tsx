import { memo, useId, type ReactNode } from "react";

import type { Parameter, ProblemDetail } from "../api/types";
import { IconButton } from "../ui/Button";
import { MathSymbol } from "../ui/Symbol";
import { spell, type Value } from "../workbench/document";
import { setParameter } from "../workbench/workbench";
import { focusOn, hover } from "./attention";
import { ChoiceControl } from "./ChoiceControl";
import { MaterialControl } from "./MaterialControl";
import { NumberControl } from "./NumberControl";
import { Problem, SeeOther } from "./Problem";

interface RowProps {
  parameter: Parameter;
  value: Value;
  opened: Value;
  problem: ProblemDetail | null;
  /** The field that is refused after this one was edited. */
  elsewhere: { name: string; label: string } | null;
}

/** One parameter: name, control, and what is wrong with it. */
export const ParameterRow = memo(function ParameterRow(props: RowProps) {
  const { parameter, value, opened, problem, elsewhere } = props;
  const id = useId();
  const changed = value !== opened;
  const describedBy = problem ? `${id}-problem` : undefined;
  return (
    <div
      className={`parameter ${parameter.kind}${changed ? " changed" : ""}${problem ? " invalid" : ""}`}
      data-testid={`parameter-${parameter.name}`}
      onPointerEnter={() => hover(parameter.name)}
      onPointerLeave={() => hover(null)}
      onFocus={() => focusOn(parameter.name)}
    >
      <RowName parameter={parameter} />
      {controlOf(props, describedBy)}
      <IconButton
        className="reset"
        icon="reset"
        size={13}
        label={`Reset to ${spell(parameter, opened)}`}
        disabled={!changed}
        data-testid={`reset-${parameter.name}`}
        onClick={() => setParameter(parameter.border_name, opened)}
      />
      {problem && <Problem id={`${id}-problem`} problem={problem} name={parameter.name} />}
      {elsewhere && <SeeOther name={elsewhere.name} label={elsewhere.label} />}
    </div>
  );
});

function RowName({ parameter }: { parameter: Parameter }) {
  return (
    <span className="parameter-name" title={[parameter.label, parameter.help].filter(Boolean).join(": ")}>
      <span className="parameter-label">{parameter.label}</span>
      <MathSymbol symbol={parameter.symbol} />
      {parameter.assumed && (
        <abbr className="assumed" title={`Assumed: ${parameter.assumed}`} data-testid={`assumed-${parameter.name}`}>
          <span aria-hidden="true">a</span>
          <span className="visually-hidden">assumed</span>
        </abbr>
      )}
    </span>
  );
}

function controlOf({ parameter, value, opened, problem }: RowProps, describedBy: string | undefined): ReactNode {
  if (parameter.kind === "choice") return <ChoiceControl parameter={parameter} value={String(value)} />;
  if (parameter.kind === "material") return <MaterialControl parameter={parameter} value={String(value)} />;
  return (
    <NumberControl
      parameter={parameter}
      value={Number(value)}
      opened={Number(opened)}
      invalid={problem !== null}
      describedBy={describedBy}
    />
  );
}
