import { useStore } from "../api/store";
import type { Ladder, LadderPoint } from "../api/types";
import { Button } from "../ui/Button";
import { NumberField } from "../ui/NumberField";
import { formatPercent, sentence } from "../ui/numbers";
import { useHindrance } from "../workbench/hindrance";
import { limits, MOST, withLimit, type Limits } from "./limits";
import { inWords, mayBeAnywhere, rungName, shortName } from "./points";
import { shortSeconds } from "./scale";
import { takeRung } from "./take";

/** The cheapest rung within an error, and the most accurate one within a time. */
export function Picks({ ladder, stale }: { ladder: Ladder; stale: boolean }) {
  const now = useStore(limits);
  const [within, quick] = ladder.choices;
  const row = (name: keyof Limits, unit: string, label: string, choice: typeof within) => (
    <Pick
      name={name}
      unit={unit}
      label={label}
      value={now[name]}
      why={choice?.why ?? ""}
      point={ladder.points.find((point) => point.label === choice?.rung) ?? null}
      stale={stale}
    />
  );
  return (
    <div className="picks">
      {row("percent", "%", "Largest error", within)}
      {row("seconds", "s", "Longest time", quick)}
    </div>
  );
}

/** Upper end of a range over what is expected, from which on a pick names it. */
const FAR = 1.5;

interface PickProps {
  name: keyof Limits;
  unit: string;
  label: string;
  value: number;
  why: string;
  point: LadderPoint | null;
  stale: boolean;
}

function Pick({ name, unit, label, value, why, point, stale }: PickProps) {
  const hindered = useHindrance();
  const words = sentence(inWords(why));
  const queued = point?.rung === "fe" && !isThere(point);
  return (
    <div className="pick-row" data-testid={`pick-${name}`} data-rung={point?.label ?? ""}>
      <span>At most</span>
      <NumberField value={value} step={1} unit={unit} label={label} onCommit={(next) => limits.update((all) => withLimit(all, name, next))} above={0} most={MOST[name]} standsAside testId={`limit-${name}`} />
      <span className={`pick-rung${stale ? " faded" : ""}`} title={words}>
        {point ? (
          <>
            <strong title={rungName(point)}>{shortName(point)}</strong> <span className="muted">{beside(name, point)}</span>
          </>
        ) : (
          <span className="muted">no rung: hover to read why</span>
        )}
      </span>
      <Button
        look="plain"
        icon={queued ? "play" : "eye"}
        disabled={stale || point === null || point.job_id !== null || (point.rung === "fe" && hindered !== null)}
        title={stale ? "Picked for the earlier question" : point === null ? words : (hindered ?? words)}
        data-testid={`take-${name}`}
        onClick={() => {
          if (point) void takeRung(point);
        }}
      >
        {point?.job_id != null ? "Running" : queued ? "Run" : "Show"}
      </Button>
    </div>
  );
}

/** What the other axis says of the rung picked, and where its answer is there, that it is: such a one fits any time. */
export function beside(limit: keyof Limits, point: LadderPoint): string {
  const { seconds } = point;
  const error = limit === "seconds" ? errorOf(point) : "";
  if (!isThere(point)) return [error, seconds ? expected(seconds) : ""].filter(Boolean).join(", ");
  const there = `there already${seconds ? `, ${shortSeconds(seconds.value)}` : ""}`;
  return [error, there.replaceAll(" ", "\u00a0")].filter(Boolean).join(", ");
}

/** "~ 9.9 s (to 1.6 min)": with the upper end of its range where that is far off. */
function expected({ value, high }: NonNullable<LadderPoint["seconds"]>): string {
  const far = high > FAR * value ? ` (to ${shortSeconds(high)})` : "";
  return `~ ${shortSeconds(value)}${far}`.replaceAll(" ", "\u00a0");
}

/** Whether its answer costs nothing more: it has run, or another's answer stands for it. */
function isThere({ state, same_as: same }: LadderPoint): boolean {
  return state === "measured" || same !== null;
}

function errorOf(point: LadderPoint): string {
  const { error_percent: error } = point;
  if (!error) return "";
  if (mayBeAnywhere(point)) return "may\u00a0be\u00a0anywhere";
  const worst = formatPercent(error.high);
  return (/^\d/.test(worst) ? `up to ${worst}` : worst).replaceAll(" ", "\u00a0");
}
