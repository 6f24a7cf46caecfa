import { layer } from "../app/layers";
import { connection } from "../api/live";
import { usePick, useStore } from "../api/store";
import { renameDesign } from "../history/rename";
import { Button, IconButton } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { InlineName } from "../ui/InlineName";
import { useHindrance } from "../workbench/hindrance";
import type { Snapshot } from "../workbench/timeline";
import { isChanged } from "../workbench/timeline";
import { bench, discardChanges, redo, setName, undo } from "../workbench/workbench";
import { CompareMenu } from "./CompareMenu";
import { DownloadMenu } from "./DownloadMenu";
import { PresetMenu } from "./PresetMenu";
import { ThemeMenu } from "./ThemeMenu";

/** Name, version, and everything that concerns the design as a whole. */
export function TopBar() {
  const timeline = useStore(bench);
  const present = timeline?.present ?? null;
  return (
    <header className="top-bar">
      <a className="brand" href="/" title="Pneustudio: the unsaved bench" onClick={(event) => event.preventDefault()}>
        <img src="/icon.svg" width="22" height="22" alt="" />
        <span>Pneustudio</span>
      </a>
      <span className="divider" />
      {present && <Title present={present} />}
      <div className="spacer" />
      <ConnectionSign />
      <div className="tool-group">
        <IconButton icon="undo" label="Undo (Ctrl+Z)" disabled={!timeline?.past.length} onClick={undo} data-testid="undo" />
        <IconButton
          icon="redo"
          label="Redo (Ctrl+Shift+Z)"
          disabled={!timeline?.future.length}
          onClick={redo}
          data-testid="redo"
        />
      </div>
      <span className="divider" />
      <PresetMenu />
      <Button icon="history" data-testid="open-history" onClick={() => layer.set("history")}>
        History
      </Button>
      <CompareMenu />
      <DownloadMenu />
      <SaveButton present={present} />
      <span className="divider" />
      <ThemeMenu />
      <IconButton icon="keyboard" label="Keyboard (?)" onClick={() => layer.set("keys")} />
    </header>
  );
}

function Title({ present }: { present: Snapshot }) {
  const { origin, work } = present;
  const changed = isChanged(present);
  return (
    <div className="title">
      <InlineName
        value={work.name}
        label="Design name"
        testId="design-name"
        onCommit={(name) => {
          if (origin.kind === "version") void renameDesign(origin.designId, name);
          else setName(name);
        }}
      />
      <span className="version-tag" data-testid="version-label">
        {origin.kind === "version" ? `v${origin.number}${origin.label ? ` ${origin.label}` : ""}` : "not saved"}
      </span>
      {changed && (
        <span className="changed-tag" data-testid="changed">
          changed
          <button type="button" className="link" title="Back to the design as it was opened (can be undone)" onClick={discardChanges}>
            discard
          </button>
        </span>
      )}
    </div>
  );
}

function SaveButton({ present }: { present: Snapshot | null }) {
  const hindered = useHindrance();
  const savable = present !== null && (present.origin.kind === "preset" || isChanged(present));
  const title = hindered ?? (savable ? "Save a version (Ctrl+S)" : "Nothing has changed since this version");
  return (
    <Button
      look="primary"
      icon="save"
      disabled={!savable || hindered !== null}
      title={title}
      data-testid="save"
      onClick={() => layer.set("save")}
    >
      Save
    </Button>
  );
}

function ConnectionSign() {
  const lost = usePick(connection, (state) => state === "lost");
  if (!lost) return null;
  return (
    <span className="connection" role="status" data-testid="offline">
      <Icon name="offline" size={14} /> Studio out of reach, trying again
    </span>
  );
}
