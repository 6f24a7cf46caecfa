/** Ranges of plots. */
import type { Curve } from "./curve";
import type { Rule } from "./draw";

export type Range = [number, number];

export function rangeOf(values: readonly number[], withZero: boolean): Range {
  const finite = values.filter(Number.isFinite);
  let low = Math.min(...finite, withZero ? 0 : Infinity);
  let high = Math.max(...finite, withZero ? 0 : -Infinity);
  if (!Number.isFinite(low) || !Number.isFinite(high)) return [0, 1];
  if (high - low < 1e-9) {
    low -= 0.5;
    high += 0.5;
  }
  return [low, high];
}

function padded([low, high]: Range, share: number): Range {
  const pad = (high - low) * share;
  return [low - pad, high + pad];
}

/** `fromZero`: whether the axis to the right begins at 0, as pressures do and volumes do not. */
export function freeRanges(
  curves: readonly Curve[],
  rules: readonly Rule[] = [],
  fromZero = true,
): { x: Range; y: Range } {
  const points = curves.flatMap((curve) => curve.points);
  const ruled = (axis: Rule["axis"]) => rules.filter((rule) => rule.axis === axis).map((rule) => rule.value);
  const x = rangeOf([...points.map((point) => point.x), ...ruled("x")], fromZero);
  const y = rangeOf([...points.map((point) => point.y), ...ruled("y")], true);
  const [low, high] = padded(y, 0.06);
  return { x, y: [y[0] === 0 ? 0 : low, y[1] === 0 ? 0 : high] };
}

/** A path shorter than this [mm] is not blown up. */
const LEAST = 8;

function atLeast([low, high]: Range, span: number): Range {
  const spare = Math.max(0, span - (high - low)) / 2;
  return [low - spare, high + spare];
}

/** Ranges in which a millimetre is as long across as up; the data stand in the middle. */
export function equalRanges(curves: readonly Curve[], width: number, height: number): { x: Range; y: Range } {
  const points = curves.flatMap((curve) => curve.points);
  const x = atLeast(padded(rangeOf(points.map((point) => point.x), false), 0.1), LEAST);
  const y = atLeast(padded(rangeOf(points.map((point) => point.y), false), 0.1), LEAST);
  if (width <= 0 || height <= 0) return { x, y };
  const scale = Math.max((x[1] - x[0]) / width, (y[1] - y[0]) / height);
  return { x: centred(x, scale * width), y: centred(y, scale * height) };
}

function centred([low, high]: Range, span: number): Range {
  const middle = (low + high) / 2;
  return [middle - span / 2, middle + span / 2];
}
