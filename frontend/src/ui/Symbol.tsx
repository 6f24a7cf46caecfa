import { symbolParts } from "./symbols";

export function MathSymbol({ symbol }: { symbol: string }) {
  if (!symbol) return null;
  return (
    <span className="symbol">
      {symbolParts(symbol).map((part, index) => (
        <span key={index}>
          {index > 0 && "/"}
          <var>{part.base}</var>
          {part.sub && <sub>{part.sub}</sub>}
        </span>
      ))}
    </span>
  );
}
