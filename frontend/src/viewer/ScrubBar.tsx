import { useStore } from "../api/store";
import { IconButton } from "../ui/Button";
import { frameIndex, scrubber, scrubToFrame, shownPressure, togglePlay } from "../workbench/scrubber";

/** Pressure scrubber: one position for the 3D view, the plots and the numbers. */
export function ScrubBar() {
  const state = useStore(scrubber);
  const last = state.frames.length - 1;
  const index = frameIndex(state);
  const pressure = shownPressure(state);
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
          aria-label="Pressure shown"
          aria-valuetext={pressure === null ? "no answer yet" : `${pressure} kPa`}
          data-testid="scrubber"
          onChange={(event) => scrubToFrame(event.currentTarget.valueAsNumber)}
        />
      </span>
      <output className="scrub-pressure" data-testid="scrub-pressure">
        {pressure === null ? "—" : pressure.toFixed(1)}
        <span className="unit">kPa</span>
      </output>
    </div>
  );
}
