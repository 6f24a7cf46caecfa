/** Where the names of points stand, so that no two of them cover each other. */

export interface Box {
  x: number;
  y: number;
  width: number;
  height: number;
}

export interface Named {
  x: number;
  y: number;
  /** Width of the name [px]. */
  width: number;
  /** Of what is drawn around the point [px]. */
  radius: number;
}

export interface Placed {
  x: number;
  y: number;
  anchor: "start" | "middle" | "end";
}

const HEIGHT = 12;
/** Between a point and its name [px]. */
const GAP = 3;
/** Upwards and downwards from the point [px], the nearest first: beyond the second a name needs a line to its point. */
const OFFSETS = [0, 12, 20, 30, 42];
/** A name stands a pixel further off rather than cover so many square pixels more. */
const PER_PIXEL = 0.25;
const ROUNDS = 3;

function overlap(a: Box, b: Box): number {
  const across = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const along = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return across > 0 && along > 0 ? across * along : 0;
}

function outside(box: Box, area: Box): number {
  return box.width * box.height - overlap(box, area);
}

interface Choice {
  placed: Placed;
  box: Box;
  off: number;
}

function choicesOf({ x, y, width, radius }: Named): Choice[] {
  const top = (at: number) => at - HEIGHT / 2;
  return OFFSETS.flatMap((offset) =>
    (offset === 0 ? [0] : [offset, -offset]).flatMap((along): Choice[] => {
      const at = y + along;
      // beside the point's own ring where it is level with it, nearer where it stands above or below
      const gap = Math.abs(along) < radius + HEIGHT / 2 ? radius + GAP : GAP;
      const sides: Choice[] = [
        { placed: { x: x + gap, y: at, anchor: "start" }, box: { x: x + gap, y: top(at), width, height: HEIGHT }, off: offset },
        { placed: { x: x - gap, y: at, anchor: "end" }, box: { x: x - gap - width, y: top(at), width, height: HEIGHT }, off: offset + 1 },
      ];
      const clear = Math.abs(along) >= radius + HEIGHT / 2;
      const middle: Choice = { placed: { x, y: at, anchor: "middle" }, box: { x: x - width / 2, y: top(at), width, height: HEIGHT }, off: offset + 2 };
      return clear ? [...sides, middle] : sides;
    }),
  );
}

/** The nearest place that is free, right of the point if it can be; else the freest. Names make way for each other. */
export function placeNames(points: readonly Named[], area: Box): Placed[] {
  const rings = points.map(({ x, y, radius }) => ({ x: x - radius, y: y - radius, width: 2 * radius, height: 2 * radius }));
  const choices = points.map(choicesOf);
  const chosen: (Choice | undefined)[] = points.map(() => undefined);
  for (let round = 0; round < ROUNDS; round++) {
    choices.forEach((mine, index) => {
      const taken = [...rings, ...chosen.flatMap((other, at) => (other && at !== index ? [other.box] : []))];
      const cost = ({ box, off }: Choice) =>
        taken.reduce((sum, other) => sum + overlap(box, other), 2 * outside(box, area) + PER_PIXEL * off);
      chosen[index] = mine.reduce((least, each) => (cost(each) < cost(least) ? each : least));
    });
  }
  return chosen.map((each, index) => each?.placed ?? { x: points[index]?.x ?? 0, y: points[index]?.y ?? 0, anchor: "start" });
}
