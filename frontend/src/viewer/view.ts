/** The room of the 3D view: opened once, fed with content and frames, reopened when it is gone. */
import { api, ApiProblem, messageOf, take } from "../api/client";
import { Lane } from "../api/lane";
import { reconnections } from "../api/live";
import { Store } from "../api/store";
import type { ContentRequest } from "../api/types";
import { dragging } from "../ui/dragging";
import type { Control } from "../workbench/loads";
import { frameIndex, scrubber, setFrames } from "../workbench/scrubber";
import { bench } from "../workbench/workbench";

function putContent({ viewId, body }: Placed<ContentRequest>) {
  return take(api.PUT("/api/views/{view_id}/content", { params: { path: { view_id: viewId } }, body }));
}

export type ViewContent = Awaited<ReturnType<typeof putContent>>;

export interface ViewState {
  readonly phase: "opening" | "ready" | "failed";
  readonly viewId: string | null;
  readonly url: string | null;
  /** Counts rooms opened, so that the frame is loaded anew. */
  readonly room: number;
  readonly content: ViewContent | null;
  /** Name of the bodies that are in view: those of `content` as soon as the room's page has loaded them. */
  readonly shown: string | null;
  readonly problem: string | null;
  /** True while content that was asked for has not arrived. */
  readonly busy: boolean;
}

export const view = new Store<ViewState>({
  phase: "opening",
  viewId: null,
  url: null,
  room: 0,
  content: null,
  shown: null,
  problem: null,
  busy: false,
});

/** Whether other bodies are in view than those that were asked for last. */
export function isBehind({ busy, content, shown }: Pick<ViewState, "busy" | "content" | "shown">): boolean {
  return busy || (content !== null && content.take !== shown);
}

window.addEventListener("message", ({ origin, data }: MessageEvent<unknown>) => {
  if (origin !== window.location.origin || typeof data !== "object" || data === null) return;
  if ("shown" in data && typeof data.shown === "string") patch({ shown: data.shown });
});

/** Places of the frames by what is in control on the bench, where the content knows them so. */
function framesOf(content: ViewContent): [number[], Control] {
  const { volumes_ml: volumes } = content;
  const known = volumes.filter((volume) => volume !== null);
  const control = bench.get()?.present.work.loads.control;
  return control === "volume" && known.length === volumes.length ? [known, "volume"] : [content.pressures_kPa, "pressure"];
}

export type Colour = ContentRequest["colour"];
export type Camera = "three-quarter" | "side" | "top" | "below" | "front";

interface Placed<T> {
  viewId: string;
  body: T;
}

let wanted: ContentRequest | null = null;
let sent: ContentRequest | null = null;
let frame = 0;
let dark = false;
let opening: Promise<void> | null = null;

function patch(change: Partial<ViewState>): void {
  view.update((state) => ({ ...state, ...change }));
}

function onFailure(error: unknown): void {
  if (error instanceof ApiProblem && error.status === 404) {
    // The room was closed while nobody looked, or the studio was started anew.
    patch({ viewId: null });
    void openView();
    return;
  }
  patch({ problem: messageOf(error), busy: false });
}

const contents = new Lane<Placed<ContentRequest>, ViewContent>(
  putContent,
  ({ body }, content) => {
    patch({ content, problem: null, phase: "ready", busy: body !== wanted });
    setFrames(...framesOf(content));
    // Content comes with its last frame; what is looked at may lie before it.
    const index = frameIndex(scrubber.get());
    if (index !== content.frame) showFrame(index);
  },
  (_, error) => onFailure(error),
);

const frames = new Lane<Placed<number>, unknown>(
  ({ viewId, body }) =>
    take(
      api.PUT("/api/views/{view_id}/frame", { params: { path: { view_id: viewId } }, body: { index: body } }),
    ),
  () => undefined,
  (_, error) => onFailure(error),
);

/** While a slider moves, the plots have the machine: the body follows once the hand rests. (The
 * room's page decodes its frames on this page's thread.) */
const REST_MS = 250;
const REST_WHILE_DRAGGING_MS = 1000;
let resting = 0;

export function showContent(content: ContentRequest, when: "now" | "at rest" = "now"): void {
  wanted = content;
  window.clearTimeout(resting);
  patch({ busy: true });
  if (when === "now") send();
  else resting = window.setTimeout(send, dragging.get() ? REST_WHILE_DRAGGING_MS : REST_MS);
}

dragging.subscribe(() => {
  if (!dragging.get() && wanted && wanted !== sent) showContent(wanted, "at rest");
});

function send(): void {
  const { viewId } = view.get();
  if (viewId === null || !wanted) return;
  sent = wanted;
  contents.ask({ viewId, body: wanted });
}

export function showFrame(index: number): void {
  frame = index;
  const { viewId, content } = view.get();
  if (viewId === null || content === null || content.pressures_kPa.length === 0) return;
  frames.ask({ viewId, body: Math.min(index, content.pressures_kPa.length - 1) });
}

export function setDark(next: boolean): void {
  dark = next;
  appear({ dark });
}

export function setCamera(camera: Camera): void {
  appear({ camera });
}

function appear(body: { dark?: boolean; camera?: Camera }): void {
  const { viewId } = view.get();
  if (viewId === null) return;
  take(
    api.PUT("/api/views/{view_id}/appearance", { params: { path: { view_id: viewId } }, body }),
  ).catch(onFailure);
}

async function open(): Promise<void> {
  try {
    const made = await take(api.POST("/api/views", { body: { dark } }));
    view.update((state) => ({
      ...state,
      viewId: made.view_id,
      url: made.url,
      room: state.room + 1,
      shown: null,
      problem: null,
    }));
    if (wanted) showContent(wanted);
    if (frame > 0) showFrame(frame);
  } catch (error) {
    patch({ phase: "failed", problem: messageOf(error), busy: false });
  }
}

export function openView(): Promise<void> {
  opening ??= open().finally(() => {
    opening = null;
  });
  return opening;
}

/** After the studio was away its rooms are gone; asking for content finds out. */
reconnections.subscribe(() => {
  if (view.get().viewId === null) void openView();
  else if (wanted) showContent(wanted);
});

window.addEventListener("pagehide", (event) => {
  const { viewId } = view.get();
  if (viewId === null || event.persisted) return;
  void fetch(`/api/views/${encodeURIComponent(viewId)}`, { method: "DELETE", keepalive: true });
});
