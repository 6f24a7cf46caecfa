/** Which layer lies over the studio: one at a time. */
import { Store } from "../api/store";

export type LayerName = "none" | "history" | "save" | "keys";

export const layer = new Store<LayerName>("none");
