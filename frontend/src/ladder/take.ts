/** Choosing a rung: instant ones are drawn at once, finite elements go to the queue. */
import type { LadderPoint } from "../api/types";
import { runFe } from "../jobs/submit";
import { showToast } from "../ui/toasts";
import { hindrance } from "../workbench/hindrance";
import { modelChoice } from "../workbench/model";
import { askRefined } from "../workbench/refined";

export async function takeRung(point: LadderPoint): Promise<void> {
  if (point.rung === "closed-form" || point.rung === "energy") {
    if (point.state !== "refused") modelChoice.set(point.rung);
    return;
  }
  if (point.rung === "cell-rod") {
    modelChoice.set("auto");
    if (point.state === "predicted") askRefined();
    return;
  }
  const hindered = hindrance();
  if (hindered !== null) showToast({ tone: "info", text: hindered });
  else if (point.job_id === null) await runFe({ accuracy: (point.accuracy_percent ?? 5) / 100, mesh: point.mesh });
}
