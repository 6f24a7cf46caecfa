import { useState } from "react";

import { usePick } from "../api/store";
import type { Job, Result } from "../api/types";
import { useDrawn } from "../results/drawn";
import { shownJob, useFailedJob, useShownFe } from "../results/shown";
import { earlyEnd, failureInWords, failureTitle, feLabel } from "../results/words";
import { Button, IconButton } from "../ui/Button";
import { dropDrafts } from "../ui/drafts";
import { Icon } from "../ui/Icon";
import { readLoads } from "../workbench/loads";
import { modelName } from "../workbench/model";
import { setViewer } from "./settings";
import { useSource } from "./source";
import { view } from "./view";

/** Over the 3D view: that the newest job failed, or where the path shown ended early, be it the part
 * that a failed job had found; how far it was found, why, and what to do. */
export function PathEnd() {
  const failed = useFailedJob();
  const fe = useShownFe();
  const inView = useSource() === "fe" && fe?.job.id === failed?.id;
  const [read, setRead] = useState<string | null>(null);
  if (failed !== null && !inView && failed.id !== read) return <Failed job={failed} onRead={() => setRead(failed.id)} />;
  return <EarlyEnd />;
}

function Failed({ job, onRead }: { job: Job; onRead: () => void }) {
  const fe = useShownFe();
  const source = useSource();
  const rung = usePick(view, (state) => state.content?.rung ?? null);
  const shown = source === "fe" && fe ? `${feLabel(fe.job)}, which was solved before` : rung && modelName(rung);
  return (
    <div className="path-end" role="status" data-testid="path-end" data-outcome={job.outcome ?? "failed"}>
      <p>
        <Icon name="warning" size={13} />
        <strong>
          {feLabel(job)}: {failureTitle(job)}
        </strong>
        <IconButton icon="close" label="Take this message away" onClick={onRead} data-testid="path-end-close" />
      </p>
      <p>
        {failureInWords(job)}
        {shown && ` The shape in view is that of ${shown}.`}
      </p>
      {job.has_answer && (
        <Button icon="eye" data-testid="show-part" onClick={() => showPart(job)}>
          Show the part of the path that it found
        </Button>
      )}
    </div>
  );
}

function showPart(job: Job): void {
  dropDrafts();
  shownJob.set({ kind: "job", id: job.id });
  setViewer({ source: "fe" });
}

function EarlyEnd() {
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
      <p>
        {result.path.length > 0 ? "The last point of the slider is the last good shape. " : ""}
        {result.advice}
      </p>
    </div>
  );
}
