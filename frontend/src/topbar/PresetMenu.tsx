import { useQuery } from "@tanstack/react-query";

import { families, presets } from "../api/queries";
import { usePick } from "../api/store";
import type { Preset } from "../api/types";
import { Icon } from "../ui/Icon";
import { Busy } from "../ui/Notice";
import { Popover } from "../ui/Popover";
import { openPreset } from "../workbench/opening";
import { bench } from "../workbench/workbench";
import { PresetPicture } from "./PresetPicture";

/** The actuators of the source papers, as starting points. */
export function PresetMenu() {
  const { data: list } = useQuery(presets);
  const { data: kinds = [] } = useQuery(families);
  const current = usePick(bench, (timeline) => {
    const origin = timeline?.present.origin;
    return origin?.kind === "preset" ? origin.preset : null;
  });
  return (
    <Popover
      label="Presets"
      align="end"
      button={(open, toggle) => (
        <button type="button" className="button plain" aria-expanded={open} onClick={toggle} data-testid="open-presets">
          <Icon name="layers" />
          <span>Presets</span>
          <Icon name="chevron" size={12} />
        </button>
      )}
    >
      {(close) => (
        <div className="preset-menu">
          {!list && <Busy label="Reading presets" />}
          {kinds.map((kind) => (
            <section key={kind.family}>
              <h3>{kind.title}</h3>
              {list
                ?.filter((preset) => preset.design.family === kind.family)
                .map((preset) => (
                  <PresetButton
                    key={preset.name}
                    preset={preset}
                    current={preset.name === current}
                    onChoose={() => {
                      openPreset(preset);
                      close();
                    }}
                  />
                ))}
            </section>
          ))}
        </div>
      )}
    </Popover>
  );
}

function PresetButton({ preset, current, onChoose }: { preset: Preset; current: boolean; onChoose: () => void }) {
  return (
    <button
      type="button"
      className="menu-item preset"
      aria-current={current}
      title={`${preset.name}. Source: ${preset.source}`}
      data-testid={`preset-${preset.name}`}
      onClick={onChoose}
    >
      <PresetPicture preset={preset} />
      <span className="preset-words">
        <span className="menu-title">{preset.title}</span>
        <span className="muted" title={preset.description}>
          {preset.description}
        </span>
      </span>
    </button>
  );
}
