/** Outcomes and rungs in words. */
import type { Job, Result } from "../api/types";
import { isBeyondTrust, placeOf, trustedPlace } from "../charts/curve";
import { formatQuantity, isSaid } from "../ui/numbers";
import type { Control } from "../workbench/loads";
import { modelName } from "../workbench/model";
import { reached } from "./reached";

const OUTCOMES: Record<string, string> = {
  converged: "Reached the end of the path.",
  limit_point: "Reached a limit point: beyond it the actuator grows without more pressure.",
  stalled: "Stopped early: no equilibrium was found beyond the last point.",
  cancelled: "Cancelled; the part that was found is kept.",
  budget_spent: "Stopped early: the allowed time was used up.",
  failed: "The solver broke down; the part that was found is kept.",
  worker_lost: "The worker was lost; the part that was found is kept.",
};

export function outcomeInWords(outcome: string): string {
  return OUTCOMES[outcome] ?? outcome.replaceAll("_", " ");
}

/** How an answer ended. A linear model reaches every pressure, so that it says nothing to have reached it. */
export function endInWords(result: Result): string {
  if (result.rung === "energy" && result.outcome === "stalled") return "The linear model's path ends early.";
  if (result.rung !== "energy" || result.outcome !== "converged") return outcomeInWords(result.outcome);
  if (result.trusted_to_kPa === null) return "Linear model, within its range at every pressure shown.";
  return `Linear model, meant for less than ${kPa(result.trusted_to_kPa)}.`;
}

/** A pressure to read: "3.8 kPa". */
export function kPa(pressure: number): string {
  return `${formatQuantity(pressure, Math.abs(pressure) < 10 ? 2 : 3)} kPa`;
}

/** A place on the path, by what is in control: "3.8 kPa", "42.0 ml". */
export function placeInWords(at: number, control: Control): string {
  return control === "pressure" ? kPa(at) : `${formatQuantity(at)} ml`;
}

/** Why the numbers at a place mean little; undefined where the answer's own assumptions hold. */
export function beyondInWords(result: Result, at: number, control: Control): string | undefined {
  const trusted = trustedPlace(result, control);
  if (trusted === null || !isBeyondTrust(result, at, control)) return undefined;
  return `Beyond the range of ${modelName(result.rung).toLowerCase()} (${placeInWords(trusted, control)}): its assumptions do not hold here`;
}

const LOADS: Record<string, string> = {
  volume: "control by volume",
  outside_pressure: "outside pressure",
  tip_force: "tip force",
  plate: "plate",
  cylinder: "cylinder",
  self_contact: "self-contact",
};

/** "plate and tip force" */
export function loadsInWords(fields: readonly string[]): string {
  const names = fields.map((field) => LOADS[field] ?? field.replaceAll("_", " "));
  const last = names.pop() ?? "";
  return names.length > 0 ? `${names.join(", ")} and ${last}` : last;
}

export function percent(fraction: number): string {
  return `${Number((fraction * 100).toPrecision(3))} %`;
}

/** What a job's answer may be off by, or the mesh it was asked on. */
export function meshOrAccuracy(job: Pick<Job, "mesh" | "accuracy">): string {
  return job.mesh === null ? percent(job.accuracy) : `${job.mesh} mesh`;
}

export function feLabel(job: Job): string {
  return `FE ${meshOrAccuracy(job)}`;
}

/** Why a failed job has no answer, or but a part of one. */
const FAILURES: Record<string, { state: string; title: string }> = {
  refused: { state: "Refused", title: "cannot be solved as it stands" },
  worker_lost: { state: "Worker lost", title: "given up, its worker was lost again and again" },
  budget_spent: { state: "Time used up", title: "the allowed time was used up" },
};

/** "3D FE: cannot be solved as it stands" */
export function failureTitle(job: Pick<Job, "outcome">): string {
  return FAILURES[job.outcome ?? ""]?.title ?? "the solver broke down";
}

/** Why a failed job has no answer and what to do; many messages hold their advice already. */
export function failureInWords(job: Pick<Job, "error" | "advice">): string {
  const error = job.error ?? "The job failed without a reason.";
  const advice = job.advice ?? "";
  return advice === "" || isSaid(advice, error) ? error : `${error} ${advice}`;
}

const STATES: Record<Job["state"], string> = {
  queued: "Queued",
  running: "Running",
  done: "Done",
  failed: "Failed",
  cancelled: "Cancelled",
};

export function stateInWords(job: Job): string {
  if (job.state === "running" && job.cancelling) return "Stopping";
  if (job.state === "done" && job.outcome === "limit_point") return "Done, limit point";
  if (job.state === "done" && job.outcome && job.outcome !== "converged") return "Ended early";
  if (job.state === "failed") return FAILURES[job.outcome ?? ""]?.state ?? STATES.failed;
  if (job.state === "done" && job.from_store) return "Done, from store";
  return STATES[job.state];
}

/** The sentence under a job: what it does, or why it ended. */
export function jobSentence(job: Job): string {
  if (job.state === "failed") return failureInWords(job);
  if (job.state === "cancelled") {
    if (job.has_answer) return [outcomeInWords("cancelled"), job.advice].filter(Boolean).join(" ");
    return "Cancelled before any point of the path was found.";
  }
  if (job.state === "done") {
    if (job.outcome === "converged" && job.from_store) return "The same question was answered before.";
    return [job.outcome && outcomeInWords(job.outcome), job.advice].filter(Boolean).join(" ");
  }
  if (job.state === "queued") return job.message || "Waiting for a worker.";
  const again = job.lost > 0 ? `Taken up again after its worker was lost (attempt ${job.attempt}). ` : "";
  return again + job.message;
}

const ENDS: Record<string, string> = {
  limit_point: "limit point",
  stalled: "beyond it no equilibrium was found",
  cancelled: "cancelled",
  budget_spent: "time used up",
  failed: "the solver broke down",
  worker_lost: "its worker was lost again and again",
};

/** The linear model knows no limit: it ends where its rod falls over, or where it means nothing. */
const LINEAR_ENDS: Record<string, string> = { stalled: "it says nothing beyond" };

/** How far a path was found that ended before what was asked: "found up to 12.2 of 40 kPa (limit
 * point)"; null where it went all the way. */
export function earlyEnd(result: Result, asked: number | null, control: Control): string | null {
  if (result.outcome === "converged") return null;
  const end = reached(result, control);
  const why = (result.rung === "energy" ? LINEAR_ENDS : ENDS)[result.outcome] ?? result.outcome.replaceAll("_", " ");
  if (end === null) return why;
  const unit = control === "pressure" ? "kPa" : "ml";
  const of = asked === null ? "" : ` of ${formatQuantity(asked)}`;
  const start = result.path[0] ? placeOf(result.path[0], control) : null;
  const way = start !== null && end < start ? "down" : "up";
  return `found ${way} to ${formatQuantity(end, 3)}${of} ${unit} (${why})`;
}
