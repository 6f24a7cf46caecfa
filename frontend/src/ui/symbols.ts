/** Symbols of the source papers, as they come in plain text. */
const GREEK: Record<string, string> = { theta: "θ", phi: "φ", alpha: "α", kappa: "κ", tau: "τ" };

interface Part {
  base: string;
  sub: string;
}

/** "h1" -> h with subscript 1, "w_o" -> w with subscript o, "theta" -> θ, "h2/h1" -> both. */
export function symbolParts(symbol: string): Part[] {
  return symbol.split("/").map((piece) => {
    if (piece in GREEK) return { base: GREEK[piece] ?? piece, sub: "" };
    const match = /^([A-Za-z]+?)_?(\d+|(?<=_)\w+)$/.exec(piece);
    return match ? { base: match[1] ?? piece, sub: match[2] ?? "" } : { base: piece, sub: "" };
  });
}

const DIGITS = "₀₁₂₃₄₅₆₇₈₉";

/** Subscript digits as characters, where no markup is possible (in drawings). */
export function subscript(text: string): string {
  return text.replaceAll(/\d/g, (digit) => DIGITS[Number(digit)] ?? digit);
}
