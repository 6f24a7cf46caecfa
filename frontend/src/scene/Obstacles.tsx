import type { Cylinder, Plate, Triple } from "../workbench/loads";
import { setLoads } from "../workbench/workbench";
import { LoadRow, NumberRow, VectorRow } from "./LoadRow";
import { optionOf, type Direction } from "./directions";
import { Select } from "../ui/Select";
import type { SceneRows } from "./SceneGroup";

/** Where a plate stands; the vector points from it to the actuator. */
const SIDES: readonly Direction[] = [
  { value: "below", label: "Below", vector: [0, 0, 1] },
  { value: "above", label: "Above", vector: [0, 0, -1] },
  { value: "tip", label: "In front of the tip", vector: [-1, 0, 0] },
  { value: "side", label: "Beside", vector: [0, 1, 0] },
];

const AXES: readonly Direction[] = [
  { value: "across", label: "Across (X₂)", vector: [0, 1, 0] },
  { value: "along", label: "Along (X₁)", vector: [1, 0, 0] },
  { value: "upright", label: "Upright (X₃)", vector: [0, 0, 1] },
];

/** A named direction turned a little, so that "own" is not a name again. */
const TILTED: Triple = [0.2, 0, 0.98];

export function PlateRows(props: SceneRows & { plate: Plate }) {
  const { plate, before } = props;
  const set = (key: string, change: Partial<Plate>) => setLoads(`plate.${key}`, { plate: { ...plate, ...change } });
  const side = optionOf(SIDES, plate.normal);
  return (
    <div className="load-block">
      <LoadRow
        {...props}
        place="plate.normal"
        label="Plate"
        title="Rigid and without friction"
        kind="choice"
        changed={side !== (before.plate && optionOf(SIDES, before.plate.normal))}
        onRemove={() => setLoads("plate", { plate: null })}
      >
        <Select
          label="Side of the plate"
          value={side}
          options={[...SIDES, { value: "own", label: "Own normal" }]}
          onChange={(value) => set("normal", { normal: SIDES.find((each) => each.value === value)?.vector ?? TILTED })}
          testId="choice-plate"
        />
      </LoadRow>
      {side === "own" && (
        <VectorRow
          {...props}
          problemAt={() => null}
          place="plate.normal"
          label="Normal"
          title="From the plate to the actuator"
          unit=""
          kind="part"
          value={plate.normal}
          opened={before.plate?.normal ?? null}
          step={0.1}
          onChange={(normal) => set("normal", { normal })}
        />
      )}
      <NumberRow
        {...props}
        place="plate.gap"
        label="Gap"
        title="From the undeformed body to the plate"
        unit="mm"
        kind="part"
        value={plate.gap}
        opened={before.plate?.gap ?? null}
        step={0.5}
        range={[0, 40]}
        onChange={(gap) => set("gap", { gap })}
      />
    </div>
  );
}

export function CylinderRows(props: SceneRows & { cylinder: Cylinder }) {
  const { cylinder, before } = props;
  const set = (key: string, change: Partial<Cylinder>) => setLoads(`cylinder.${key}`, { cylinder: { ...cylinder, ...change } });
  const axis = optionOf(AXES, cylinder.axis);
  return (
    <div className="load-block">
      <LoadRow
        {...props}
        place="cylinder.axis"
        label="Cylinder"
        title="Rigid, without friction and without end"
        kind="choice"
        changed={axis !== (before.cylinder && optionOf(AXES, before.cylinder.axis))}
        onRemove={() => setLoads("cylinder", { cylinder: null })}
      >
        <Select
          label="Axis of the cylinder"
          value={axis}
          options={[...AXES, { value: "own", label: "Own axis" }]}
          onChange={(value) => set("axis", { axis: AXES.find((each) => each.value === value)?.vector ?? TILTED })}
          testId="choice-cylinder"
        />
      </LoadRow>
      {axis === "own" && (
        <VectorRow
          {...props}
          problemAt={() => null}
          place="cylinder.axis"
          label="Axis"
          unit=""
          kind="part"
          value={cylinder.axis}
          opened={before.cylinder?.axis ?? null}
          step={0.1}
          onChange={(next) => set("axis", { axis: next })}
        />
      )}
      <NumberRow
        {...props}
        place="cylinder.radius"
        label="Radius"
        unit="mm"
        kind="part"
        value={cylinder.radius}
        opened={before.cylinder?.radius ?? null}
        step={0.5}
        range={[1, 60]}
        onChange={(radius) => set("radius", { radius })}
      />
      <VectorRow
        {...props}
        place="cylinder.centre"
        label="Centre"
        title="A point on the axis; X₁ = 0 at the clamp, X₃ = 0 at the underside"
        unit="mm"
        kind="part"
        value={cylinder.centre}
        opened={before.cylinder?.centre ?? null}
        step={1}
        onChange={(centre) => set("centre", { centre })}
      />
    </div>
  );
}
