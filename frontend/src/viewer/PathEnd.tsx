import { usePick } from "../api/store";
import type { Result } from "../api/types";
import { useDrawn } from "../results/drawn";
import { useShownFe } from "../results/shown";
import { earlyEnd } from "../results/words";
import { Icon } from "../ui/Icon";
import { readLoads } from "../workbench/loads";
import { modelName } from "../workbench/model";
import { useSource } from "./source";
import { view } from "./view";

/** Over the 3D view, where the path shown ended early: how far it was found, why, and what to do. */
export function PathEnd() {
  const fe = useShownFe();
  const drawn = useDrawn();
  const source = useSource();
  const rung = usePick(view, (state) => state.content?.rung ?? null);
  const result: Result | null = source === "fe" ? (fe?.result ?? null) : (drawn?.result ?? null);
  if (result === null || result.rung !== rung) return null;
  const loads = readLoads(result.scene);
  const asked = loads.control === "pressure" ? loads.pressureTo : loads.volumeTo;
  const end = earlyEnd(result, asked, loads.control);
  if (end === null) return null;
  return (
    <div className="path-end" role="status" data-testid="path-end" data-outcome={result.outcome}>
      <p>
        <Icon name="warning" size={13} />
        <strong>
          {modelName(result.rung)}: {end}
        </strong>
      </p>
      <p>The last point of the slider is the last good shape. {result.advice}</p>
    </div>
  );
}
