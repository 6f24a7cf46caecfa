import { useEffect, useRef, useState } from "react";

import { connection } from "../api/live";
import { usePick, useStore } from "../api/store";
import { useDrawn } from "../results/drawn";
import { useShownFe } from "../results/shown";
import { feLabel } from "../results/words";
import { Button } from "../ui/Button";
import { Icon } from "../ui/Icon";
import { Busy, Empty } from "../ui/Notice";
import { Segmented } from "../ui/Segmented";
import { answers } from "../workbench/answers";
import { ColourLegend } from "./ColourLegend";
import { PathEnd } from "./PathEnd";
import { ScrubBar } from "./ScrubBar";
import { colourFor, setViewer, viewerSettings } from "./settings";
import { useInstantShape, useSource } from "./source";
import { useViewFeed } from "./useViewFeed";
import { isBehind, openView, setCamera, view, type Camera, type Colour } from "./view";

const COLOURS: readonly { value: Colour; label: string; title: string }[] = [
  { value: "displacement", label: "Displacement", title: "Length of the displacement" },
  { value: "stretch", label: "Stretch", title: "Largest principal stretch" },
  { value: "stress", label: "Stress", title: "Largest principal Cauchy stress" },
  { value: "contact", label: "Contact", title: "Pressure where surfaces touch" },
  { value: "none", label: "Plain", title: "Colours of the materials" },
];

const CAMERAS: readonly { value: Camera; label: string; title: string }[] = [
  { value: "three-quarter", label: "3D", title: "View from the corner" },
  { value: "side", label: "Side", title: "View along X2" },
  { value: "top", label: "Top", title: "View along X3" },
  { value: "below", label: "Below", title: "Onto the underside, where it presses on a plate" },
  { value: "front", label: "Tip", title: "View along X1, onto the free end" },
];

/** The 3D view with its controls above and the pressure scrubber below. */
export function ViewerPanel() {
  useViewFeed();
  const stale = useStaleness();
  return (
    <section className="viewer" aria-label="3D view">
      <Toolbar />
      <Stage stale={stale} />
      <ScrubBar stale={stale} />
    </section>
  );
}

function Toolbar() {
  const settings = useStore(viewerSettings);
  const fe = useShownFe();
  const source = useSource();
  // Only a result in which something can touch has contact pressures.
  const touching = usePick(view, (state) => state.content?.colours.includes("contact") ?? false);
  const wanted = colourFor(settings.colour, source);
  const colour = wanted === "contact" && !touching ? "displacement" : wanted;
  return (
    <div className="viewer-toolbar">
      <Segmented
        label="Source of the 3D view"
        value={source}
        options={[
          {
            value: "instant",
            label: "Instant",
            title: "The answer to the parameters as they stand: the cell and rod's once the hand rests, before that the energy model's",
          },
          {
            value: "fe",
            label: "FE",
            title: fe ? feLabel(fe.job) : "This version has no finite-element result yet",
            disabled: !fe,
          },
        ]}
        onChange={(next) => setViewer({ source: next })}
        testId="viewer-source"
      />
      <div className="spacer" />
      <label className="check" title="Show the body before gravity and pressure as well">
        <input
          type="checkbox"
          checked={settings.undeformed}
          data-testid="viewer-undeformed"
          onChange={(event) => setViewer({ undeformed: event.currentTarget.checked })}
        />
        Undeformed
      </label>
      <Segmented
        label="Colour by"
        value={colour}
        options={COLOURS.filter((each) => each.value !== "contact" || touching).map((each) => {
          const missing = colourFor(each.value, source) !== each.value;
          return missing
            ? { ...each, disabled: true, title: `${each.title}: only a finite-element result has it` }
            : each;
        })}
        onChange={(colour) => setViewer({ colour })}
        testId="viewer-colour"
      />
    </div>
  );
}

/** Whether the body in view is not, or not yet, that of what is on the bench. */
function useStaleness(): boolean {
  const behind = usePick(view, isBehind);
  const source = useSource();
  const shape = useInstantShape();
  return behind || (source === "instant" && shape !== null && !shape.fits);
}

function Stage({ stale }: { stale: boolean }) {
  const state = useStore(view);
  const lost = useStore(connection) === "lost";
  const drawn = useDrawn();
  const beyond = usePick(answers, (now) => now.instantProblem !== null) && drawn === null;
  const source = useSource();
  return (
    <div className="stage" data-testid="viewer-stage" data-phase={state.phase} data-stale={stale}>
      {state.url && <Frame key={state.room} url={state.url} />}
      {state.phase === "opening" && !lost && (
        <div className="stage-cover">
          <Busy label="Preparing the 3D view" />
        </div>
      )}
      {state.phase === "failed" && !lost && (
        <div className="stage-cover">
          <Empty title="The 3D view could not be opened">
            <p>{state.problem}</p>
            <Button onClick={() => void openView()}>Try again</Button>
          </Empty>
        </div>
      )}
      {lost && (
        <div className="stage-cover veil" data-testid="viewer-lost">
          <Empty title="The studio is out of reach">
            <p>The view comes back by itself. Your parameters are kept in this browser.</p>
          </Empty>
        </div>
      )}
      {state.phase === "ready" && beyond && source === "instant" && (
        <p className="stage-problem beyond" data-testid="viewer-beyond">
          <Icon name="info" size={13} /> The instant model has no answer to this load: this is the last one it had.
        </p>
      )}
      {state.phase === "ready" && state.problem && (
        <p className="stage-problem" role="alert">
          <Icon name="warning" size={13} /> {state.problem}
        </p>
      )}
      {state.phase === "ready" && !lost && (
        <>
          <ColourLegend content={state.content} busy={isBehind(state)} />
          <PathEnd />
          <div className="cameras" role="group" aria-label="Camera">
            {CAMERAS.map((camera) => (
              <button key={camera.value} type="button" title={camera.title} onClick={() => setCamera(camera.value)}>
                {camera.label}
              </button>
            ))}
          </div>
        </>
      )}
    </div>
  );
}

/** The room's page. A frame that lost its socket connects again only when it has the focus, so it
 * is given the focus when the studio is back, and the page takes it back. */
function Frame({ url }: { url: string }) {
  const frame = useRef<HTMLIFrameElement>(null);
  const [loaded, setLoaded] = useState(false);
  const state = useStore(connection);
  const before = useRef(state);

  useEffect(() => {
    const returned = before.current === "lost" && state === "live";
    before.current = state;
    if (!returned) return;
    const holder = document.activeElement;
    frame.current?.contentWindow?.focus();
    const back = window.setTimeout(() => {
      if (holder instanceof HTMLElement) holder.focus({ preventScroll: true });
    }, 300);
    return () => window.clearTimeout(back);
  }, [state]);

  return (
    <iframe
      ref={frame}
      src={url}
      title="3D view of the actuator: drag to turn, wheel to zoom"
      className={loaded ? "loaded" : ""}
      data-testid="viewer-frame"
      onLoad={() => setLoaded(true)}
    />
  );
}
