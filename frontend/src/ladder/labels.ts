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
}

export interface Placed {
  x: number;
  y: number;
  anchor: "start" | "middle" | "end";
}

const HEIGHT = 12;
const GAP = 8;

function overlap(a: Box, b: Box): number {
  const across = Math.min(a.x + a.width, b.x + b.width) - Math.max(a.x, b.x);
  const along = Math.min(a.y + a.height, b.y + b.height) - Math.max(a.y, b.y);
  return across > 0 && along > 0 ? across * along : 0;
}

function outside(box: Box, area: Box): number {
  return box.width * box.height - overlap(box, area);
}

/** Right of its point, else left, above, below, at a corner or below that: the first place that is free, else the freest. */
export function placeNames(points: readonly Named[], area: Box): Placed[] {
  const taken: Box[] = points.map(({ x, y }) => ({ x: x - 5, y: y - 5, width: 10, height: 10 }));
  return points.map(({ x, y, width }) => {
    const choices: { placed: Placed; box: Box }[] = [
      { placed: { x: x + GAP, y, anchor: "start" }, box: { x: x + GAP, y: y - HEIGHT / 2, width, height: HEIGHT } },
      { placed: { x: x - GAP, y, anchor: "end" }, box: { x: x - GAP - width, y: y - HEIGHT / 2, width, height: HEIGHT } },
      { placed: { x, y: y - 13, anchor: "middle" }, box: { x: x - width / 2, y: y - 13 - HEIGHT / 2, width, height: HEIGHT } },
      { placed: { x, y: y + 13, anchor: "middle" }, box: { x: x - width / 2, y: y + 13 - HEIGHT / 2, width, height: HEIGHT } },
      ...[[1, 12], [-1, 12], [1, -12], [-1, -12], [1, 20], [-1, 20]].map(([across = 0, along = 0]) => ({
        placed: { x: x + across * GAP, y: y + along, anchor: across > 0 ? ("start" as const) : ("end" as const) },
        box: { x: across > 0 ? x + GAP : x - GAP - width, y: y + along - HEIGHT / 2, width, height: HEIGHT },
      })),
    ];
    const cost = ({ box }: { box: Box }) => taken.reduce((sum, other) => sum + overlap(box, other), 2 * outside(box, area));
    const best = choices.reduce((least, each) => (cost(each) < cost(least) ? each : least));
    taken.push(best.box);
    return best.placed;
  });
}
