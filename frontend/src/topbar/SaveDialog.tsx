import { useMutation } from "@tanstack/react-query";
import { useState } from "react";

import { layer } from "../app/layers";
import { messageOf } from "../api/client";
import { usePick } from "../api/store";
import { Button } from "../ui/Button";
import { Layer } from "../ui/Layer";
import { Notice } from "../ui/Notice";
import { showToast } from "../ui/toasts";
import { saveVersion } from "../workbench/opening";
import { bench, setName } from "../workbench/workbench";

function close(): void {
  layer.set("none");
}

/** Name (for a new design) and note, then the version is kept. */
export function SaveDialog() {
  const present = usePick(bench, (timeline) => timeline?.present ?? null);
  const [note, setNote] = useState("");
  const isNew = present?.origin.kind === "preset";
  const [name, setDraftName] = useState(present?.work.name ?? "");
  const save = useMutation({
    mutationFn: () => {
      if (isNew) setName(name.trim());
      return saveVersion(note.trim());
    },
    onSuccess: (detail) => {
      close();
      showToast({ tone: "good", text: `${detail.design_name} v${detail.number} is saved.` });
    },
  });
  return (
    <Layer title={isNew ? "Save as a new design" : "Save a version"} kind="dialog" onClose={close} testId="save-dialog">
      <form
        className="form"
        onSubmit={(event) => {
          event.preventDefault();
          if (!save.isPending) save.mutate();
        }}
      >
        {isNew && (
          <label className="field">
            Name
            <input
              value={name}
              required
              maxLength={200}
              data-autofocus
              data-testid="save-name"
              onFocus={(event) => event.currentTarget.select()}
              onChange={(event) => setDraftName(event.currentTarget.value)}
            />
          </label>
        )}
        <label className="field">
          Note
          <input
            value={note}
            maxLength={2000}
            {...(isNew ? {} : { "data-autofocus": true })}
            placeholder="What changed, and why (may stay empty)"
            data-testid="save-note"
            onChange={(event) => setNote(event.currentTarget.value)}
          />
        </label>
        {save.error && <Notice tone="bad">{messageOf(save.error)}</Notice>}
        <div className="form-buttons">
          <Button onClick={close}>Cancel</Button>
          <Button look="primary" type="submit" disabled={save.isPending || (isNew && !name.trim())} data-testid="save-confirm">
            {save.isPending ? "Saving" : "Save"}
          </Button>
        </div>
      </form>
    </Layer>
  );
}
