import { answers } from "../workbench/answers";
import { usePick } from "../api/store";
import type { Result } from "../api/types";
import { FALLBACK_VOLUME, type Control } from "../workbench/loads";
import { setLoads } from "../workbench/workbench";
import { Segmented } from "../ui/Segmented";
import { LoadRow, NumberRow } from "./LoadRow";
import type { SceneRows } from "./SceneGroup";

const CONTROLS: readonly { value: Control; label: string; title: string }[] = [
  { value: "pressure", label: "Pressure", title: "The path ends at a pressure; below 0 it is suction" },
  { value: "volume", label: "Volume", title: "The path ends at a volume of the cavity; goes on beyond a limit pressure" },
];

/** A volume a little beyond where the instant answer ends. */
function firstVolume(result: Result | null): number {
  const end = result?.path.at(-1)?.cavity_volume_ml;
  return end ? Number(end.toPrecision(2)) : FALLBACK_VOLUME;
}

/** What ends the path: a pressure, or a volume of the cavity. */
export function EndRow(rows: SceneRows) {
  const { loads, before } = rows;
  const result = usePick(answers, (now) => now.result);
  const rest = result?.path[0]?.cavity_volume_ml ?? 0;
  const pressureTop = Math.max(100, Math.ceil((before.pressureTo * 2) / 10) * 10);
  const volume = loads.volumeTo ?? FALLBACK_VOLUME;
  return (
    <>
      <LoadRow
        {...rows}
        place="control"
        label="Inflate by"
        kind="choice"
        changed={loads.control !== before.control}
        onReset={() => setLoads("control", { control: before.control })}
      >
        <Segmented
          label="Inflate by"
          options={CONTROLS}
          value={loads.control}
          onChange={(control) =>
            setLoads("control", { control, volumeTo: loads.volumeTo ?? firstVolume(result) })
          }
          testId="choice-control"
        />
      </LoadRow>
      {loads.control === "pressure" ? (
        <NumberRow
          {...rows}
          place="pressure"
          label="Pressure to"
          symbol="p"
          unit="kPa"
          value={loads.pressureTo}
          opened={before.pressureTo}
          step={1}
          range={[1, pressureTop]}
          onChange={(pressureTo) => setLoads("pressure", { pressureTo })}
        />
      ) : (
        <NumberRow
          {...rows}
          place="volume"
          label="Volume to"
          symbol="V"
          title={rest > 0 ? `Of the whole cavity, which holds ${rest.toPrecision(3)} ml at rest` : "Of the whole cavity"}
          unit="ml"
          value={volume}
          opened={before.volumeTo}
          step={volume > 20 ? 1 : 0.1}
          range={[0.1, Math.max(10, Math.ceil(Math.max(rest * 4, before.volumeTo ?? 0)))]}
          onChange={(volumeTo) => setLoads("volume", { volumeTo })}
        />
      )}
    </>
  );
}
