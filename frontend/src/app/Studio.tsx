import { useEffect, useState } from "react";

import { usePick, useStore } from "../api/store";
import { CompareSheet } from "../compare/CompareSheet";
import { DrawingPanel } from "../drawing/DrawingPanel";
import { HistoryDrawer } from "../history/HistoryDrawer";
import { JobsPanel } from "../jobs/JobsPanel";
import { ParameterPanel } from "../parameters/ParameterPanel";
import { ResultsPanel } from "../results/ResultsPanel";
import { SaveDialog } from "../topbar/SaveDialog";
import { TopBar } from "../topbar/TopBar";
import { Button } from "../ui/Button";
import { Empty } from "../ui/Notice";
import { Toasts } from "../ui/toasts";
import { ViewerPanel } from "../viewer/ViewerPanel";
import { bench } from "../workbench/workbench";
import { address, goTo } from "./address";
import { KeysDialog } from "./KeysDialog";
import { layer } from "./layers";
import { useKeyboard } from "./useKeyboard";
import { useOpenAddress } from "./useOpenAddress";

const JOBS_KEY = "pneustudio.jobs";

/** The one screen. */
export function Studio() {
  const { problem, retry } = useOpenAddress();
  const [jobsOpen, setJobsOpen] = useState(() => localStorage.getItem(JOBS_KEY) !== "closed");
  useKeyboard();
  usePageTitle();
  return (
    <div className={`studio${jobsOpen ? "" : " jobs-closed"}`}>
      <TopBar />
      {problem === null ? (
        <>
          <aside className="left" aria-label="Parameters">
            <DrawingPanel />
            <ParameterPanel />
          </aside>
          <ViewerPanel />
          <ResultsPanel />
          <JobsPanel
            open={jobsOpen}
            onToggle={() => {
              localStorage.setItem(JOBS_KEY, jobsOpen ? "closed" : "open");
              setJobsOpen(!jobsOpen);
            }}
          />
        </>
      ) : (
        <main className="cannot-open" data-testid="cannot-open">
          <Empty title="This address could not be opened">
            <p>{problem}</p>
            <div className="form-buttons">
              <Button onClick={retry}>Try again</Button>
              <Button look="primary" onClick={() => goTo({ versionId: null, compare: null })}>
                Go to the bench
              </Button>
            </div>
          </Empty>
        </main>
      )}
      <Layers />
      <Toasts />
    </div>
  );
}

function Layers() {
  const name = useStore(layer);
  const compare = usePick(address, (now) => now.compare);
  return (
    <>
      {compare && <CompareSheet left={compare[0]} right={compare[1]} />}
      {name === "history" && <HistoryDrawer />}
      {name === "save" && <SaveDialog />}
      {name === "keys" && <KeysDialog />}
    </>
  );
}

function usePageTitle(): void {
  const name = usePick(bench, (timeline) => timeline?.present.work.name ?? null);
  useEffect(() => {
    document.title = name === null ? "Pneustudio" : `${name} · Pneustudio`;
  }, [name]);
}
