/** Files of the design on the bench: a saved version's own files, or made from the parameters. */
import { api, messageOf, take } from "../api/client";
import type { FileKind } from "../api/types";
import { showToast } from "../ui/toasts";
import { sceneOf } from "../workbench/loads";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";

/** Files that need nothing but the design and its loads; the others belong to a stored result. */
const MADE = ["mould-svg", "actuator-stl", "inp"] as const;

type Made = (typeof MADE)[number];

function isMade(what: FileKind): what is Made {
  return MADE.some((each) => each === what);
}

function hand(blob: Blob, name: string): void {
  const url = URL.createObjectURL(blob);
  const anchor = document.createElement("a");
  anchor.href = url;
  anchor.download = name;
  anchor.click();
  window.setTimeout(() => URL.revokeObjectURL(url), 30_000);
}

function nameFrom(response: Response, fallback: string): string {
  const header = response.headers.get("content-disposition") ?? "";
  const encoded = /filename\*=(?:utf-8'')?([^;]+)/i.exec(header)?.[1];
  if (encoded) return decodeURIComponent(encoded.trim());
  return /filename="?([^";]+)"?/i.exec(header)?.[1] ?? fallback;
}

function ask(what: FileKind, jobId: string | null) {
  const snapshot = bench.get()?.present;
  if (!snapshot) throw new Error("Nothing is open.");
  const { origin, work } = snapshot;
  if (origin.kind === "version" && !isChanged(snapshot)) {
    const path = { version_id: origin.versionId, what };
    const query = jobId === null ? {} : { job_id: jobId };
    return api.GET("/api/versions/{version_id}/files/{what}", { params: { path, query }, parseAs: "blob" });
  }
  if (!isMade(what)) throw new Error("Save and run 3D FE first.");
  const body = { design: work.design, scene: sceneOf(work.loads, "auto"), what, name: work.name };
  return api.POST("/api/export", { body, parseAs: "blob" });
}

/** `jobId`: whose result is meant, where the file is one of a result; the most accurate where null. */
export async function download(what: FileKind, jobId: string | null): Promise<void> {
  try {
    const pending = ask(what, jobId);
    const blob = await take<Blob>(pending);
    hand(blob, nameFrom((await pending).response, what));
  } catch (error) {
    showToast({ tone: "bad", text: messageOf(error) });
  }
}
