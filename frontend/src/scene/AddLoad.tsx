import { Icon } from "../ui/Icon";
import { Popover } from "../ui/Popover";
import type { Work } from "../workbench/document";
import { firstCylinder, firstPlate, type Loads } from "../workbench/loads";
import { setLoads } from "../workbench/workbench";

interface Addition {
  name: string;
  title: string;
  text: string;
  there: (loads: Loads) => boolean;
  first: (length: number) => Partial<Loads>;
}

const ADDITIONS: readonly Addition[] = [
  {
    name: "plate",
    title: "Rigid plate",
    text: "What the actuator presses against; its force is reported",
    there: (loads) => loads.plate !== null,
    first: () => ({ plate: firstPlate() }),
  },
  {
    name: "cylinder",
    title: "Rigid cylinder",
    text: "A round bar to press against or wrap around",
    there: (loads) => loads.cylinder !== null,
    first: (length) => ({ cylinder: firstCylinder(length) }),
  },
  {
    name: "tip_force",
    title: "Force on the tip",
    text: "Dead load on the free end, a hanging weight at first",
    there: (loads) => loads.tipForce !== null,
    first: () => ({ tipForce: [0, 0, -0.05] }),
  },
  {
    name: "outside_pressure",
    title: "Outside pressure",
    text: "On the underside, normal to it",
    there: (loads) => loads.outsidePressure !== null,
    first: () => ({ outsidePressure: 0.1 }),
  },
];

/** Loads and surroundings that are not there yet, each with sensible first values. */
export function AddLoad({ work }: { work: Work }) {
  const missing = ADDITIONS.filter((each) => !each.there(work.loads));
  const length = Number(work.design.length_mm ?? 100);
  return (
    <Popover
      label="Add a load or surroundings"
      align="end"
      button={(open, toggle) => (
        <button type="button" className="link add-load" aria-expanded={open} disabled={missing.length === 0} onClick={toggle} data-testid="add-load">
          <Icon name="plus" size={12} /> Add load or obstacle
        </button>
      )}
    >
      {(close) => (
        <div className="menu">
          {missing.map((each) => (
            <button
              key={each.name}
              type="button"
              className="menu-item"
              data-testid={`add-${each.name}`}
              onClick={() => {
                setLoads(each.name, each.first(length));
                close();
              }}
            >
              <span className="menu-title">{each.title}</span>
              <span className="muted">{each.text}</span>
            </button>
          ))}
        </div>
      )}
    </Popover>
  );
}
