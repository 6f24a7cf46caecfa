import { usePick } from "../api/store";
import type { Result } from "../api/types";
import { Icon } from "../ui/Icon";
import { formatQuantity, formatSeconds, sentence } from "../ui/numbers";
import { answers } from "../workbench/answers";
import type { ShownFe } from "./shown";
import { endInWords } from "./words";

export function useNoteCount(result: Result, fe: ShownFe | null): number {
  return result.notes.length + result.assumptions.length + (fe?.result.notes.length ?? 0);
}

/** What the answers rest on: outcome, findings, assumptions, effects, derived dimensions. */
export function ModelNotes({ result, fe, totalMs }: { result: Result; fe: ShownFe | null; totalMs: number | null }) {
  const derived = usePick(answers, (now) => now.check?.derived ?? null);
  return (
    <div className="model-notes" data-testid="model-notes">
      <ResultNotes
        title="Instant model"
        className="series-instant"
        result={result}
        facts={[totalMs === null ? "" : `answered in ${formatQuantity(totalMs, 2)} ms`]}
      />
      {fe && (
        <ResultNotes
          title="3D finite elements"
          className="series-fe"
          result={fe.result}
          facts={[
            fe.result.wall_s === null ? "" : `solved in ${formatSeconds(fe.result.wall_s)}`,
            `${fe.result.unknowns.toLocaleString("en")} unknowns`,
            fe.result.error_estimate_percent === null
              ? "no error estimate"
              : `estimated error ${formatQuantity(fe.result.error_estimate_percent, 2)} %`,
          ]}
        />
      )}
      {result.assumptions.length > 0 && (
        <section>
          <h3>Assumptions</h3>
          <ul>
            {result.assumptions.map((each) => (
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
                    ` Changes the answer by about ${formatQuantity(effect.estimated_change_percent, 2)} %.`}
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
