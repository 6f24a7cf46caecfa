import { useMutation } from "@tanstack/react-query";
import { useState } from "react";

import { useHealth } from "../api/queries";
import { usePick, useStore } from "../api/store";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Segmented } from "../ui/Segmented";
import { Select } from "../ui/Select";
import { useHindrance } from "../workbench/hindrance";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";
import { accuracy, ACCURACIES } from "./accuracy";
import { runFe } from "./submit";

/** Empty: the accuracy decides. */
const MESHES = [
  { value: "", label: "Mesh: auto" },
  { value: "coarse", label: "Coarse mesh" },
  { value: "medium", label: "Medium mesh" },
  { value: "fine", label: "Fine mesh" },
  { value: "finest", label: "Finest mesh" },
] as const;

/** What is known of the error of an answer on a mesh chosen by hand: finer ones are solved with the coarsest beside them. */
export function onMesh(mesh: string): { text: string; title: string } {
  if (mesh === "coarse") {
    return {
      text: "One mesh: no accuracy, its error is not estimated",
      title: "An error is estimated from two meshes or more: take a finer mesh for an estimate, the mesh auto for an accuracy",
    };
  }
  return {
    text: "Its error is estimated from the coarsest mesh beside it",
    title: "Both meshes are solved; how small the error gets is not asked for: take the mesh auto for an accuracy",
  };
}

/** Sends what is on the bench to the queue, keeping it as a version first. */
export function RunControl() {
  const wanted = useStore(accuracy);
  const [mesh, setMesh] = useState("");
  const needsSaving = usePick(bench, (timeline) => {
    if (!timeline) return false;
    return timeline.present.origin.kind === "preset" || isChanged(timeline.present);
  });
  const hindered = useHindrance();
  const { data: health } = useHealth();
  const run = useMutation({ mutationFn: () => runFe({ accuracy: Number(wanted), mesh: mesh || null }) });
  return (
    <div className="run-control">
      {health && !health.worker.alive && (
        <span className="no-worker" title="Jobs wait in the queue until a worker runs">
          <Icon name="warning" size={13} /> No worker
        </span>
      )}
      {mesh === "" ? (
        <>
          <span className="muted">Accuracy</span>
          <Segmented label="Accuracy" options={ACCURACIES} value={wanted} onChange={accuracy.set} testId="accuracy" />
        </>
      ) : (
        <span className="muted" data-testid="no-accuracy" title={onMesh(mesh).title}>
          {onMesh(mesh).text}
        </span>
      )}
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
