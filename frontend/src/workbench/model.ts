/** Which instant model the plots show. */
import { Store } from "../api/store";
import type { Prediction } from "../api/types";

export type InstantRung = "closed-form" | "energy" | "cell-rod";

/** `auto`: energy while the hand moves, cell and rod once it rests; the others by hand. */
export type ModelChoice = "auto" | "energy" | "closed-form";

export const modelChoice = new Store<ModelChoice>("auto");

/** The model that answers while a slider moves. */
export function movingRung(choice: ModelChoice): "closed-form" | "energy" {
  return choice === "closed-form" ? "closed-form" : "energy";
}

const NAMES: Record<string, string> = { "closed-form": "Closed form", energy: "Energy", "cell-rod": "Cell + rod", fe: "3D FE" };

export function modelName(rung: string): string {
  return NAMES[rung] ?? rung;
}

export type TypicalErrors = Prediction["typical_errors"];
