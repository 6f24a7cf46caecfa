import { useQuery } from "@tanstack/react-query";

import { presets } from "../api/queries";
import type { Parameter } from "../api/types";
import { capital } from "../ui/numbers";
import { Segmented } from "../ui/Segmented";
import { bench, setParameter, setParameters } from "../workbench/workbench";
import { densityOf, densityValues } from "./density";

export function ChoiceControl({ parameter, value }: { parameter: Parameter; value: string }) {
  const { data: list = [] } = useQuery(presets);

  function choose(next: string): void {
    const design = bench.get()?.present.work.design;
    // A slab of low or high density keeps its density when its planform changes.
    const density = design?.family === "slab" && parameter.name === "planform" ? densityOf(list, design) : "own";
    const values = density === "own" ? null : densityValues(list, next, density);
    if (values) setParameters(parameter.border_name, { ...values, [parameter.border_name]: next });
    else setParameter(parameter.border_name, next);
  }

  return (
    <Segmented
      label={parameter.label}
      options={parameter.choices.map((choice) => ({ value: choice, label: capital(choice) }))}
      value={value}
      onChange={choose}
      testId={`choice-${parameter.name}`}
    />
  );
}
