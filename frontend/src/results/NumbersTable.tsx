import type { Result } from "../api/types";
import { valueAt } from "../charts/curve";
import { formatQuantity } from "../ui/numbers";
import { QUANTITIES } from "./quantities";
import type { ShownFe } from "./shown";

interface NumbersTableProps {
  result: Result;
  fe: ShownFe | null;
  pressure: number | null;
}

/** Every quantity at the scrubber's pressure. */
export function NumbersTable({ result, fe, pressure }: NumbersTableProps) {
  const at = pressure ?? result.path.at(-1)?.pressure_kPa ?? 0;
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
              FE
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
              <td data-testid={`number-fe-${quantity.name}`} className={fe.matches ? "" : "faded"}>
                {formatQuantity(valueAt(fe.result, at, quantity.value), 4)}
              </td>
            )}
            <td className="unit">{quantity.unit}</td>
          </tr>
        ))}
      </tbody>
    </table>
  );
}
