import { api, messageOf, take } from "../api/client";
import { keys, queryClient } from "../api/queries";
import type { Origin } from "../workbench/document";
import { bench, setName, setOrigin } from "../workbench/workbench";
import { showToast } from "../ui/toasts";

function refresh(versionId?: string): void {
  void queryClient.invalidateQueries({ queryKey: keys.designs });
  if (versionId) void queryClient.invalidateQueries({ queryKey: keys.version(versionId) });
}

function openOrigin(): (Origin & { kind: "version" }) | null {
  const origin = bench.get()?.present.origin;
  return origin?.kind === "version" ? origin : null;
}

/** A new name for a kept design; the bench follows when it is the one that is open. */
export async function renameDesign(designId: string, name: string): Promise<void> {
  const here = openOrigin()?.designId === designId;
  const before = bench.get()?.present.work.name;
  if (here) setName(name);
  try {
    await take(api.PATCH("/api/designs/{design_id}", { params: { path: { design_id: designId } }, body: { name } }));
    refresh(openOrigin()?.versionId);
  } catch (error) {
    if (here && before !== undefined) setName(before);
    showToast({ tone: "bad", text: messageOf(error) });
  }
}

/** A label for a version ("sent to the cutter"); empty takes it away. */
export async function labelVersion(versionId: string, text: string): Promise<void> {
  const label = text.trim() === "" ? null : text.trim();
  try {
    await take(api.PATCH("/api/versions/{version_id}", { params: { path: { version_id: versionId } }, body: { label } }));
    const origin = openOrigin();
    if (origin?.versionId === versionId) setOrigin({ ...origin, label });
    refresh(versionId);
  } catch (error) {
    showToast({ tone: "bad", text: messageOf(error) });
  }
}
