import { useQuery } from "@tanstack/react-query";

import { families, materials } from "../api/queries";
import { usePick, useStore } from "../api/store";
import type { DesignCheck, Parameter } from "../api/types";
import { attended, attention } from "../parameters/attention";
import { Icon } from "../ui/Icon";
import { Busy } from "../ui/Notice";
import { subscript, symbolParts } from "../ui/symbols";
import { useSize } from "../ui/useSize";
import { answers } from "../workbench/answers";
import { readDesign, spell } from "../workbench/document";
import { capital } from "../ui/numbers";
import { DimensionMark } from "./DimensionMark";
import { namePlate } from "./label";
import { toneOf } from "./tone";
import { clampSpan, layOut, toPixel, type Layout } from "./layout";

/** Section and planform; the dimension in focus or under the pointer is drawn in. */
export function DrawingPanel() {
  const check = usePick(answers, (now) => now.check);
  const refused = usePick(answers, (now) => now.designProblem !== null);
  const name = attended(useStore(attention));
  const { data: list } = useQuery(families);
  const parameter = list
    ?.find((family) => family.family === check?.design.family)
    ?.parameters.find((each) => each.name === name);
  return (
    <section className="drawing-panel" aria-label="Drawing" data-testid="drawing">
      <div className={`drawing-canvas${refused ? " stale" : ""}`}>
        {check ? <DrawingCanvas check={check} parameter={parameter} /> : <Busy label="Drawing" />}
        {refused && check && (
          <span className="stale-mark">
            <Icon name="warning" size={12} /> last design that can be built
          </span>
        )}
      </div>
      <Caption check={check} parameter={parameter} />
    </section>
  );
}

function DrawingCanvas({ check, parameter }: { check: DesignCheck; parameter: Parameter | undefined }) {
  const [ref, size] = useSize();
  const layout = size.width > 0 ? layOut(check.drawing, size.width, size.height) : null;
  return (
    <div className="drawing-space" ref={ref}>
      {layout && (
        <svg width={size.width} height={size.height} role="img" aria-label="Section and planform of the actuator">
          {layout.views.map((placed) => (
            <g key={placed.name}>
              <title>{placed.view.title}</title>
              {placed.view.shapes.map((shape, index) => (
                <path
                  key={index}
                  className={`region ${shape.kind} ${toneOf(check, shape.region)}`}
                  fillRule="evenodd"
                  d={shape.rings
                    .map((ring) => ringPath(ring.map((point) => toPixel(placed, layout.scale, point))))
                    .join("")}
                />
              ))}
              <text className="view-name" x={6} y={placed.top + 11}>
                {placed.name === "section" ? "Section" : "Planform"}
              </text>
            </g>
          ))}
          <Clamp layout={layout} />
          {parameter && <Marks check={check} parameter={parameter} layout={layout} size={size} />}
        </svg>
      )}
    </div>
  );
}

function ringPath(points: readonly (readonly [number, number])[]): string {
  return `M${points.map(([x, y]) => `${x.toFixed(2)} ${y.toFixed(2)}`).join("L")}Z`;
}

/** Hatched edge at X1 = 0, where the actuator is held. */
function Clamp({ layout }: { layout: Layout }) {
  return (
    <g className="clamp">
      {layout.views.map((placed) => {
        const [top, bottom] = clampSpan(placed, layout.scale);
        const x = placed.origin[0];
        const lines: string[] = [];
        for (let y = top; y < bottom; y += 4) lines.push(`M${x - 1} ${y}l-4 4`);
        return (
          <g key={placed.name}>
            <path d={`M${x - 0.7} ${top - 2}V${bottom + 2}`} className="edge" />
            <path d={lines.join("")} />
          </g>
        );
      })}
    </g>
  );
}

function Marks(props: {
  check: DesignCheck;
  parameter: Parameter;
  layout: Layout;
  size: { width: number; height: number };
}) {
  const { check, parameter, layout, size } = props;
  const value = readDesign(check.design)[parameter.border_name];
  const symbol = symbolParts(parameter.symbol)
    .map((part) => part.base + subscript(part.sub))
    .join("/");
  const text = value === undefined ? symbol : `${symbol ? `${symbol} = ` : ""}${spell(parameter, value)}`;
  const plates = layout.views.map((placed) => namePlate(placed.top));
  return (
    <g data-testid="dimension" data-parameter={parameter.name}>
      {check.drawing.dimensions
        .filter((line) => line.parameter === parameter.name)
        .map((line, index) => {
          const placed = layout.views.find((each) => each.name === line.view);
          if (!placed) return null;
          const place = (point: readonly number[]) => toPixel(placed, layout.scale, point);
          return <DimensionMark key={index} line={line} place={place} text={text} bounds={size} plates={plates} />;
        })}
    </g>
  );
}

function Caption({ check, parameter }: { check: DesignCheck | null; parameter: Parameter | undefined }) {
  const { data: catalogue } = useQuery(materials);
  if (parameter) {
    const limits =
      parameter.lower !== null && parameter.upper !== null
        ? `${parameter.lower} to ${spell(parameter, parameter.upper)}.`
        : "";
    const origin = parameter.assumed ? "Assumed: no source gives it." : parameter.source && `Source: ${parameter.source}.`;
    return (
      <p className="drawing-caption" data-testid="parameter-help">
        <strong>{parameter.label}.</strong> {parameter.help} {limits} <span className="muted">{origin}</span>
      </p>
    );
  }
  return (
    <ul className="drawing-caption legend">
      {check?.drawing.regions.map((region) => (
        <li key={region.name}>
          <i className={`swatch ${toneOf(check, region.name)}`} />
          {capital(region.name)}: {catalogue?.find((each) => each.key === region.material)?.name ?? region.material}
        </li>
      ))}
      <li>
        <i className="swatch air" />
        Air
      </li>
    </ul>
  );
}
