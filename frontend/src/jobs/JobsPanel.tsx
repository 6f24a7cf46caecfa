import { useState } from "react";

import { messageOf } from "../api/client";
import { useJobs } from "../api/queries";
import { usePick } from "../api/store";
import type { Job } from "../api/types";
import { useCandidates, useShownJob } from "../results/shown";
import { Button, IconButton } from "../ui/Button";
import { Busy, Empty, Notice } from "../ui/Notice";
import { Segmented } from "../ui/Segmented";
import { bench } from "../workbench/workbench";
import { JobRow } from "./JobRow";
import { RunControl } from "./RunControl";

type Scope = "design" | "all";

/** Jobs below the view: what runs, how far it is, and how it ended. */
export function JobsPanel({ open, onToggle }: { open: boolean; onToggle: () => void }) {
  const [scope, setScope] = useState<Scope>("all");
  const query = useJobs();
  const origin = usePick(bench, (timeline) => timeline?.present.origin ?? null);
  const designId = origin?.kind === "version" ? origin.designId : null;
  const jobs = query.data ?? [];
  const shown = scope === "design" ? jobs.filter((job) => job.design_id === designId) : jobs;
  const active = jobs.filter((job) => job.state === "queued" || job.state === "running").length;
  return (
    <section className={`jobs${open ? "" : " closed"}`} aria-label="Jobs" data-testid="jobs">
      <header className="panel-head">
        <IconButton
          icon="chevron"
          label={open ? "Fold the jobs away" : "Show the jobs"}
          className={open ? "" : "turned"}
          aria-expanded={open}
          onClick={onToggle}
        />
        <h2>Jobs</h2>
        {active > 0 && <span className="badge">{active} active</span>}
        <Segmented
          label="Which jobs"
          value={scope}
          options={[
            { value: "all", label: "All" },
            { value: "design", label: "This design", disabled: designId === null },
          ]}
          onChange={setScope}
          testId="jobs-scope"
        />
        <div className="spacer" />
        <RunControl />
      </header>
      {open && <div className="jobs-body">{body(query, shown, origin?.kind === "version" ? origin.versionId : null)}</div>}
    </section>
  );
}

function body(query: ReturnType<typeof useJobs>, jobs: readonly Job[], versionId: string | null) {
  if (query.isPending) return <Busy label="Reading the jobs" />;
  if (query.error && jobs.length === 0) {
    return (
      <Notice tone="bad" action={<Button onClick={() => void query.refetch()}>Try again</Button>}>
        {messageOf(query.error)}
      </Notice>
    );
  }
  if (jobs.length === 0) {
    return (
      <Empty title="No jobs yet">
        Run 3D FE to check the instant answer with finite elements. It goes on when this page is closed.
      </Empty>
    );
  }
  return <JobTable jobs={jobs} versionId={versionId} />;
}

function JobTable({ jobs, versionId }: { jobs: readonly Job[]; versionId: string | null }) {
  const shown = useShownJob();
  const candidates = new Set(useCandidates().map((job) => job.id));
  return (
    <table className="job-table">
      <colgroup>
        {["state", "name", "question", "progress", "message", "time", "tools"].map((name) => (
          <col key={name} className={`${name}-column`} />
        ))}
      </colgroup>
      <thead className="visually-hidden">
        <tr>
          <th>State</th>
          <th>Design</th>
          <th>Question</th>
          <th>Progress or result</th>
          <th>Message</th>
          <th>Time</th>
          <th>Actions</th>
        </tr>
      </thead>
      <tbody>
        {jobs.map((job) => (
          <JobRow key={job.id} job={job} here={job.version_id === versionId} answers={candidates.has(job.id)} shown={job.id === shown?.id} />
        ))}
      </tbody>
    </table>
  );
}
