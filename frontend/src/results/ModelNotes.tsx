import { usePick } from "../api/store";
import type { Result } from "../api/types";
import { Icon } from "../ui/Icon";
import { aboutPercent, formatPercent, formatQuantity, formatSeconds, sentence } from "../ui/numbers";
import { answers } from "../workbench/answers";
import { modelName } from "../workbench/model";
import type { ShownFe } from "./shown";
import { endInWords } from "./words";

export function useNoteCount(instant: Result | null, fe: ShownFe | null): number {
  const assumptions = (instant ?? fe?.result)?.assumptions.length ?? 0;
  return (instant?.notes.length ?? 0) + assumptions + (fe?.result.notes.length ?? 0);
}

/** What the answers rest on: outcome, findings, assumptions, effects, derived dimensions. */
export function ModelNotes({ instant, fe, totalMs }: { instant: Result | null; fe: ShownFe | null; totalMs: number | null }) {
  const assumptions = (instant ?? fe?.result)?.assumptions ?? [];
  const derived = usePick(answers, (now) => now.check?.derived ?? null);
  return (
    <div className="model-notes" data-testid="model-notes">
      {instant && (
        <ResultNotes
          title={`${modelName(instant.rung)}, answered here`}
          className="series-instant"
          result={instant}
          facts={[totalMs === null ? "" : `answered in ${formatQuantity(totalMs, 2)} ms`]}
        />
      )}
      {fe && (
        <ResultNotes
          title="3D finite elements"
          className="series-fe"
          result={fe.result}
          facts={[
            fe.result.wall_s === null ? "" : `solved in ${formatSeconds(fe.result.wall_s)}`,
            `${fe.result.unknowns.toLocaleString("en")} unknowns`,
            errorsInWords(fe.result),
          ]}
        />
      )}
      {assumptions.length > 0 && (
        <section>
          <h3>Assumptions</h3>
          <ul>
            {assumptions.map((each) => (
              <li key={each}>{readable(each)}</li>
            ))}
          </ul>
        </section>
      )}
      {derived && derived.length > 0 && (
        <section>
          <h3>Follows from the parameters</h3>
          <dl className="derived">
            {derived.map((each) => (
              <div key={each.label}>
                <dt>{each.label}</dt>
                <dd>
                  {formatQuantity(each.value, 4)} {each.unit}
                </dd>
              </div>
            ))}
          </dl>
        </section>
      )}
    </div>
  );
}

const ESTIMATED: Record<string, string> = { tip: "tip", angle: "angle", volume: "volume", force: "force", limit_pressure: "limit pressure" };

/** "estimated errors: tip 1.2 %, angle 0.8 %" */
function errorsInWords(result: Result): string {
  const named = Object.entries(result.error_estimates_percent).flatMap(([name, value]) =>
    value === null ? [] : [`${ESTIMATED[name] ?? name.replaceAll("_", " ")} ${formatPercent(value)}`],
  );
  if (named.length > 0) return `estimated errors: ${named.join(", ")}`;
  const { error_estimate_percent: whole } = result;
  return whole === null ? "no error estimate" : `estimated error ${formatPercent(whole)}`;
}

function ResultNotes(props: { title: string; className: string; result: Result; facts: string[] }) {
  const { title, className, result, facts } = props;
  const reached = result.path.at(-1)?.pressure_kPa;
  return (
    <section>
      <h3 className={className}>{title}</h3>
      <p className={result.outcome === "converged" ? "" : "early-end"} data-testid="outcome">
        {result.outcome !== "converged" && <Icon name="warning" size={13} />} {endInWords(result)}
        {result.outcome !== "converged" && reached !== null && reached !== undefined
          ? ` Last point at ${formatQuantity(reached)} kPa.`
          : ""}
        {result.advice ? ` ${result.advice}` : ""}
      </p>
      <p className="muted">{facts.filter(Boolean).join(", ")}</p>
      {result.notes.length > 0 && (
        <ul className="findings">
          {result.notes.map((note) => (
            <li key={note}>{note}</li>
          ))}
        </ul>
      )}
      {result.effects.length > 0 && (
        <table className="effects">
          <tbody>
            {result.effects.map((effect) => (
              <tr key={effect.name}>
                <th scope="row">{effect.name.replaceAll("_", " ")}</th>
                <td className={effect.on ? "on" : "off"}>{effect.on ? "on" : "off"}</td>
                <td>
                  {sentence(effect.reason)}
                  {effect.estimated_change_percent !== null &&
                    ` ${result.rung === "fe" ? "By an estimate beforehand" : "In this answer"}, leaving it out changes the tip\u2019s way by ${aboutPercent(effect.estimated_change_percent)}.`}
                </td>
              </tr>
            ))}
          </tbody>
        </table>
      )}
    </section>
  );
}

/** "bottom_thickness is not given ..." reads better with its name spelt out. */
function readable(text: string): string {
  return sentence(text.replace(/^[a-z0-9]+(_[a-z0-9]+)+/, (name) => name.replaceAll("_", " ")));
}
