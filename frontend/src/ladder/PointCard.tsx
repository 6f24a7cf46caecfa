import type { LadderPoint } from "../api/types";
import { useLateness } from "../jobs/expected";
import { about, actionOf, rungName, standing } from "./points";

const WIDTH = 252;
export const EARLIER = "This is of the earlier question.";

interface PointCardProps {
  point: LadderPoint;
  also: readonly string[];
  stale: boolean;
  /** Where its point stands in the chart [px]. */
  at: { x: number; y: number };
  width: number;
  height: number;
}

/** What a point means, above it; the point's own label says the same to a screen reader. */
export function PointCard({ point, also, stale, at, width, height }: PointCardProps) {
  const late = useLateness(point.job_id);
  const action = actionOf(point, stale);
  const left = Math.max(4, Math.min(at.x - WIDTH / 2, width - WIDTH - 4));
  return (
    <div className="point-card" style={{ left, bottom: height - at.y + 14, width: WIDTH }} aria-hidden="true" data-testid="ladder-card">
      <p className="point-title">
        {rungName(point)} <span className="muted">{standing(point)}</span>
      </p>
      {about(point, also).map((line) => (
        <p key={line}>{line}</p>
      ))}
      {late !== null && <p className="late">{late}.</p>}
      {stale && <p className="muted">{EARLIER}</p>}
      {action && <p className="muted">{action}.</p>}
    </div>
  );
}
