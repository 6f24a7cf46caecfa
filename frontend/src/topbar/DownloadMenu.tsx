import { useState, type ReactNode } from "react";

import { usePick } from "../api/store";
import type { FileKind, Result } from "../api/types";
import { useShownFe, type ShownFe } from "../results/shown";
import { feLabel } from "../results/words";
import { Icon } from "../ui/Icon";
import { formatBytes, sentence } from "../ui/numbers";
import { Popover } from "../ui/Popover";
import { answers } from "../workbench/answers";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";
import { download } from "./download";
import { copyCommand, wholeBody } from "./wholeBody";

interface Entry {
  what: FileKind;
  title: string;
  text: string;
}

const MAKE: readonly Entry[] = [
  { what: "mould-svg", title: "Mould, SVG", text: "Sheets for the laser cutter, true millimetres" },
  { what: "actuator-stl", title: "Actuator, STL", text: "Closed surface of the body, for printing and CAD" },
];

const SIMULATE: readonly Entry[] = [
  { what: "inp", title: "Model, INP", text: "Deck for CalculiX and Abaqus, with these loads" },
];

const RESULT: readonly Entry[] = [
  { what: "result-vtu", title: "Surface fields, VTU", text: "A series over pressure for ParaView, as one zip" },
  { what: "result-csv", title: "Path, CSV", text: "One line for every pressure" },
  { what: "result-json", title: "Everything, JSON", text: "As the command line prints it" },
];

/** Why there is no deck (`actuators/export/inp_inflation.py`); empty where it can be made. A volume's holds the
 * pressures of an answer. */
function notInADeck(byVolume: boolean, answered: boolean): string {
  return byVolume && !answered ? "A deck for a volume needs a solve first: save and run 3D FE, or prescribe a pressure." : "";
}

/** Files for making, for other solvers, and of the finite-element result. */
export function DownloadMenu() {
  return (
    <Popover
      label="Downloads"
      align="end"
      button={(open, toggle) => (
        <button
          type="button"
          className="button plain"
          aria-expanded={open}
          onClick={toggle}
          title="Files for making, simulating and reporting"
          data-testid="open-downloads"
        >
          <Icon name="download" />
          <span>Files</span>
        </button>
      )}
    >
      {(close) => <Files onDone={close} />}
    </Popover>
  );
}

/** Fields in the whole body: as a file, where it is kept with the result shown. */
function bodyEntry(result: Result): Entry | null {
  const files = result.body_files;
  if (!files) return null;
  const of = files.points < result.path.length ? `${files.points} of ${result.path.length} points of the path` : "Every point of the path";
  return { what: "result-body", title: "Whole-body fields, VTU", text: `${of}, as one zip of ${formatBytes(files.bytes)}` };
}

function Files({ onDone }: { onDone: () => void }) {
  const unavailable = usePick(answers, (now) => now.check?.unavailable_files ?? null);
  const saved = usePick(bench, (timeline) => {
    const present = timeline?.present;
    return present?.origin.kind === "version" && !isChanged(present);
  });
  const byVolume = usePick(bench, (timeline) => timeline?.present.work.loads.control === "volume");
  const fe = useShownFe();
  const noResult = fe && saved ? "" : "Save and run 3D FE first.";
  const body = fe && bodyEntry(fe.result);
  return (
    <div className="menu files-menu">
      <Section title="Make" entries={MAKE} reason={(what) => unavailable?.[what] ?? ""} onDone={onDone} />
      <Section
        title="Simulate elsewhere"
        entries={SIMULATE}
        reason={() => notInADeck(byVolume, fe !== null && saved)}
        jobId={byVolume ? (fe?.job.id ?? null) : null}
        onDone={onDone}
      />
      <Section
        title={fe ? `Result of ${feLabel(fe.job)}` : "Result of 3D FE"}
        entries={body ? [body, ...RESULT] : RESULT}
        reason={() => noResult}
        jobId={fe?.job.id ?? null}
        onDone={onDone}
      >
        {!body && <WholeBodyCommand fe={fe} onDone={onDone} />}
      </Section>
    </div>
  );
}

/** Where the fields are not kept: the command that solves again. */
function WholeBodyCommand({ fe, onDone }: { fe: ShownFe | null; onDone: () => void }) {
  return (
    <button
      type="button"
      className="menu-item"
      disabled={fe === null}
      title={fe ? wholeBody(fe.job, fe.result) : "Run 3D FE first."}
      data-testid="copy-whole-body"
      onClick={() => {
        if (fe) void copyCommand(wholeBody(fe.job, fe.result)).finally(onDone);
      }}
    >
      <span className="menu-title">Whole-body fields, VTU{fe && ": copy the command"}</span>
      <span className="muted">
        {fe ? "Not kept with this result; the command solves again and writes them" : "Save and run 3D FE first."}
      </span>
    </button>
  );
}

interface SectionProps {
  title: string;
  entries: readonly Entry[];
  /** Why a file cannot be had; empty where it can. */
  reason: (what: FileKind) => string;
  /** Whose result is meant. */
  jobId?: string | null;
  onDone: () => void;
  /** Further entries. */
  children?: ReactNode;
}

function Section({ title, entries, reason, jobId = null, onDone, children }: SectionProps) {
  const [busy, setBusy] = useState<FileKind | null>(null);
  return (
    <section>
      <h3>{title}</h3>
      {entries.map((file) => {
        const why = reason(file.what);
        return (
          <button
            key={file.what}
            type="button"
            className="menu-item"
            disabled={busy !== null || why !== ""}
            title={why}
            data-testid={`download-${file.what}`}
            onClick={() => {
              setBusy(file.what);
              void download(file.what, jobId).finally(() => {
                setBusy(null);
                onDone();
              });
            }}
          >
            <span className="menu-title">{file.title}</span>
            <span className="muted">{busy === file.what ? "Making the file" : why ? sentence(why) : file.text}</span>
          </button>
        );
      })}
      {children}
    </section>
  );
}
