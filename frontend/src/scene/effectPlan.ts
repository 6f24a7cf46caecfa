/** Which effects a 3D solve of the bench would have: asked when the hand rests. */
import { api, ApiProblem, take } from "../api/client";
import { Lane } from "../api/lane";
import { reconnections } from "../api/live";
import { Store } from "../api/store";
import type { EffectDecision, EffectPlan } from "../api/types";
import { accuracy } from "../jobs/accuracy";
import type { Work } from "../workbench/document";
import { sceneOf } from "../workbench/loads";
import { followAtRest } from "../workbench/rest";

export interface PlanState {
  readonly plan: EffectPlan | null;
  readonly asking: boolean;
  /** Whether the last question was refused; the refusal stands at its own field. */
  readonly refused: boolean;
}

export const effectPlan = new Store<PlanState>({ plan: null, asking: true, refused: false });

const plans = new Lane<Work, EffectPlan>(
  ({ design, loads }) =>
    take(api.POST("/api/effects", { body: { design, scene: sceneOf(loads, "auto"), accuracy: Number(accuracy.get()) } })),
  (_, plan) => effectPlan.set({ plan, asking: false, refused: false }),
  (_, error) => effectPlan.update((now) => ({ ...now, asking: false, refused: error instanceof ApiProblem })),
);

const REST_MS = 250;

/** Start following the bench; called once. */
export function followForEffects(): void {
  const again = followAtRest({
    afterMs: REST_MS,
    onMove: () => effectPlan.update((now) => ({ ...now, asking: true })),
    onRest: (work) => plans.ask(work),
    onRefused: () => effectPlan.update((now) => ({ ...now, asking: false, refused: true })),
  });
  accuracy.subscribe(again);
  reconnections.subscribe(again);
}

/** Whether there is anything in this question to have or to leave out. */
export function isThere(effect: EffectDecision): boolean {
  return effect.on || effect.watched || effect.forced !== "auto" || effect.cost_factor !== null;
}

const NAMES: Readonly<Record<string, string>> = {
  gravity: "Gravity",
  finite_strain: "Finite strain",
  hyperelasticity: "Curved law",
  self_contact: "Self-contact",
  plate_contact: "Plate",
  cylinder_contact: "Cylinder",
  outside_pressure: "Outside pressure",
  inextensible_layer: "Stiff layer",
  tip_force: "Tip force",
  volume_control: "Volume control",
  symmetry: "Symmetry",
};

export function effectName(name: string): string {
  return NAMES[name] ?? name.replaceAll("_", " ");
}
