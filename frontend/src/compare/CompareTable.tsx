import { useState } from "react";

import type { ComparedSide, Comparison, PathPoint, Result } from "../api/types";
import { valueAt } from "../charts/curve";
import { spelt } from "../history/changes";
import { QUANTITIES } from "../results/quantities";
import { formatQuantity } from "../ui/numbers";
import { commonPressure } from "./commonPressure";

/** Parameters with those that differ first, then the answers at one pressure. */
export function CompareTable({ comparison }: { comparison: Comparison }) {
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
      <Answers comparison={comparison} />
    </div>
  );
}

function Answers({ comparison }: { comparison: Comparison }) {
  const { left, right } = comparison;
  const pressure = commonPressure([left.instant_result, right.instant_result]);
  if (pressure === null) return null;
  const fe = left.fe_result !== null || right.fe_result !== null;
  return (
    <table className="numbers compare">
      <thead>
        <tr>
          <th scope="col">At {formatQuantity(pressure)} kPa</th>
          <th scope="col">Left</th>
          <th scope="col">Right</th>
        </tr>
      </thead>
      <tbody>
        {QUANTITIES.map((quantity) => (
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
  return (
    <td>
      {read(side.instant_result)}
      {fe && <span className="of-fe"> FE {read(side.fe_result)}</span>}
    </td>
  );
}
