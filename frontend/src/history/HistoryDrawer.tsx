import { useDeferredValue, useState } from "react";

import { goTo, address } from "../app/address";
import { layer } from "../app/layers";
import { messageOf } from "../api/client";
import { useDesigns } from "../api/queries";
import { usePick } from "../api/store";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Layer } from "../ui/Layer";
import { Busy, Empty, Notice } from "../ui/Notice";
import { Segmented } from "../ui/Segmented";
import { bench } from "../workbench/workbench";
import { DesignItem } from "./DesignItem";
import type { Picked } from "./picked";

/** Every design and its versions: find, open, name, fork, compare. */
export function HistoryDrawer() {
  const [search, setSearch] = useState("");
  const [archived, setArchived] = useState(false);
  const [picked, setPicked] = useState<readonly Picked[]>([]);
  const deferred = useDeferredValue(search);
  const query = useDesigns(deferred, archived);
  const origin = usePick(bench, (timeline) => timeline?.present.origin ?? null);
  const openDesign = origin?.kind === "version" ? origin.designId : null;

  const pick = (version: Picked) =>
    setPicked((now) =>
      now.some((each) => each.id === version.id)
        ? now.filter((each) => each.id !== version.id)
        : [...now.slice(-1), version],
    );

  return (
    <Layer title="History" kind="drawer" onClose={() => layer.set("none")} testId="history">
      <div className="history-tools">
        <label className="search">
          <Icon name="search" size={14} />
          <input
            type="search"
            placeholder="Search designs"
            value={search}
            data-autofocus
            aria-label="Search designs"
            data-testid="history-search"
            onChange={(event) => setSearch(event.currentTarget.value)}
          />
        </label>
        <Segmented
          label="Which designs"
          value={archived ? "archived" : "current"}
          options={[
            { value: "current", label: "Current" },
            { value: "archived", label: "Archived" },
          ]}
          onChange={(value) => setArchived(value === "archived")}
        />
      </div>
      <div className="history-list">
        {query.isPending && <Busy label="Reading the history" />}
        {query.error && (
          <Notice tone="bad" action={<Button onClick={() => void query.refetch()}>Try again</Button>}>
            {messageOf(query.error)}
          </Notice>
        )}
        {query.data?.length === 0 && (
          <Empty title={search ? "No design of that name" : archived ? "Nothing is archived" : "No designs yet"}>
            {!search && !archived && "Save what is on the bench with Ctrl+S, and it appears here."}
          </Empty>
        )}
        {query.data?.map((design, index) => (
          <DesignItem
            key={design.id}
            design={design}
            initiallyOpen={design.id === openDesign || (openDesign === null && index === 0)}
            picked={picked}
            onPick={pick}
          />
        ))}
      </div>
      <CompareBar picked={picked} onClear={() => setPicked([])} />
    </Layer>
  );
}

function CompareBar({ picked, onClear }: { picked: readonly Picked[]; onClear: () => void }) {
  const [left, right] = picked;
  if (!left) return <p className="history-hint muted">Tick two versions to compare them.</p>;
  return (
    <div className="compare-bar">
      <span className="compare-names">
        {left.title}
        {right ? ` and ${right.title}` : ": tick one more"}
      </span>
      <Button look="ghost" onClick={onClear}>
        Clear
      </Button>
      <Button
        look="primary"
        icon="compare"
        disabled={!right}
        data-testid="history-compare"
        onClick={() => {
          if (!right) return;
          layer.set("none");
          goTo({ ...address.get(), compare: [left.id, right.id] });
        }}
      >
        Compare
      </Button>
    </div>
  );
}
