import { useQuery } from "@tanstack/react-query";
import { useState } from "react";

import { address, goTo } from "../app/address";
import { messageOf } from "../api/client";
import { useComparison, useDesign, version } from "../api/queries";
import type { ComparedSide, Comparison } from "../api/types";
import { Button } from "../ui/Button";
import { Layer } from "../ui/Layer";
import { Busy, Notice } from "../ui/Notice";
import { ComparePlots } from "./ComparePlots";
import { CompareTable } from "./CompareTable";
import { commonPressure, highestPressure } from "./commonPressure";

function close(): void {
  goTo({ ...address.get(), compare: null });
}

/** Two versions side by side: parameters, answers, curves. */
export function CompareSheet({ left, right }: { left: string; right: string }) {
  const query = useComparison(left, right);
  return (
    <Layer
      title="Compare versions"
      kind="sheet"
      onClose={close}
      testId="compare"
      tools={
        <Button look="ghost" icon="compare" onClick={() => goTo({ ...address.get(), compare: [right, left] }, "replace")}>
          Swap sides
        </Button>
      }
    >
      {query.isPending && <Busy label="Comparing" />}
      {query.error && (
        <Notice tone="bad" action={<Button onClick={() => void query.refetch()}>Try again</Button>}>
          {messageOf(query.error)}
        </Notice>
      )}
      {query.data && <Compared comparison={query.data} />}
    </Layer>
  );
}

function Compared({ comparison }: { comparison: Comparison }) {
  const { left, right } = comparison;
  const results = [left.instant_result, right.instant_result, left.fe_result, right.fe_result];
  const [chosen, choose] = useState<number | null>(null);
  const top = highestPressure(results);
  const pressure = chosen === null ? commonPressure(results) : Math.min(chosen, top ?? chosen);
  return (
    <div className="compare-body">
      <div className="compare-columns">
        <SideHead side={comparison.left} which="left" other={comparison.right.version.id} />
        <SideHead side={comparison.right} which="right" other={comparison.left.version.id} />
        <CompareTable comparison={comparison} pressure={pressure} top={top} onChoose={choose} />
      </div>
      <ComparePlots comparison={comparison} pressure={pressure} onPick={choose} />
    </div>
  );
}

interface SideHeadProps {
  side: ComparedSide;
  which: "left" | "right";
  other: string;
}

/** Name of a side, and the other versions of its design to change to. */
function SideHead({ side, which, other }: SideHeadProps) {
  const { version: shown } = side;
  const { data: design } = useDesign(shown.design_id);
  const { isFetching } = useQuery({ ...version(shown.id), enabled: false });
  const choose = (id: string) => {
    goTo({ ...address.get(), compare: which === "left" ? [id, other] : [other, id] }, "replace");
  };
  return (
    <div className={`compare-side ${which === "left" ? "first" : "second"}`} aria-busy={isFetching}>
      <strong>{shown.design_name}</strong>
      <select
        className="select"
        aria-label={`Version on the ${which}`}
        value={shown.id}
        data-testid={`compare-${which}`}
        onChange={(event) => choose(event.currentTarget.value)}
      >
        {(design?.versions ?? [shown]).map((each) => (
          <option key={each.id} value={each.id}>
            v{each.number}
            {each.label ? ` ${each.label}` : ""}
          </option>
        ))}
      </select>
    </div>
  );
}
