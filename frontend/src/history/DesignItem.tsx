import { useMutation } from "@tanstack/react-query";
import { useState } from "react";

import { api, messageOf, take } from "../api/client";
import { keys, queryClient, useDesign } from "../api/queries";
import type { DesignSummary } from "../api/types";
import { Button, IconButton } from "../ui/Button";
import { InlineName } from "../ui/InlineName";
import { Busy, Notice } from "../ui/Notice";
import { formatMoment } from "../ui/numbers";
import { showToast } from "../ui/toasts";
import type { Picked } from "./picked";
import { renameDesign } from "./rename";
import { VersionItem } from "./VersionItem";

interface DesignItemProps {
  design: DesignSummary;
  initiallyOpen: boolean;
  picked: readonly Picked[];
  onPick: (version: Picked) => void;
}

export function DesignItem({ design, initiallyOpen, picked, onPick }: DesignItemProps) {
  const [open, setOpen] = useState(initiallyOpen);
  const archive = useMutation({
    mutationFn: (archived: boolean) =>
      take(api.PATCH("/api/designs/{design_id}", { params: { path: { design_id: design.id } }, body: { archived } })),
    onSuccess: (_, archived) => {
      void queryClient.invalidateQueries({ queryKey: keys.designs });
      showToast({
        tone: "good",
        text: archived ? `${design.name} is archived.` : `${design.name} is back.`,
        ...(archived ? { action: { label: "Undo", run: () => archive.mutate(false) } } : {}),
      });
    },
    onError: (error) => showToast({ tone: "bad", text: messageOf(error) }),
  });
  return (
    <article className={`design-item${open ? " open" : ""}`} data-testid={`design-${design.id}`}>
      <header>
        <IconButton
          icon="chevron"
          label={open ? "Fold away" : "Show versions"}
          className={open ? "" : "turned"}
          aria-expanded={open}
          onClick={() => setOpen(!open)}
        />
        <div className="design-title">
          <InlineName
            value={design.name}
            label="Design name"
            onCommit={(name) => void renameDesign(design.id, name)}
          />
          <p className="muted">
            {design.family}, {design.version_count} {design.version_count === 1 ? "version" : "versions"},{" "}
            {design.author}, {formatMoment(design.updated_at)}
          </p>
        </div>
        <IconButton
          icon="archive"
          label={design.archived ? "Take out of the archive" : "Archive"}
          disabled={archive.isPending}
          onClick={() => archive.mutate(!design.archived)}
        />
      </header>
      {open && <Versions designId={design.id} name={design.name} picked={picked} onPick={onPick} />}
    </article>
  );
}

function Versions(props: { designId: string; name: string; picked: readonly Picked[]; onPick: (version: Picked) => void }) {
  const query = useDesign(props.designId);
  if (query.isPending) return <Busy label="Reading versions" />;
  if (query.error) {
    return (
      <Notice tone="bad" action={<Button onClick={() => void query.refetch()}>Try again</Button>}>
        {messageOf(query.error)}
      </Notice>
    );
  }
  return (
    <ol className="versions">
      {query.data.versions.map((version) => (
        <VersionItem
          key={version.id}
          version={version}
          designName={props.name}
          picked={props.picked.some((each) => each.id === version.id)}
          onPick={() => props.onPick({ id: version.id, title: `${props.name} v${version.number}` })}
        />
      ))}
    </ol>
  );
}
