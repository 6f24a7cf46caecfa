import { formatQuantity } from "../ui/numbers";
import type { ViewContent } from "./view";

const MARKS = [0, 0.25, 0.5, 0.75, 1];

/** Colour scale of the 3D view, with numbers and unit. */
export function ColourLegend({ content, busy }: { content: ViewContent | null; busy: boolean }) {
  const legend = content?.legend;
  if (!legend) return busy ? <span className="stage-busy spinner" aria-label="Updating" /> : null;
  const stops = legend.stops.map(([position, colour]) => `${String(colour)} ${Number(position) * 100}%`);
  const span = legend.upper - legend.lower;
  return (
    <div className="colour-legend" data-testid="viewer-legend">
      <p>
        {legend.label}
        {legend.unit && ` (${legend.unit})`}
        {busy && <span className="spinner" aria-label="Updating" />}
      </p>
      <div className="colour-bar" style={{ background: `linear-gradient(to right, ${stops.join(", ")})` }} />
      <div className="colour-marks">
        {MARKS.map((mark) => (
          <span
            key={mark}
            title={mark === 1 && legend.clipped ? "A few values lie above the scale" : undefined}
            style={{ left: `${mark * 100}%` }}>
            {mark === 1 && legend.clipped && "≥ "}
            {formatQuantity(legend.lower + mark * span, 3)}
          </span>
        ))}
      </div>
    </div>
  );
}
