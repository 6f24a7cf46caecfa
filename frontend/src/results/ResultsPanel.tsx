import { useState } from "react";

import { LadderPanel } from "../ladder/LadderPanel";
import { useStore, usePick } from "../api/store";
import type { Result } from "../api/types";
import { isBeyondTrust, trustedPlace } from "../charts/curve";
import { Icon } from "../ui/Icon";
import { Busy, Empty } from "../ui/Notice";
import { grouped } from "../ui/numbers";
import { Segmented } from "../ui/Segmented";
import { answers, isStale } from "../workbench/answers";
import type { Control } from "../workbench/loads";
import { modelName } from "../workbench/model";
import { scrubber, shownPlace } from "../workbench/scrubber";
import { bench } from "../workbench/workbench";
import { useDrawn, type Drawn } from "./drawn";
import { Forced, Typical } from "./Marks";
import { ModelNotes, useNoteCount } from "./ModelNotes";
import { NumbersTable } from "./NumbersTable";
import { Plots } from "./Plots";
import { reached } from "./reached";
import { useShownFe, type ShownFe } from "./shown";
import { kPa, loadsInWords, placeInWords } from "./words";

/** Plots and numbers: the instant answer, and the finite-element answer over it. */
export function ResultsPanel() {
  const now = useStore(answers);
  const work = usePick(bench, (timeline) => timeline?.present.work ?? null);
  const control = work?.loads.control ?? "pressure";
  // Frames of what lay on the bench before may be told by what was in control then.
  const at = usePick(scrubber, (state) => (state.control === control ? shownPlace(state) : null));
  const fe = useShownFe();
  const refused = (now.designProblem ?? now.sceneProblem) !== null || now.unreachable;
  const stale = work !== null && isStale(now, work) && refused;
  const drawn = useDrawn();
  const instant = drawn?.result ?? null;
  if (!instant && !fe) {
    return (
      <section className="results" aria-label="Results">
        {now.instantProblem !== null ? (
          <Empty title="No instant answer">
            <span data-testid="no-instant">
              The instant model cannot carry this load: {now.instantProblem.value}. Run 3D FE for it.
            </span>
          </Empty>
        ) : refused ? (
          <Empty title="No answer yet">Correct the marked parameter to see the plots.</Empty>
        ) : (
          <Busy label="Computing the first answer" />
        )}
        <LadderPanel />
      </section>
    );
  }
  return (
    <section className={`results${stale ? " stale" : ""}`} aria-label="Results" data-testid="results">
      <Beyond instant={instant} leftOut={now.leftOut.map((load) => load.field)} />
      <Plots instant={instant} replaced={drawn?.replaced ?? null} fe={fe} control={control} at={at} input={now.input} stale={stale} />
      <Details drawn={drawn} fe={fe} control={control} at={at} />
      <LadderPanel />
    </section>
  );
}

/** What of the loads the instant model could not carry. */
function Beyond({ instant, leftOut }: { instant: Result | null; leftOut: readonly string[] }) {
  const refinedTo = instant?.rung === "cell-rod";
  const missing = leftOut.filter((field) => field !== "volume");
  const sentences = [
    instant ? "" : "The instant model has no answer to this load; 3D FE has.",
    missing.length > 0 && instant ? withoutInWords(missing, refinedTo) : "",
    missing.length < leftOut.length && instant && !refinedTo ? "The volume of the instant answer rises in proportion to pressure; that of 3D FE does not." : "",
  ].filter(Boolean);
  if (sentences.length === 0) return null;
  return (
    <p className="left-out" data-testid="left-out">
      <Icon name="info" size={13} />
      <span>{sentences.join(" ")}</span>
    </p>
  );
}

function withoutInWords(missing: readonly string[], refinedTo: boolean): string {
  const loads = loadsInWords(missing);
  if (refinedTo) return `Cell + rod carries all loads, as 3D FE does; the pale energy curve is without ${loads}.`;
  return `Instant answer without ${loads}; 3D FE carries all loads.`;
}

type Tab = "numbers" | "model";

interface DetailsProps {
  drawn: Drawn | null;
  fe: ShownFe | null;
  control: Control;
  at: number | null;
}

function Details({ drawn, fe, control, at }: DetailsProps) {
  const instant = drawn?.result ?? null;
  const [tab, setTab] = useState<Tab>("numbers");
  const count = useNoteCount(instant, fe);
  return (
    <div className="details">
      <div className="details-head">
        <Segmented
          label="Details"
          value={tab}
          options={[
            { value: "numbers", label: "Numbers" },
            { value: "model", label: count > 0 ? `Model and notes (${count})` : "Model" },
          ]}
          onChange={setTab}
          testId="details-tab"
        />
        {tab === "numbers" && at !== null && (
          <span className="at-pressure" data-testid="at-pressure">
            at {grouped(String(Number(at.toPrecision(4))))} {control === "pressure" ? "kPa" : "ml"}
          </span>
        )}
      </div>
      {tab === "numbers" && (
        <div className="marks">
          {drawn && <Typical drawn={drawn} control={control} at={at} />}
          <Forced results={[instant, fe?.result ?? null]} />
          {instant && <BeyondRange instant={instant} control={control} at={at} onRead={() => setTab("model")} />}
          {fe && fe.result.limit_pressure_kPa !== null && (
            <span className="stale-mark" data-testid="limit-pressure">
              <Icon name="warning" size={12} /> FE: no equilibrium above {kPa(fe.result.limit_pressure_kPa)}
            </span>
          )}
        </div>
      )}
      <div className="details-body">
        {tab === "numbers" ? (
          <NumbersTable instant={instant} fe={fe} control={control} at={at} />
        ) : (
          <ModelNotes instant={instant} fe={fe} totalMs={drawn?.totalMs ?? null} />
        )}
      </div>
    </div>
  );
}

function BeyondRange(props: { instant: Result; control: Control; at: number | null; onRead: () => void }) {
  const { instant, control } = props;
  const trusted = trustedPlace(instant, control);
  const at = props.at ?? reached(instant, control) ?? 0;
  if (trusted === null || !isBeyondTrust(instant, at, control)) return null;
  return (
    <button
      type="button"
      className="stale-mark beyond-range"
      title="The linear model's assumptions do not hold here. Read the notes."
      data-testid="beyond-range"
      onClick={props.onRead}
    >
      <Icon name="warning" size={12} /> {modelName(instant.rung)}: beyond its range ({placeInWords(trusted, control)})
    </button>
  );
}
