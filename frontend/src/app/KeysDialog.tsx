import { Layer } from "../ui/Layer";
import { layer } from "./layers";

const KEYS: readonly [string, string][] = [
  ["Ctrl S", "Save a version"],
  ["Ctrl Z", "Undo"],
  ["Ctrl Shift Z", "Redo"],
  ["Space", "Play or pause the pressure"],
  [", and .", "One pressure step back or forward"],
  ["H", "History"],
  ["Arrows in a number field", "One step; with Shift ten steps"],
  ["?", "This list"],
];

export function KeysDialog() {
  return (
    <Layer title="Keyboard" kind="dialog" onClose={() => layer.set("none")}>
      <dl className="keys">
        {KEYS.map(([key, meaning]) => (
          <div key={key}>
            <dt>{key}</dt>
            <dd>{meaning}</dd>
          </div>
        ))}
      </dl>
    </Layer>
  );
}
