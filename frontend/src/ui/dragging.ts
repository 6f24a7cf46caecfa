import { Store } from "../api/store";

/** Whether a slider is being dragged: then the plots come before all else. */
export const dragging = new Store(false);
