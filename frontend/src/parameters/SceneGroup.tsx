import type { ProblemDetail } from "../api/types";
import { IconButton } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { Segmented } from "../ui/Segmented";
import { Slider } from "../ui/Slider";
import type { Work } from "../workbench/document";
import { endGesture, setGravity, setPressureTo } from "../workbench/workbench";
import { Problem, SeeOther } from "./Problem";

interface SceneGroupProps {
  work: Work;
  baseline: Work;
  problem: ProblemDetail | null;
  elsewhere: { name: string; label: string } | null;
}

/** What loads the actuator: the pressure path and gravity. */
export function SceneGroup({ work, baseline, problem, elsewhere }: SceneGroupProps) {
  const changed = work.pressureTo !== baseline.pressureTo;
  const top = Math.max(100, Math.ceil((baseline.pressureTo * 2) / 10) * 10, work.pressureTo);
  return (
    <section className="parameter-group" aria-label="Load">
      <h3>Load</h3>
      <div className={`parameter${changed ? " changed" : ""}${problem ? " invalid" : ""}`} data-testid="parameter-pressure">
        <span className="parameter-name">
          <span className="parameter-label">Pressure to</span>
          <span className="symbol">
            <var>p</var>
          </span>
        </span>
        <Slider
          value={work.pressureTo}
          min={1}
          max={top}
          step={1}
          mark={baseline.pressureTo}
          label="Pressure to"
          onInput={setPressureTo}
          onCommit={endGesture}
          testId="slider-pressure"
        />
        <NumberField
          value={work.pressureTo}
          step={1}
          unit="kPa"
          label="Pressure to"
          invalid={problem !== null}
          describedBy={problem ? "pressure-problem" : undefined}
          onCommit={setPressureTo}
          testId="field-pressure"
        />
        <IconButton
          className="reset"
          icon="reset"
          size={13}
          label={`Reset to ${baseline.pressureTo} kPa`}
          disabled={!changed}
          onClick={() => setPressureTo(baseline.pressureTo)}
        />
        {problem && <Problem id="pressure-problem" problem={problem} name="pressure" />}
        {elsewhere && <SeeOther name={elsewhere.name} label={elsewhere.label} />}
      </div>
      <div className={`parameter choice${work.gravity === baseline.gravity ? "" : " changed"}`} data-testid="parameter-gravity">
        <span className="parameter-name">
          <span className="parameter-label">Gravity</span>
          <span className="symbol">
            <var>g</var>
          </span>
        </span>
        <Segmented
          label="Gravity"
          value={work.gravity ? "on" : "off"}
          options={[
            { value: "on", label: "On", title: "9.81 m/s² downwards, applied before the pressure" },
            { value: "off", label: "Off" },
          ]}
          onChange={(value) => setGravity(value === "on")}
          testId="choice-gravity"
        />
      </div>
    </section>
  );
}
