/** How the 3D view shows things; kept between visits. */
import { Store } from "../api/store";
import type { Colour } from "./view";

export interface ViewerSettings {
  /** As chosen, or since a job was run: its answer, while it is one to what is on the bench. */
  readonly source: "instant" | "fe" | "newest";
  readonly colour: Colour;
  readonly undeformed: boolean;
}

const KEY = "pneustudio.viewer";
const INITIAL: ViewerSettings = { source: "instant", colour: "displacement", undeformed: true };

function read(): ViewerSettings {
  try {
    const stored = JSON.parse(localStorage.getItem(KEY) ?? "{}") as Partial<ViewerSettings>;
    // The source is not kept: a visit begins with the answer that is always there.
    return { ...INITIAL, ...stored, source: "instant" };
  } catch {
    return INITIAL;
  }
}

export const viewerSettings = new Store<ViewerSettings>(read());

viewerSettings.subscribe(() => localStorage.setItem(KEY, JSON.stringify(viewerSettings.get())));

export function setViewer(change: Partial<ViewerSettings>): void {
  viewerSettings.update((now) => ({ ...now, ...change }));
}

/** Fields on the surface come from finite elements only; the instant answer has displacements. */
export function colourFor(colour: Colour, source: "instant" | "fe"): Colour {
  return source === "instant" && colour !== "none" ? "displacement" : colour;
}
