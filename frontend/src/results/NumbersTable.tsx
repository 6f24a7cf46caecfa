import type { Result } from "../api/types";
import { valueAt } from "../charts/curve";
import { lastPressure } from "./lastPressure";
import { kPa } from "./words";
import { formatQuantity } from "../ui/numbers";
import { QUANTITIES, type Quantity } from "./quantities";
import type { ShownFe } from "./shown";

interface NumbersTableProps {
  result: Result;
  fe: ShownFe | null;
  pressure: number | null;
}

function knows(result: Result, quantity: Quantity): boolean {
  return result.path.some((point) => typeof quantity.value(point) === "number");
}

/** Every quantity at the scrubber's pressure. */
export function NumbersTable({ result, fe, pressure }: NumbersTableProps) {
  const at = pressure ?? result.path.at(-1)?.pressure_kPa ?? 0;
  const end = fe ? lastPressure(fe.result) : null;
  // Past the end of its path the last state found stands, and the heading says so.
  const feAt = end !== null && at > end ? end : at;
  const ended = at - feAt > 0.002 * at;
  return (
    <table className="numbers" data-testid="numbers">
      <thead>
        <tr>
          <th scope="col">Quantity</th>
          <th scope="col" className="series-instant">
            Instant
          </th>
          {fe && (
            <th scope="col" className={fe.matches ? "series-fe" : "series-fe faded"}>
              {ended ? `FE at ${kPa(feAt)}, its ${fe.result.outcome === "limit_point" ? "limit" : "end"}` : "FE"}
            </th>
          )}
          <th scope="col">Unit</th>
        </tr>
      </thead>
      <tbody>
        {QUANTITIES.map((quantity) => (
          <tr key={quantity.name} title={quantity.help}>
            <th scope="row">
              {quantity.label} {quantity.symbol && <var className="symbol">{quantity.symbol}</var>}
            </th>
            <td data-testid={`number-${quantity.name}`}>{formatQuantity(valueAt(result, at, quantity.value), 4)}</td>
            {fe && (
              <td
                data-testid={`number-fe-${quantity.name}`}
                className={fe.matches ? "" : "faded"}
                title={knows(fe.result, quantity) ? undefined : "not computed by 3D FE"}
              >
                {formatQuantity(valueAt(fe.result, feAt, quantity.value), 4)}
              </td>
            )}
            <td className="unit">{quantity.unit}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
