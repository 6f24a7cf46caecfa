import { setLoads } from "../workbench/workbench";
import type { Triple } from "../workbench/loads";
import { LoadRow, VectorRow } from "./LoadRow";
import { optionOf, type Direction } from "./directions";
import { Select } from "../ui/Select";
import type { SceneRows } from "./SceneGroup";

const G = 9.81;

/** Gravity in the body's axes: X1 along it from the clamp, X3 from the bottom layer to the top. */
const WAYS: readonly Direction[] = [
  { value: "down", label: "Down", vector: [0, 0, -G] },
  { value: "up", label: "Up (upside down)", vector: [0, 0, G] },
  { value: "hanging", label: "Hanging from the clamp", vector: [G, 0, 0] },
  { value: "standing", label: "Standing on the clamp", vector: [-G, 0, 0] },
  { value: "side", label: "On its side", vector: [0, -G, 0] },
];

/** Direction of gravity by name, none, or three components. */
export function GravityRows(rows: SceneRows) {
  const { gravity } = rows.loads;
  const before = rows.before.gravity;
  const named = gravity === null ? "none" : optionOf(WAYS, gravity);
  const changed = JSON.stringify(gravity) !== JSON.stringify(before);
  const set = (next: Triple | null) => setLoads("gravity", { gravity: next });
  return (
    <>
      <LoadRow {...rows} place="gravity" label="Gravity" symbol="g" kind="choice" changed={changed} onReset={() => set(before)}>
        <Select
          label="Gravity"
          value={named}
          options={[...WAYS, { value: "own", label: "Own vector" }, { value: "none", label: "None" }]}
          onChange={(value) => {
            if (value === "none") set(null);
            else if (value === "own") set([0, G / Math.SQRT2, -G / Math.SQRT2].map((part) => Number(part.toFixed(2))) as unknown as Triple);
            else set(WAYS.find((way) => way.value === value)?.vector ?? null);
          }}
          testId="choice-gravity"
        />
      </LoadRow>
      {gravity !== null && named === "own" && (
        <VectorRow
          {...rows}
          problemAt={() => null}
          place="gravity"
          label="g"
          unit="m/s²"
          value={gravity}
          opened={before}
          step={0.1}
          kind="part"
          onChange={set}
        />
      )}
    </>
  );
}
