import type { Curve } from "./curve";

export function ChartLegend({ curves }: { curves: readonly Curve[] }) {
  return (
    <ul className="chart-legend">
      {curves.map((curve) => (
        <li key={curve.id} className={curve.faded ? "faded" : ""}>
          <svg width="20" height="8" aria-hidden="true">
            <line
              x1="0"
              x2="20"
              y1="4"
              y2="4"
              stroke={`var(${curve.color})`}
              strokeWidth={curve.style === "dots" ? 1.2 : 2}
              strokeDasharray={curve.style === "dashed" ? "5 3" : undefined}
            />
            {curve.style === "dots" && (
              <circle cx="10" cy="4" r="2.8" fill="var(--panel)" stroke={`var(${curve.color})`} strokeWidth="1.6" />
            )}
          </svg>
          {curve.label}
        </li>
      ))}
    </ul>
  );
}
