import type { ProblemDetail } from "../api/types";
import type { Work } from "../workbench/document";
import type { Loads } from "../workbench/loads";
import { setLoads } from "../workbench/workbench";
import { AddLoad } from "./AddLoad";
import { EffectChips } from "./EffectChips";
import { EndRow } from "./EndRow";
import { GravityRows } from "./GravityRows";
import { NumberRow, VectorRow } from "./LoadRow";
import { CylinderRows, PlateRows } from "./Obstacles";
import { placeInScene, type ScenePlace } from "./places";

interface SceneGroupProps {
  work: Work;
  baseline: Work;
  problem: ProblemDetail | null;
  /** Where else the last edit was refused, and the entry of the scene that was edited. */
  elsewhere: { at: string; place: { name: string; label: string } } | null;
}

/** What every part of the group is handed. */
export interface SceneRows {
  loads: Loads;
  before: Loads;
  /** What is wrong at one entry; null elsewhere. */
  problemAt: (place: ScenePlace) => ProblemDetail | null;
  elsewhereAt: (place: ScenePlace) => { name: string; label: string } | null;
}

/** What loads and surrounds the actuator: how it is inflated, gravity, and what was added. */
export function SceneGroup({ work, baseline, problem, elsewhere }: SceneGroupProps) {
  const { loads } = work;
  const place = problem && placeInScene(problem.field, loads);
  const rows: SceneRows = {
    loads,
    before: baseline.loads,
    problemAt: (at) => (place === at ? problem : null),
    elsewhereAt: (at) => (elsewhere?.at === at ? elsewhere.place : null),
  };
  return (
    <section className="parameter-group scene" aria-label="Load and surroundings" data-testid="scene">
      <header className="group-head">
        <h3>Load</h3>
        <AddLoad work={work} />
      </header>
      <EndRow {...rows} />
      <GravityRows {...rows} />
      {loads.outsidePressure !== null && (
        <NumberRow
          {...rows}
          place="outside_pressure"
          label="Outside pressure"
          title="Acts on the underside, normal to it, before inflation"
          unit="kPa"
          value={loads.outsidePressure}
          opened={baseline.loads.outsidePressure}
          step={0.1}
          range={[-5, 5]}
          onChange={(outsidePressure) => setLoads("outside_pressure", { outsidePressure })}
          onRemove={() => setLoads("outside_pressure", { outsidePressure: null })}
        />
      )}
      {loads.tipForce !== null && (
        <VectorRow
          {...rows}
          place="tip_force"
          label="Tip force"
          title="Dead load, spread over the free end; keeps its direction"
          unit="N"
          value={loads.tipForce}
          opened={baseline.loads.tipForce}
          step={0.01}
          onChange={(tipForce) => setLoads("tip_force", { tipForce })}
          onRemove={() => setLoads("tip_force", { tipForce: null })}
        />
      )}
      {loads.plate !== null && <PlateRows {...rows} plate={loads.plate} />}
      {loads.cylinder !== null && <CylinderRows {...rows} cylinder={loads.cylinder} />}
      <EffectChips {...rows} />
    </section>
  );
}
