import type { Result } from "../api/types";
import { valueAt } from "../charts/curve";
import { Icon } from "../ui/Icon";
import { decimalsOf, formatPercent, formatQuantity, formatUncertainty } from "../ui/numbers";
import { MathSymbol } from "../ui/Symbol";
import type { Control } from "../workbench/loads";
import { modelName } from "../workbench/model";
import { caveatOf, PRESSURE, QUANTITIES, type Quantity } from "./quantities";
import { reached, within } from "./reached";
import type { ShownFe } from "./shown";
import { uncertainty, type Uncertainty } from "./uncertainty";
import { beyondInWords, kPa, placeInWords } from "./words";

interface NumbersTableProps {
  /** Null where the instant model has no answer. */
  instant: Result | null;
  fe: ShownFe | null;
  control: Control;
  /** Place on the path; null stands for its end. */
  at: number | null;
}

function knows(result: Result, quantity: Quantity): boolean {
  return result.path.some((point) => typeof quantity.value(point) === "number");
}

function listed(instant: Result | null, fe: ShownFe | null, control: Control): Quantity[] {
  const known = (quantity: Quantity) => [instant, fe?.result].some((result) => result && knows(result, quantity));
  const usual = QUANTITIES.filter((quantity) => !quantity.rare || known(quantity));
  return control === "volume" ? [PRESSURE, ...usual] : usual;
}

function isEstimated(result: Result | null | undefined): boolean {
  return Object.keys(result?.error_estimates_percent ?? {}).length > 0;
}

/** Every quantity at the scrubber's place on the path. */
export function NumbersTable({ instant, fe, control, at }: NumbersTableProps) {
  const any = instant ?? fe?.result;
  const place = at ?? (any ? reached(any, control) : null) ?? 0;
  const estimates = fe?.result.error_estimates_percent ?? {};
  const estimated = isEstimated(fe?.result);
  const instantEstimated = isEstimated(instant);
  return (
    <table className={estimated && instantEstimated ? "numbers tight" : "numbers"} data-testid="numbers">
      <thead>
        <tr>
          <th scope="col">Quantity</th>
          {instant && <InstantHead result={instant} place={place} control={control} />}
          {instantEstimated && (
            <th scope="col" title="Error that the model expects of its answer, in the unit of its row">
              ±
            </th>
          )}
          {fe && <FeHead fe={fe} control={control} place={place} />}
          {estimated && (
            <th scope="col" title="Estimated error of the finite-element answer, from nested meshes, in the unit of its row">
              ±
            </th>
          )}
          <th scope="col">Unit</th>
        </tr>
      </thead>
      <tbody>
        {listed(instant, fe, control).map((quantity) => (
          <tr key={quantity.name} title={quantity.help}>
            <th scope="row">
              {quantity.label} <MathSymbol symbol={quantity.symbol} />
            </th>
            {instant && <InstantCell result={instant} quantity={quantity} place={place} control={control} />}
            {instant && instantEstimated && (
              <EstimateCell result={instant} quantity={quantity} place={place} control={control} testId={`estimate-${instant.rung}-${quantity.name}`} />
            )}
            {fe && <FeCell fe={fe} quantity={quantity} place={within(fe.result, place, control)} control={control} />}
            {estimated && fe && (
              <EstimateCell result={fe.result} quantity={quantity} place={within(fe.result, place, control)} control={control} testId={`estimate-${quantity.name}`} />
            )}
            <td className="unit">{quantity.unit}</td>
          </tr>
        ))}
        {fe && <LimitRow fe={fe} before={(instant ? 1 : 0) + (instantEstimated ? 1 : 0)} estimate={estimated ? (estimates.limit_pressure ?? null) : undefined} />}
      </tbody>
    </table>
  );
}

interface InstantProps {
  result: Result;
  place: number;
  control: Control;
}

function InstantHead({ result, place, control }: InstantProps) {
  const beyond = beyondInWords(result, place, control);
  return (
    <th scope="col" className="series-instant" title={beyond} data-testid="drawn-model" data-rung={result.rung}>
      {beyond !== undefined && <Icon name="warning" size={11} />} {modelName(result.rung)}
    </th>
  );
}

