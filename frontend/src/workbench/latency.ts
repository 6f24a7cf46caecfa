/** Time from an input to the plotted answer, as User Timing entries a test can read:
 * mark "pneu:input", measure "pneu:input-to-plot". */

let inputs = 0;
let plotted = 0;

const MARK = "pneu:input";
const MEASURE = "pneu:input-to-plot";
const KEPT = 400;

export function markInput(): void {
  inputs += 1;
  performance.mark(`${MARK}:${inputs}`);
  if (inputs > KEPT) performance.clearMarks(`${MARK}:${inputs - KEPT}`);
}

/** Number of the latest input; travels with the question it caused. */
export function latestInput(): number {
  return inputs;
}

/** Called once the curve that answers input number `input` has been drawn. */
export function markPlotted(input: number): void {
  if (input <= plotted || input === 0) return;
  plotted = input;
  if (performance.getEntriesByName(`${MARK}:${input}`).length === 0) return;
  performance.measure(MEASURE, { start: `${MARK}:${input}`, end: performance.now() });
  if (input % KEPT === 0) performance.clearMeasures(MEASURE);
}
