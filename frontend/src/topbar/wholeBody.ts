/** The command line that solves an answer again and writes the fields of the whole body, which the studio does
 * not store. */
import type { Job, Result } from "../api/types";
import { showToast } from "../ui/toasts";

function asFile(document: unknown): string {
  return `<(echo '${JSON.stringify(document).replaceAll("'", String.raw`'\''`)}')`;
}

/** Whole by itself: design and scene stand in it as files of the shell (bash, zsh). */
export function wholeBody(job: Pick<Job, "mesh" | "accuracy">, result: Pick<Result, "design" | "scene">): string {
  const how = job.mesh === null ? `--accuracy ${Number((100 * job.accuracy).toPrecision(6))}%` : `--mesh ${job.mesh}`;
  return `pneustudio export ${asFile(result.design)} --scene ${asFile(result.scene)} ${how} --what vtu --to fields`;
}

export async function copyCommand(command: string): Promise<void> {
  try {
    await navigator.clipboard.writeText(command);
    showToast({ tone: "good", text: "Copied. In a shell it solves again and writes VTU files of the whole body into the folder fields." });
  } catch {
    showToast({ tone: "bad", text: `The browser does not let the page copy. The command: ${command}` });
  }
}
