import { useMutation } from "@tanstack/react-query";

import { api, messageOf, take } from "../api/client";
import { keys, queryClient } from "../api/queries";
import { withJob } from "../api/live";
import type { Job } from "../api/types";
import { rangeInWords } from "../ladder/scale";
import { jobSentence, meshOrAccuracy, stateInWords } from "../results/words";
import { shownJob } from "../results/shown";
import { Button, IconButton } from "../ui/Button";
import { formatQuantity, formatSeconds } from "../ui/numbers";
import { dropDrafts } from "../ui/drafts";
import { showToast } from "../ui/toasts";
import { setViewer } from "../viewer/settings";
import { openVersion } from "../workbench/opening";
import { useExpectation } from "./expected";

function tone(job: Job): string {
  if (job.state === "failed") return "bad";
  if (job.state === "done") return job.outcome === "converged" ? "good" : "warn";
  return job.state;
}

/** "12.5 of 40 kPa" while it runs, "40 kPa" otherwise. */
function reached(job: Job): string {
  if (job.volume_to_ml !== null) return `${formatQuantity(job.volume_to_ml)} ml`;
  const to = job.pressure_to_kPa === null ? "" : `${formatQuantity(job.pressure_to_kPa)} kPa`;
  if (job.pressure_kPa === null || job.pressure_kPa === job.pressure_to_kPa) return to;
  return `${formatQuantity(job.pressure_kPa)} of ${to}`;
}

interface JobRowProps {
  job: Job;
  /** Whether the job belongs to the version on the bench. */
  here: boolean;
  /** Whether its answer is one to the version on the bench, whichever version asked. */
  answers: boolean;
  shown: boolean;
}

export function JobRow({ job, here, answers, shown }: JobRowProps) {
  const { elapsed, expected, late } = useExpectation(job);
  const active = job.state === "queued" || job.state === "running";
  const sentence = jobSentence(job);
  return (
    <tr className={`job ${tone(job)}${here ? "" : " elsewhere"}`} data-testid={`job-${job.id}`} data-state={job.state}>
      <td className="job-state">
        <span className={`state ${tone(job)}`}>{stateInWords(job)}</span>
      </td>
      <td className="job-name">
        <button
          type="button"
          className="link"
          title={here ? job.design_name : `Open the version of ${job.design_name} that this job solves`}
          disabled={here}
          onClick={() => openVersion(job.version_id)}
        >
          {job.design_name} <span className="muted">v{job.version_number}</span>
        </button>
      </td>
      <td className="job-question muted">
        {meshOrAccuracy(job)}, {reached(job)}
      </td>
      {active ? (
        <>
          <td className="job-progress">
            <progress value={job.fraction} max={1} aria-label={`Progress of ${job.design_name}`} />
          </td>
          <td className="job-message muted" title={late === null ? sentence : `${late}. ${sentence}`}>
            {late !== null && <strong data-testid={`late-${job.id}`}>{late}. </strong>}
            {sentence}
          </td>
        </>
      ) : (
        <td className="job-progress" colSpan={2}>
          <span className="job-sentence" title={sentence} data-testid={`reason-${job.id}`}>
            {sentence}
          </span>
        </td>
      )}
      <td className={late === null ? "job-elapsed" : "job-elapsed late"} title={active && expected ? `Expected: ${rangeInWords(expected)}` : undefined}>
        {elapsed === null ? "" : formatSeconds(elapsed)}
        {elapsed !== null && job.attempt > 1 && (
          <span className="attempts" title="From the start of the first attempt; an attempt whose worker was lost is counted" data-testid={`attempts-${job.id}`}>
            in {job.attempt} attempts
          </span>
        )}
      </td>
      <td className="job-tools">
        {active && <CancelButton job={job} />}
        {job.has_answer && answers && <ShowButton job={job} shown={shown} />}
      </td>
    </tr>
  );
}

function CancelButton({ job }: { job: Job }) {
  const cancel = useMutation({
    mutationFn: () => take(api.POST("/api/jobs/{job_id}/cancel", { params: { path: { job_id: job.id } } })),
    onSuccess: (changed) => queryClient.setQueryData<Job[]>(keys.jobs, (jobs) => withJob(jobs, changed)),
    onError: (error) => showToast({ tone: "bad", text: messageOf(error) }),
  });
  const stopping = job.cancelling || cancel.isPending;
  return (
    <Button
      look="ghost"
      icon="stop"
      disabled={stopping}
      data-testid={`cancel-${job.id}`}
      onClick={() => cancel.mutate()}
    >
      {stopping ? "Stopping" : "Cancel"}
    </Button>
  );
}

/** Lays the result over the plots and into the 3D view, or takes it away. */
function ShowButton({ job, shown }: { job: Job; shown: boolean }) {
  return (
    <IconButton
      icon="eye"
      label={shown ? "Take this result out of the plots" : "Show this result in plots and 3D view"}
      pressed={shown}
      data-testid={`show-${job.id}`}
      onClick={() => {
        dropDrafts();
        shownJob.set(shown ? { kind: "none" } : { kind: "job", id: job.id });
        setViewer({ source: shown ? "instant" : "fe" });
      }}
    />
  );
}
