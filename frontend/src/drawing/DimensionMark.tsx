import type { DimensionLine } from "../api/types";
import type { Pixel } from "./layout";
import { placeLabel, type NamePlate } from "./label";

const HEAD = 6;
/** Below this length [px] the arrows stand outside and point inwards. */
const SHORT = 22;

interface DimensionMarkProps {
  line: DimensionLine;
  place: (point: readonly number[]) => Pixel;
  text: string;
  /** Where the text must stay [px]. */
  bounds: { width: number; height: number };
  plates: readonly NamePlate[];
}

/** A dimension line with arrowheads, witness lines and its value. */
export function DimensionMark({ line, place, text, bounds, plates }: DimensionMarkProps) {
  const from = place(line.from);
  const to = place(line.to);
  const centre = line.centre ? place(line.centre) : null;
  const anchor = line.anchors[0];
  const label = placeLabel(from, to, text, bounds, anchor ? place(anchor) : null, plates);
  return (
    <g className="dimension" data-kind={line.kind}>
      {line.kind !== "angle" && <Witness line={line} place={place} from={from} to={to} />}
      {line.kind === "distance" && <Distance from={from} to={to} />}
      {line.kind === "radius" && <Radius from={from} to={to} />}
      {line.kind === "angle" && centre && <Angle centre={centre} from={from} to={to} />}
      <rect x={label.x - label.width / 2} y={label.y - 8.5} width={label.width} height={17} rx={3} />
      <text x={label.x} y={label.y + 0.5} textAnchor="middle" dominantBaseline="central">
        {text}
      </text>
    </g>
  );
}

type Ends = { from: Pixel; to: Pixel };

function direction(from: Pixel, to: Pixel): { along: Pixel; length: number } {
  const length = Math.hypot(to[0] - from[0], to[1] - from[1]);
  return { along: length > 0 ? [(to[0] - from[0]) / length, (to[1] - from[1]) / length] : [1, 0], length };
}

function Distance({ from, to }: Ends) {
  const { along, length } = direction(from, to);
  const outside = length < SHORT;
  const reach = outside ? 13 : 0;
  return (
    <>
      <line
        x1={from[0] - along[0] * reach}
        y1={from[1] - along[1] * reach}
        x2={to[0] + along[0] * reach}
        y2={to[1] + along[1] * reach}
      />
      <path d={arrow(from, along, outside ? 1 : -1)} />
      <path d={arrow(to, along, outside ? -1 : 1)} />
    </>
  );
}

function Radius({ from, to }: Ends) {
  const { along } = direction(from, to);
  return (
    <>
      <line x1={from[0]} y1={from[1]} x2={to[0]} y2={to[1]} />
      <path d={arrow(to, along, 1)} />
    </>
  );
}

function Angle({ centre, from, to }: Ends & { centre: Pixel }) {
  const radius = Math.hypot(from[0] - centre[0], from[1] - centre[1]);
  const { along: arm } = direction(centre, to);
  // At its end the arc runs across its arm, in the sense in which the angle turns.
  const turning: Pixel = [arm[1], -arm[0]];
  const far = 1.7;
  return (
    <>
      <line className="witness" x1={centre[0]} y1={centre[1]} x2={centre[0] + (from[0] - centre[0]) * far} y2={centre[1] + (from[1] - centre[1]) * far} />
      <line className="witness" x1={centre[0]} y1={centre[1]} x2={centre[0] + (to[0] - centre[0]) * far} y2={centre[1] + (to[1] - centre[1]) * far} />
      <path className="arc" d={`M${from[0]} ${from[1]}A${radius} ${radius} 0 0 0 ${to[0]} ${to[1]}`} />
      <path d={arrow(to, turning, 1)} />
    </>
  );
}

/** From the points on the body to the arrow tips. */
function Witness({ line, place, from, to }: Ends & { line: DimensionLine; place: DimensionMarkProps["place"] }) {
  return line.anchors.map((anchor, index) => {
    const tip = index === 0 && line.kind === "distance" ? from : to;
    const [x, y] = place(anchor);
    return <line key={index} className="witness" x1={x} y1={y} x2={tip[0]} y2={tip[1]} />;
  });
}

function arrow(tip: Pixel, along: Pixel, sense: number): string {
  const back: Pixel = [tip[0] - along[0] * HEAD * sense, tip[1] - along[1] * HEAD * sense];
  const side: Pixel = [-along[1] * HEAD * 0.4, along[0] * HEAD * 0.4];
  return `M${tip[0]} ${tip[1]}L${back[0] + side[0]} ${back[1] + side[1]}L${back[0] - side[0]} ${back[1] - side[1]}Z`;
}
