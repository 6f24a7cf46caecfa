import { useQuery } from "@tanstack/react-query";

import { materials } from "../api/queries";
import type { Material, Parameter } from "../api/types";
import { formatQuantity } from "../ui/numbers";
import { setParameter } from "../workbench/workbench";

const MODELS: Record<string, string> = {
  linear: "Linear",
  "neo-hooke": "Neo-Hooke",
  yeoh: "Yeoh",
  ogden: "Ogden",
  "mooney-rivlin": "Mooney-Rivlin",
};

export function materialSummary(material: Material): string {
  const density = formatQuantity(material.density_kg_m3 / 1000);
  const model = MODELS[material.model.toLowerCase()] ?? material.model;
  return `${model}, E = ${formatQuantity(material.youngs_modulus_kPa, 4)} kPa, ${density} g/cm³`;
}

export function MaterialControl({ parameter, value }: { parameter: Parameter; value: string }) {
  const { data: list } = useQuery(materials);
  const chosen = list?.find((material) => material.key === value);
  return (
    <>
      <select
        className="select"
        aria-label={parameter.label}
        value={value}
        data-testid={`material-${parameter.name}`}
        onChange={(event) => setParameter(parameter.border_name, event.currentTarget.value)}
      >
        {!chosen && <option value={value}>{value}</option>}
        {list?.map((material) => (
          <option key={material.key} value={material.key}>
            {material.name}
          </option>
        ))}
      </select>
      <p className="material-summary" title={chosen ? [chosen.source, chosen.note].filter(Boolean).join(". ") : ""}>
        {chosen ? materialSummary(chosen) : list ? "Not in the catalogue" : " "}
      </p>
    </>
  );
}
