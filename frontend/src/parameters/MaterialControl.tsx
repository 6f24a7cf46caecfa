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

/** After a material's key: the same rubber, exactly incompressible. */
const INCOMPRESSIBLE = "@incompressible";

export function MaterialControl({ parameter, value }: { parameter: Parameter; value: string }) {
  const { data: list } = useQuery(materials);
  const exact = value.endsWith(INCOMPRESSIBLE);
  const key = exact ? value.slice(0, -INCOMPRESSIBLE.length) : value;
  const chosen = list?.find((material) => material.key === key);
  const choose = (next: string, incompressible: boolean) =>
    setParameter(parameter.border_name, incompressible ? next + INCOMPRESSIBLE : next);
  return (
    <>
      <select
        className="select"
        aria-label={parameter.label}
        value={key}
        data-testid={`material-${parameter.name}`}
        onChange={(event) => choose(event.currentTarget.value, exact)}
      >
        {!chosen && <option value={key}>{key}</option>}
        {list?.map((material) => (
          <option key={material.key} value={material.key}>
            {material.name}
          </option>
        ))}
      </select>
      <p className="material-summary" title={chosen ? [chosen.source, chosen.note].filter(Boolean).join(". ") : ""}>
        {chosen ? materialSummary(chosen) : list ? "Not in the catalogue" : " "}
      </p>
      <label
        className="check incompressible"
        title="Volume is kept exactly, for comparison with theories that assume it. Otherwise kappa is 1000 mu, or what the record says."
      >
        <input
          type="checkbox"
          checked={exact}
          data-testid={`incompressible-${parameter.name}`}
          onChange={(event) => choose(key, event.currentTarget.checked)}
        />
        Exactly incompressible
      </label>
    </>
  );
}
