import { useMutation } from "@tanstack/react-query";

import { layer } from "../app/layers";
import { api, messageOf, take } from "../api/client";
import { keys, queryClient } from "../api/queries";
import { usePick } from "../api/store";
import type { ResultSummary, VersionSummary } from "../api/types";
import { meshOrAccuracy, outcomeInWords } from "../results/words";
import { Button, IconButton } from "../ui/Button";
import { InlineName } from "../ui/InlineName";
import { formatMoment, formatQuantity } from "../ui/numbers";
import { showToast } from "../ui/toasts";
import { openVersion } from "../workbench/opening";
import { bench } from "../workbench/workbench";
import { changeInWords } from "./changes";
import { labelVersion } from "./rename";

interface VersionItemProps {
  version: VersionSummary;
  designName: string;
  picked: boolean;
  onPick: () => void;
}

export function VersionItem({ version, designName, picked, onPick }: VersionItemProps) {
  const isOpen = usePick(bench, (timeline) => {
    const origin = timeline?.present.origin;
    return origin?.kind === "version" && origin.versionId === version.id;
  });
  const fork = useMutation({
    mutationFn: () =>
      take(
        api.POST("/api/versions/{version_id}/fork", {
          params: { path: { version_id: version.id } },
          body: { name: `${designName} (fork of v${version.number})` },
        }),
      ),
    onSuccess: (made) => {
      queryClient.setQueryData(keys.version(made.version.id), made.version);
      void queryClient.invalidateQueries({ queryKey: keys.designs });
      layer.set("none");
      openVersion(made.version.id);
      showToast({ tone: "good", text: `${made.version.design_name} is open.` });
    },
    onError: (error) => showToast({ tone: "bad", text: messageOf(error) }),
  });
  return (
    <li className={`version${isOpen ? " current" : ""}`} data-testid={`version-${version.id}`}>
      <input
        type="checkbox"
        checked={picked}
        aria-label={`Compare version ${version.number}`}
        title="Tick to compare"
        data-testid={`pick-${version.id}`}
        onChange={onPick}
      />
      <div className="version-text">
        <p className="version-head">
          <strong>v{version.number}</strong>
          <InlineName
            value={version.label ?? ""}
            placeholder="add a label"
            label={`Label of version ${version.number}`}
            onCommit={(text) => void labelVersion(version.id, text)}
          />
          <span className="muted">
            {version.author}, {formatMoment(version.created_at)}
          </span>
        </p>
        {version.note && <p className="version-note">{version.note}</p>}
        <Changes version={version} />
        {version.results.map((result) => (
          <ResultLine key={result.job_id} result={result} />
        ))}
      </div>
      <div className="version-tools">
        {isOpen ? (
          <span className="badge">Open</span>
        ) : (
          <Button
            data-testid={`open-${version.id}`}
            onClick={() => {
              layer.set("none");
              openVersion(version.id);
            }}
          >
            Open
          </Button>
        )}
        <IconButton
          icon="fork"
          label="Fork into a design of its own"
          disabled={fork.isPending}
          data-testid={`fork-${version.id}`}
          onClick={() => fork.mutate()}
        />
      </div>
    </li>
  );
}

function Changes({ version }: { version: VersionSummary }) {
  if (version.changes.length === 0) {
    return <p className="muted">{version.parent_id === null ? "First version" : "Parameters unchanged"}</p>;
  }
  return (
    <ul className="changes">
      {version.changes.map((change) => (
        <li key={change.name}>{changeInWords(change)}</li>
      ))}
    </ul>
  );
}

function ResultLine({ result }: { result: ResultSummary }) {
  return (
    <p className="result-line" title={outcomeInWords(result.outcome)}>
      <span className="series-fe">
        {result.rung === "fe" ? "FE" : result.rung} {meshOrAccuracy(result)}
      </span>{" "}
      {formatQuantity(result.bending_angle_deg)}°
      {result.plate_force_N !== null && `, ${formatQuantity(result.plate_force_N)} N on the plate`} at{" "}
      {formatQuantity(result.pressure_kPa)} kPa
      {result.outcome !== "converged" && ` (${result.outcome.replaceAll("_", " ")})`}
    </p>
  );
}
