import { formatQuantity } from "../ui/numbers";
import { modelName } from "../workbench/model";
import type { ViewContent } from "./view";

const MARKS = [0, 0.25, 0.5, 0.75, 1];

/** What the 3D view shows: whose shape it is, and the colour scale with numbers and unit. */
export function ColourLegend({ content, busy }: { content: ViewContent | null; busy: boolean }) {
  if (!content) return busy ? <span className="stage-busy spinner" aria-label="Updating" /> : null;
  return (
    <div className="colour-legend" data-testid="viewer-legend">
      <p className="shown-model" data-testid="viewer-model" data-rung={content.rung}>
        Shape: {modelName(content.rung)}
        {busy && <span className="spinner" aria-label="Updating" />}
      </p>
      {content.legend && <Scale legend={content.legend} />}
    </div>
  );
}

function Scale({ legend }: { legend: NonNullable<ViewContent["legend"]> }) {
  const stops = legend.stops.map(([position, colour]) => `${String(colour)} ${Number(position) * 100}%`);
  const span = legend.upper - legend.lower;
  return (
    <>
      <p>
        {legend.label}
        {legend.unit && ` (${legend.unit})`}
      </p>
      <div className="colour-bar" style={{ background: `linear-gradient(to right, ${stops.join(", ")})` }} />
      <div className="colour-marks">
        {MARKS.map((mark) => (
          <span
            key={mark}
            title={mark === 1 && legend.clipped ? "A few values lie above the scale" : undefined}
            style={{ left: `${mark * 100}%` }}
          >
            {mark === 1 && legend.clipped && "≥ "}
            {formatQuantity(legend.lower + mark * span, 3)}
          </span>
        ))}
      </div>
    </>
  );
}
