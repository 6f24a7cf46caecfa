import { useQuery } from "@tanstack/react-query";

import { presetDrawing } from "../api/queries";
import type { Drawing, DrawingView, Preset } from "../api/types";
import { toneOf } from "../drawing/tone";

const WIDTH = 72;
const HEIGHT = 30;

/** The view that fills the picture better: a flat body's planform, a tall one's section. */
function tellingView({ views }: Drawing): DrawingView {
  const share = ({ bounds: [left = 0, bottom = 0, right = 1, top = 1] }: DrawingView) => (top - bottom) / (right - left);
  return share(views.section) >= share(views.planform) * 1.15 ? views.section : views.planform;
}

/** A preset's own drawing, small. */
export function PresetPicture({ preset }: { preset: Preset }) {
  const { data: check } = useQuery(presetDrawing(preset));
  if (!check) return <svg className="preset-picture" width={WIDTH} height={HEIGHT} aria-hidden="true" />;
  const view = tellingView(check.drawing);
  const [left = 0, bottom = 0, right = 1, top = 1] = view.bounds;
  return (
    <svg
      className="preset-picture"
      width={WIDTH}
      height={HEIGHT}
      viewBox={`${left} ${-top} ${right - left} ${top - bottom}`}
      aria-hidden="true"
    >
      {view.shapes.map((shape, index) => (
        <path
          key={index}
          className={`region ${shape.kind} ${toneOf(check, shape.region)}`}
          fillRule="evenodd"
          d={shape.rings.map((ring) => `M${ring.map(([x = 0, y = 0]) => `${x.toFixed(2)} ${(-y).toFixed(2)}`).join("L")}Z`).join("")}
        />
      ))}
    </svg>
  );
}
