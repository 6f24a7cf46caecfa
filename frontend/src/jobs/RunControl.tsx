import { useMutation } from "@tanstack/react-query";
import { useState } from "react";

import { api, messageOf, take } from "../api/client";
import { withJob } from "../api/live";
import { keys, queryClient, useHealth } from "../api/queries";
import { usePick } from "../api/store";
import type { Job } from "../api/types";
import { shownJob } from "../results/shown";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Segmented } from "../ui/Segmented";
import { Select } from "../ui/Select";
import { showToast } from "../ui/toasts";
import { setViewer } from "../viewer/settings";
import { useHindrance } from "../workbench/hindrance";
import { ensureSaved } from "../workbench/opening";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";

const ACCURACIES = [
  { value: "0.1", label: "10 %", title: "A first look" },
  { value: "0.05", label: "5 %", title: "Meshes are refined until the estimated errors are below 5 %" },
  { value: "0.02", label: "2 %", title: "Fine meshes" },
  { value: "0.01", label: "1 %", title: "Fine meshes: takes the longest" },
] as const;

type Accuracy = (typeof ACCURACIES)[number]["value"];

/** Empty: the accuracy decides. */
const MESHES = [
  { value: "", label: "Mesh: auto" },
  { value: "coarse", label: "Coarse mesh" },
  { value: "medium", label: "Medium mesh" },
  { value: "fine", label: "Fine mesh" },
  { value: "finest", label: "Finest mesh" },
] as const;

async function submit(accuracy: Accuracy, mesh: string): Promise<Job> {
  const versionId = await ensureSaved("Kept for a finite-element job");
  const body = { version_id: versionId, rung: "fe" as const, accuracy: Number(accuracy), mesh: mesh || null, scene: null };
  return take(api.POST("/api/jobs", { body }));
}

/** Sends what is on the bench to the queue, keeping it as a version first. */
export function RunControl() {
  const [accuracy, setAccuracy] = useState<Accuracy>("0.05");
  const [mesh, setMesh] = useState("");
  const needsSaving = usePick(bench, (timeline) => {
    if (!timeline) return false;
    return timeline.present.origin.kind === "preset" || isChanged(timeline.present);
  });
  const hindered = useHindrance();
  const { data: health } = useHealth();
  const run = useMutation({
    mutationFn: () => submit(accuracy, mesh),
    onMutate: () => setViewer({ source: "newest" }),
    onSuccess: (job) => {
      queryClient.setQueryData<Job[]>(keys.jobs, (jobs) => withJob(jobs, job));
      shownJob.set({ kind: "newest" });
      if (job.from_store) showToast({ tone: "good", text: "This question was answered before; the stored result is shown." });
    },
    onError: (error) => showToast({ tone: "bad", text: messageOf(error) }),
  });
  return (
    <div className="run-control">
      {health && !health.worker.alive && (
        <span className="no-worker" title="Jobs wait in the queue until a worker runs">
          <Icon name="warning" size={13} /> No worker
        </span>
      )}
      <span className="muted">Accuracy</span>
      <Segmented
        label="Accuracy"
        options={ACCURACIES.map((each) => ({ ...each, disabled: mesh !== "" }))}
        value={accuracy}
        onChange={setAccuracy}
        testId="accuracy"
      />
      <Select label="Mesh" value={mesh} options={MESHES} onChange={setMesh} testId="mesh" />
      <Button
        look="primary"
        icon="play"
        disabled={run.isPending || hindered !== null}
        title={
          hindered ??
          (needsSaving
            ? "Saves a version, then solves it by 3D finite elements"
            : "Solves this version by 3D finite elements")
        }
        data-testid="run-fe"
        onClick={() => run.mutate()}
      >
        {needsSaving ? "Save and run 3D FE" : "Run 3D FE"}
      </Button>
    </div>
  );
}
