import { useState } from "react";

import type { ComparedSide, Comparison, PathPoint, Result } from "../api/types";
import { valueAt } from "../charts/curve";
import { spelt } from "../history/changes";
import { QUANTITIES, type Quantity } from "../results/quantities";
import { beyondInWords } from "../results/words";
import { Icon } from "../ui/Icon";
import { NumberField } from "../ui/NumberField";
import { formatQuantity } from "../ui/numbers";
import { Slider } from "../ui/Slider";

interface AtPressure {
  /** Pressure compared at [kPa]; null where there is no answer. */
  pressure: number | null;
  /** The highest one that any answer reaches [kPa]. */
  top: number | null;
  onChoose: (pressure: number) => void;
}

/** Parameters with those that differ first, then the answers at one pressure. */
export function CompareTable({ comparison, ...at }: AtPressure & { comparison: Comparison }) {
  const [all, setAll] = useState(false);
  const differing = comparison.parameters.filter((each) => each.differs);
  const alike = comparison.parameters.filter((each) => !each.differs);
  const shown = all ? [...differing, ...alike] : differing;
  return (
    <div className="compare-tables">
      <table className="numbers compare" data-testid="compare-parameters">
        <thead>
          <tr>
            <th scope="col">Parameter</th>
            <th scope="col">Left</th>
            <th scope="col">Right</th>
          </tr>
        </thead>
        <tbody>
          {shown.map((each) => (
            <tr key={each.name} className={each.differs ? "differs" : ""}>
              <th scope="row">{each.label}</th>
              <td>{spelt(each.left, each.unit)}</td>
              <td>{spelt(each.right, each.unit)}</td>
            </tr>
          ))}
          {shown.length === 0 && (
            <tr>
              <td colSpan={3} className="muted">
                All parameters are alike.
              </td>
            </tr>
          )}
        </tbody>
      </table>
      {alike.length > 0 && (
        <button type="button" className="link" onClick={() => setAll(!all)}>
          {all ? "Only what differs" : `Show ${alike.length} alike`}
        </button>
      )}
      <Answers comparison={comparison} {...at} />
    </div>
  );
}

function Answers({ comparison, pressure, top, onChoose }: AtPressure & { comparison: Comparison }) {
  const { left, right } = comparison;
  if (pressure === null || top === null) return null;
  const fe = left.fe_result !== null || right.fe_result !== null;
  const results = [left.instant_result, right.instant_result, left.fe_result, right.fe_result];
  const listed = QUANTITIES.filter(
    (quantity) => !quantity.rare || results.some((result) => result?.path.some((point) => typeof quantity.value(point) === "number")),
  );
  return (
    <>
      <div className="compare-pressure">
        <span>Answers at</span>
        <Slider value={pressure} min={0} max={top} step={top / 200} label="Pressure compared" onInput={onChoose} testId="compare-slider" />
        <NumberField value={Number(pressure.toPrecision(4))} step={1} unit="kPa" label="Pressure compared" onCommit={onChoose} testId="compare-pressure" />
      </div>
      <AnswersTable comparison={comparison} pressure={pressure} fe={fe} listed={listed} />
    </>
  );
}

function AnswersTable(props: { comparison: Comparison; pressure: number; fe: boolean; listed: readonly Quantity[] }) {
  const { pressure, fe, listed } = props;
  const { left, right } = props.comparison;
  return (
    <table className="numbers compare">
      <thead>
        <tr>
          <th scope="col">Quantity</th>
          <th scope="col">Left</th>
          <th scope="col">Right</th>
        </tr>
      </thead>
      <tbody>
        {listed.map((quantity) => (
          <tr key={quantity.name} title={quantity.help}>
            <th scope="row">
              {quantity.label} <span className="muted">{quantity.unit}</span>
            </th>
            <Cell side={left} pressure={pressure} quantity={quantity.value} fe={fe} />
            <Cell side={right} pressure={pressure} quantity={quantity.value} fe={fe} />
          </tr>
        ))}
      </tbody>
    </table>
  );
}

interface CellProps {
  side: ComparedSide;
  pressure: number;
  quantity: (point: PathPoint) => number | null | undefined;
  fe: boolean;
}

function Cell({ side, pressure, quantity, fe }: CellProps) {
  const read = (result: Result | null) => (result ? formatQuantity(valueAt(result, pressure, quantity), 4) : "—");
  const instant = side.instant_result;
  const beyond = instant ? beyondInWords(instant, pressure, "pressure") : undefined;
  return (
    <td>
      <span className={beyond === undefined ? "" : "faded beyond"} title={beyond}>
        {beyond !== undefined && <Icon name="warning" size={11} />} {read(instant)}
      </span>
      {fe && <span className="of-fe"> FE {read(side.fe_result)}</span>}
    </td>
  );
}
