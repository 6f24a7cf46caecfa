/** What loads and surrounds an actuator, in border units, and the scene document that says it. */

export type Triple = readonly [number, number, number];

/** What ends the path: a pressure [kPa] or the cavity's volume [ml]. */
export type Control = "pressure" | "volume";

/** How an effect is chosen: left to the studio, or by hand. */
export type Choice = "auto" | "on" | "off";

/** Effects chosen by hand, by the names of the API; all others are decided by the studio. */
export type Forced = Readonly<Record<string, "on" | "off">>;

/** Rigid plate: `gap` [mm] from the undeformed body, `normal` from the plate to the actuator. */
export interface Plate {
  readonly gap: number;
  readonly normal: Triple;
}

/** Endless rigid bar: `radius` and a point `centre` on its `axis` [mm]. */
export interface Cylinder {
  readonly radius: number;
  readonly centre: Triple;
  readonly axis: Triple;
}

export interface Loads {
  readonly control: Control;
  /** End of the path [kPa]; kept while a volume is in control. */
  readonly pressureTo: number;
  /** End of the path [ml]; null until a volume was first asked for. */
  readonly volumeTo: number | null;
  /** [m/s²] */
  readonly gravity: Triple | null;
  /** On the underside [kPa]. */
  readonly outsidePressure: number | null;
  /** On the free end [N]. */
  readonly tipForce: Triple | null;
  readonly plate: Plate | null;
  readonly cylinder: Cylinder | null;
  readonly forced: Forced;
}

export const STANDARD_GRAVITY: Triple = [0, 0, -9.81];

export const FALLBACK_PRESSURE = 30;
export const FALLBACK_VOLUME = 40;

export function pressureLoads(pressureTo: number): Loads {
  return {
    control: "pressure",
    pressureTo,
    volumeTo: null,
    gravity: STANDARD_GRAVITY,
    outsidePressure: null,
    tipForce: null,
    plate: null,
    cylinder: null,
    forced: {},
  };
}

export interface SceneDocument {
  [key: string]: unknown;
  gravity_m_s2: readonly number[] | null;
}

/** Points on the path of the instant answer, zero included. */
const STEPS = 20;

export function sceneOf(loads: Loads, steps: number | "auto" = STEPS): SceneDocument {
  const { outsidePressure, tipForce, plate, cylinder, forced } = loads;
  return {
    ...(loads.control === "volume"
      ? { volume_ml: { to: loads.volumeTo ?? FALLBACK_VOLUME, steps } }
      : { pressure_kPa: { to: loads.pressureTo, steps } }),
    gravity_m_s2: loads.gravity,
    ...(outsidePressure === null ? {} : { outside_pressure_kPa: outsidePressure }),
    ...(tipForce === null ? {} : { tip_force_N: tipForce }),
    ...(plate === null ? {} : { plate: { gap_mm: plate.gap, normal: plate.normal } }),
    ...(cylinder === null
      ? {}
      : { cylinder: { radius_mm: cylinder.radius, centre_mm: cylinder.centre, axis: cylinder.axis } }),
    ...(Object.keys(forced).length === 0 ? {} : { effects: forced }),
  };
}

type Entry = Readonly<Record<string, unknown>>;

function asEntry(value: unknown): Entry {
  return typeof value === "object" && value !== null ? (value as Entry) : {};
}

function asNumber(value: unknown): number | null {
  return typeof value === "number" ? value : null;
}

function asTriple(value: unknown): Triple | null {
  if (!Array.isArray(value) || value.length !== 3) return null;
  const [x, y, z] = value.map(asNumber);
  return typeof x === "number" && typeof y === "number" && typeof z === "number" ? [x, y, z] : null;
}

/** The loads of a stored scene; what it does not name is at its default. */
export function readLoads(scene: Entry): Loads {
  const volume = asNumber(asEntry(scene.volume_ml).to);
  const pressure = asNumber(asEntry(scene.pressure_kPa).to);
  const plate = asEntry(scene.plate);
  const cylinder = asEntry(scene.cylinder);
  const gap = asNumber(plate.gap_mm);
  const radius = asNumber(cylinder.radius_mm);
  const centre = asTriple(cylinder.centre_mm);
  return {
    control: volume === null ? "pressure" : "volume",
    pressureTo: pressure ?? FALLBACK_PRESSURE,
    volumeTo: volume,
    gravity: scene.gravity_m_s2 === undefined ? STANDARD_GRAVITY : asTriple(scene.gravity_m_s2),
    outsidePressure: asNumber(scene.outside_pressure_kPa),
    tipForce: asTriple(scene.tip_force_N),
    plate: gap === null ? null : { gap, normal: asTriple(plate.normal) ?? [0, 0, 1] },
    cylinder: radius === null || centre === null ? null : { radius, centre, axis: asTriple(cylinder.axis) ?? [0, 1, 0] },
    forced: forcedIn(asEntry(scene.effects)),
  };
}

function forcedIn(effects: Entry): Forced {
  const chosen = Object.entries(effects).filter((entry): entry is [string, "on" | "off"] => entry[1] === "on" || entry[1] === "off");
  return Object.fromEntries(chosen);
}

/** The loads with one effect chosen otherwise. */
export function choosing(forced: Forced, name: string, choice: Choice): Forced {
  const others = Object.entries(forced).filter(([other]) => other !== name);
  return Object.fromEntries(choice === "auto" ? others : [...others, [name, choice]]);
}

/** Whether two loads are one question. A direction is one whatever its length. */
export function sameLoads(a: Loads, b: Loads): boolean {
  return JSON.stringify(canonical(a)) === JSON.stringify(canonical(b));
}

function canonical(loads: Loads): SceneDocument {
  const { plate, cylinder, tipForce, outsidePressure, forced } = loads;
  return sceneOf({
    ...loads,
    forced: Object.fromEntries(Object.entries(forced).sort(([a], [b]) => (a < b ? -1 : 1))),
    outsidePressure: outsidePressure === 0 ? null : outsidePressure,
    tipForce: tipForce?.some((part) => part !== 0) ? tipForce : null,
    plate: plate && { ...plate, normal: direction(plate.normal) },
    cylinder: cylinder && { ...cylinder, axis: direction(cylinder.axis) },
  });
}

function direction([x, y, z]: Triple): Triple {
  const size = Math.hypot(x, y, z) || 1;
  const rounded = (part: number) => Number((part / size).toPrecision(9)) + 0;
  return [rounded(x), rounded(y), rounded(z)];
}

/** Loads without those that only finite elements carry differ in nothing else. */
export function sameButEnd(a: Loads, b: Loads): boolean {
  const end = { control: "pressure", pressureTo: 0, volumeTo: null } as const;
  return sameLoads({ ...a, ...end }, { ...b, ...end });
}

/** Where an obstacle first stands, for a body of this length [mm]. */
export function firstPlate(): Plate {
  return { gap: 5, normal: [0, 0, 1] };
}

export function firstCylinder(length: number): Cylinder {
  const radius = Math.max(2, Math.round(length / 5));
  return { radius, centre: [Math.round(0.6 * length), 0, -(radius + 5)], axis: [0, 1, 0] };
}
