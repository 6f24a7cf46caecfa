/** Curves and markers on a plot's canvas. */
import type uPlot from "uplot";

import { token } from "../theme/theme";
import { pointAt, splitAtTrust, type Curve, type CurvePoint } from "./curve";

/** Of a curve beyond the pressures its model is meant for. */
export const PALE = 0.5;

type Place = (point: { x: number; y: number }) => [number, number];

function placer(u: uPlot): Place {
  return (point) => [u.valToPos(point.x, "x", true), u.valToPos(point.y, "y", true)];
}

function clipped(u: uPlot, draw: (context: CanvasRenderingContext2D, ratio: number) => void): void {
  const { ctx, bbox } = u;
  const ratio = window.devicePixelRatio;
  const slack = 5 * ratio;
  ctx.save();
  ctx.beginPath();
  ctx.rect(bbox.left - slack, bbox.top - slack, bbox.width + 2 * slack, bbox.height + 2 * slack);
  ctx.clip();
  draw(ctx, ratio);
  ctx.restore();
}

function strokeLine(ctx: CanvasRenderingContext2D, points: readonly CurvePoint[], place: Place): void {
  ctx.beginPath();
  points.forEach((point, index) => {
    const [x, y] = place(point);
    if (index === 0) ctx.moveTo(x, y);
    else ctx.lineTo(x, y);
  });
  ctx.stroke();
}

function dot(ctx: CanvasRenderingContext2D, [x, y]: [number, number], radius: number): void {
  ctx.beginPath();
  ctx.arc(x, y, radius, 0, 2 * Math.PI);
}

export function drawCurves(u: uPlot, curves: readonly Curve[]): void {
  const place = placer(u);
  clipped(u, (ctx, ratio) => {
    ctx.lineJoin = "round";
    for (const curve of curves) {
      const color = token(curve.color);
      ctx.globalAlpha = curve.faded ? 0.45 : 1;
      ctx.strokeStyle = color;
      ctx.lineWidth = (curve.style === "dots" ? 1.2 : 2) * ratio;
      ctx.setLineDash(curve.style === "dashed" ? [6 * ratio, 4 * ratio] : []);
      const { within, beyond } = splitAtTrust(curve);
      strokeLine(ctx, within, place);
      if (beyond.length > 1) {
        ctx.globalAlpha *= PALE;
        ctx.lineWidth = 1.6 * ratio;
        ctx.setLineDash([3 * ratio, 4 * ratio]);
        strokeLine(ctx, beyond, place);
      }
      ctx.setLineDash([]);
      if (curve.style !== "dots") continue;
      ctx.fillStyle = token("--panel");
      ctx.lineWidth = 1.6 * ratio;
      for (const point of curve.points) {
        dot(ctx, place(point), 2.8 * ratio);
        ctx.fill();
        ctx.stroke();
      }
    }
    ctx.globalAlpha = 1;
  });
}

/** Where the actuator is held, at the origin of a trajectory. */
export function drawClamp(u: uPlot): void {
  clipped(u, (ctx, ratio) => {
    const x = u.valToPos(0, "x", true);
    const y = u.valToPos(0, "y", true);
    ctx.strokeStyle = token("--muted");
    ctx.lineWidth = 2 * ratio;
    ctx.beginPath();
    ctx.moveTo(x, y - 7 * ratio);
    ctx.lineTo(x, y + 7 * ratio);
    ctx.stroke();
    ctx.lineWidth = ratio;
    ctx.beginPath();
    for (let offset = -7; offset <= 3; offset += 3.5) {
      ctx.moveTo(x, y + offset * ratio);
      ctx.lineTo(x - 4 * ratio, y + (offset + 4) * ratio);
    }
    ctx.stroke();
  });
}

/** A value that a curve cannot pass, across the whole plot. */
export interface Rule {
  axis: "x" | "y";
  value: number;
  label: string;
  /** Where the label has no room. */
  short: string;
  /** Name of the colour's design token. */
  color: string;
}

export function drawRules(u: uPlot, rules: readonly Rule[]): void {
  clipped(u, (ctx, ratio) => {
    const { left, top, width, height } = u.bbox;
    for (const rule of rules) {
      const place = u.valToPos(rule.value, rule.axis, true);
      ctx.strokeStyle = ctx.fillStyle = token(rule.color);
      ctx.lineWidth = 1.2 * ratio;
      ctx.setLineDash([7 * ratio, 3 * ratio]);
      ctx.beginPath();
      if (rule.axis === "x") {
        ctx.moveTo(place, top);
        ctx.lineTo(place, top + height);
      } else {
        ctx.moveTo(left, place);
        ctx.lineTo(left + width, place);
      }
      ctx.stroke();
      ctx.setLineDash([]);
      ctx.font = `${10.5 * ratio}px ${token("--font")}`;
      ctx.textBaseline = "bottom";
      const room = left + width - place;
      const text = rule.axis === "x" && Math.max(room, place - left) < ctx.measureText(rule.label).width + 8 * ratio ? rule.short : rule.label;
      const fits = rule.axis === "x" && room > ctx.measureText(text).width + 8 * ratio;
      ctx.textAlign = fits ? "left" : "right";
      const x = rule.axis === "y" ? left + width - 4 * ratio : place + (fits ? 4 : -4) * ratio;
      const y = (rule.axis === "y" ? place : top + height) - 3 * ratio;
      // What the words stand on must not cross them.
      ctx.strokeStyle = token("--panel");
      ctx.lineWidth = 4 * ratio;
      ctx.strokeText(text, x, y);
      ctx.fillText(text, x, y);
    }
  });
}

/** The marked place: a point on every curve, and a line where it is the x axis. */
export function drawMarker(u: uPlot, curves: readonly Curve[], at: number, upright: boolean): void {
  const place = placer(u);
  clipped(u, (ctx, ratio) => {
    if (upright) {
      const x = u.valToPos(at, "x", true);
      ctx.strokeStyle = token("--muted");
      ctx.lineWidth = ratio;
      ctx.setLineDash([3 * ratio, 3 * ratio]);
      ctx.beginPath();
      ctx.moveTo(x, u.bbox.top);
      ctx.lineTo(x, u.bbox.top + u.bbox.height);
      ctx.stroke();
      ctx.setLineDash([]);
    }
    for (const curve of curves) {
      const point = pointAt(curve.points, at);
      if (!point) continue;
      ctx.fillStyle = token(curve.color);
      ctx.strokeStyle = token("--panel");
      ctx.lineWidth = 2 * ratio;
      dot(ctx, place(point), 4.5 * ratio);
      ctx.fill();
      ctx.stroke();
    }
  });
}
