import { useStore } from "../api/store";
import { IconButton } from "../ui/Button";
import { grouped } from "../ui/numbers";
import { frameIndex, scrubber, scrubToFrame, shownPlace, togglePlay } from "../workbench/scrubber";

/** Scrubber along the path: one position for the 3D view, the plots and the numbers. `stale`: the places are of a body
 * that is being replaced. */
export function ScrubBar({ stale }: { stale: boolean }) {
  const state = useStore(scrubber);
  const last = state.frames.length - 1;
  const index = frameIndex(state);
  const at = shownPlace(state);
  const unit = state.control === "pressure" ? "kPa" : "ml";
  const share = last > 0 ? index / last : 0;
  return (
    <div className="scrub-bar">
      <IconButton
        icon={state.playing ? "pause" : "play"}
        label={state.playing ? "Pause (Space)" : "Play (Space)"}
        disabled={last < 1}
        onClick={togglePlay}
        data-testid="scrub-play"
      />
      <span className="slider scrub" style={{ "--fill": share } as React.CSSProperties}>
        <input
          type="range"
          min={0}
          max={Math.max(1, last)}
          step={1}
          value={index}
          disabled={last < 1}
          aria-label={`${state.control === "pressure" ? "Pressure" : "Volume"} shown`}
          aria-valuetext={at === null ? "no answer yet" : `${at} ${unit}`}
          data-testid="scrubber"
          onChange={(event) => scrubToFrame(event.currentTarget.valueAsNumber)}
        />
      </span>
      <output className={stale ? "scrub-pressure stale" : "scrub-pressure"} title={stale ? "Of the body that is being replaced" : undefined} data-testid="scrub-pressure">
        {at === null ? "—" : grouped(at.toFixed(1).replace("-", "−"))}
        <span className="unit">{unit}</span>
      </output>
    </div>
  );
}
