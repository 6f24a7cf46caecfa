import { splitAtTrust, type Curve } from "./curve";
import { PALE } from "./draw";

interface ChartLegendProps {
  curves: readonly Curve[];
  /** Where room is scarce, the entries stand in two places. */
  part?: "all" | "curves" | "range";
}

export function ChartLegend({ curves, part = "all" }: ChartLegendProps) {
  const beyond = curves.filter((curve) => splitAtTrust(curve).beyond.length > 1);
  const [only] = beyond;
  return (
    <ul className="chart-legend">
      {(part === "range" ? [] : curves).map((curve) => (
        <li key={curve.id} className={curve.faded ? "faded" : ""} title={curve.label}>
          <svg width="18" height="8" aria-hidden="true">
            <line
              x1="0"
              x2="18"
              y1="4"
              y2="4"
              stroke={`var(${curve.color})`}
              strokeWidth={curve.style === "dots" ? 1.2 : 2}
              strokeDasharray={curve.style === "dashed" ? "5 3" : undefined}
            />
            {curve.style === "dots" && (
              <circle cx="9" cy="4" r="2.8" fill="var(--panel)" stroke={`var(${curve.color})`} strokeWidth="1.6" />
            )}
          </svg>
          {curve.short ?? curve.label}
        </li>
      ))}
      {only && part !== "curves" && (
        <li title="Beyond the pressure up to which the model's assumptions hold">
          <svg width="18" height="8" aria-hidden="true">
            <line
              x1="0"
              x2="18"
              y1="4"
              y2="4"
              stroke={`var(${beyond.length === 1 ? only.color : "--muted"})`}
              strokeWidth="1.6"
              strokeDasharray="3 4"
              strokeOpacity={PALE}
            />
          </svg>
          beyond its range
        </li>
      )}
    </ul>
  );
}