/** Beyond the model's own range its number may be anything, and is as pale as its curve is there. */
function InstantCell({ result, quantity, place, control }: InstantProps & { quantity: Quantity }) {
  const value = valueAt(result, place, quantity.value, control);
  const beyond = beyondInWords(result, place, control);
  return (
    <td className={beyond === undefined ? "" : "faded"} title={beyond} data-testid={`number-${quantity.name}`}>
      {shown(value, quantity, uncertainty(result, quantity, place, control))}
      {value !== null && <Caveat result={result} quantity={quantity} />}
    </td>
  );
}

/** What an answer's notes say of this very number. */
function Caveat({ result, quantity }: { result: Result; quantity: Quantity }) {
  const note = caveatOf(result, quantity);
  if (note === null) return null;
  return (
    <abbr className="caveat" title={note} data-testid={`caveat-${result.rung}-${quantity.name}`}>
      <Icon name="info" size={11} />
      <span className="visually-hidden">{note}</span>
    </abbr>
  );
}

/** Past the end of its path the last state found stands, and the heading says so. */
function FeHead({ fe, control, place }: { fe: ShownFe; control: Control; place: number }) {
  const shown = within(fe.result, place, control);
  const ended = Math.abs(place - shown) > 0.002 * Math.abs(place);
  const end = fe.result.outcome === "limit_point" ? "limit point at the end" : "end";
  return (
    <th
      scope="col"
      className={fe.matches ? "series-fe" : "series-fe faded"}
      title={ended ? `Its numbers at ${placeInWords(shown, control)}, the ${end} of its path` : undefined}
    >
      {ended ? `FE at ${placeInWords(shown, control)}` : "FE"}
    </th>
  );
}

function FeCell(props: { fe: ShownFe; quantity: Quantity; place: number; control: Control }) {
  const { fe, quantity, place, control } = props;
  return (
    <td
      data-testid={`number-fe-${quantity.name}`}
      className={fe.matches ? "" : "faded"}
      title={knows(fe.result, quantity) ? undefined : "not computed by 3D FE"}
    >
      {shown(valueAt(fe.result, place, quantity.value, control), quantity, uncertainty(fe.result, quantity, place, control))}
      {knows(fe.result, quantity) && <Caveat result={fe.result} quantity={quantity} />}
    </td>
  );
}

function EstimateCell(props: { result: Result; quantity: Quantity; place: number; control: Control; testId: string }) {
  const { result, quantity, place, control } = props;
  const off = uncertainty(result, quantity, place, control);
  const title = off === null ? undefined : `${formatPercent(off.percent)} of ${off.of}`;
  return (
    <td className="estimate" data-testid={props.testId} title={title}>
      {off === null ? "" : formatUncertainty(off.size)}
    </td>
  );
}

/** The pressure's maximum, where the path met one. `before`: columns of the instant answer; `estimate` [%] is undefined
 * without that column. */
function LimitRow(props: { fe: ShownFe; before: number; estimate: number | null | undefined }) {
  const limit = props.fe.result.limit_pressure_kPa;
  if (limit === null) return null;
  const off = typeof props.estimate === "number" ? (limit * props.estimate) / 100 : null;
  return (
    <tr className="limit" title={`There is no equilibrium above ${kPa(limit)}: beyond it the actuator grows by itself.`}>
      <th scope="row">Limit pressure</th>
      {props.before > 0 && <td>—</td>}
      {props.before > 1 && <td />}
      <td data-testid="number-fe-limit_pressure">{formatQuantity(limit, 4, off === null ? 0 : decimalsOf(off))}</td>
      {props.estimate !== undefined && (
        <td className="estimate" title={props.estimate === null ? undefined : formatPercent(props.estimate)}>
          {off === null ? "" : formatUncertainty(off)}
        </td>
      )}
      <td className="unit">kPa</td>
    </tr>
  );
}

/** A body that moves by millimetres lies still where a model leaves a tenth of a micrometre. */
const STILL = 5e-4;
const OF_THE_SHAPE = ["mm", "°", "1/m"];

/** With at least the decimals of the ± beside it. */
function shown(value: number | null, { unit }: Quantity, off: Uncertainty | null = null): string {
  const still = value !== null && Math.abs(value) < STILL && OF_THE_SHAPE.includes(unit);
  return formatQuantity(still ? 0 : value, 4, off === null ? 0 : decimalsOf(off.size));
}
