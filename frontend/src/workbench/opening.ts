/** Bringing designs to the bench and keeping them: presets, versions, saving. */
import { goTo, type Address } from "../app/address";
import { api, take } from "../api/client";
import { keys, presets, queryClient, version } from "../api/queries";
import type { Preset, VersionDetail } from "../api/types";
import { readDesign, type Origin, type Work } from "./document";
import { pressureLoads, readLoads, sceneOf } from "./loads";
import { readSlot, slotOf } from "./slots";
import { isChanged, start, type Snapshot } from "./timeline";
import { bench, lay, moveToVersion, replaceDesign } from "./workbench";

/** What a first visit shows. */
const FIRST_PRESET = "slab-rectangle-low";

function presetWork(preset: Preset): { work: Work; origin: Origin } {
  return {
    work: {
      name: preset.title,
      design: readDesign(preset.design),
      loads: pressureLoads(preset.pressure_to_kPa),
    },
    origin: { kind: "preset", preset: preset.name, title: preset.title },
  };
}

export function versionOrigin(detail: VersionDetail): Origin & { kind: "version" } {
  return {
    kind: "version",
    versionId: detail.id,
    designId: detail.design_id,
    number: detail.number,
    label: detail.label,
  };
}

function versionSnapshot(detail: VersionDetail): Snapshot {
  const work: Work = {
    name: detail.design_name,
    design: readDesign(detail.design),
    loads: readLoads(detail.scene),
  };
  return { work, baseline: work, origin: versionOrigin(detail) };
}

/** Lays on the bench what the address names. Returns true when unsaved changes came back. */
export async function openAddress(to: Address): Promise<boolean> {
  const slot = slotOf(to.versionId);
  const stored = readSlot(slot);
  if (to.versionId !== null) {
    const detail = await queryClient.query(version(to.versionId));
    const fresh = versionSnapshot(detail);
    if (stored && isChanged(stored.present)) {
      // The name and label may have changed elsewhere; the parameters on the bench are ours.
      const present = { ...stored.present, baseline: fresh.baseline, origin: fresh.origin };
      lay(slot, { ...stored, present: { ...present, work: { ...present.work, name: fresh.work.name } } });
      return true;
    }
    lay(slot, stored ? { ...stored, present: fresh } : start(fresh));
    return false;
  }
  if (stored) {
    lay(slot, stored);
    return isChanged(stored.present);
  }
  const list = await queryClient.query(presets);
  const first = list.find((preset) => preset.name === FIRST_PRESET) ?? list[0];
  if (!first) throw new Error("The studio offers no presets.");
  const { work, origin } = presetWork(first);
  lay(slot, start({ work, baseline: work, origin }));
  return false;
}

/** A preset opens in the unsaved slot; what stood there before stays one step of undo away. */
export function openPreset(preset: Preset): void {
  const { work, origin } = presetWork(preset);
  const here = bench.get();
  const inNewSlot = here !== null && here.present.origin.kind === "preset";
  const waiting = inNewSlot ? here : readSlot(slotOf(null));
  if (waiting && !inNewSlot) lay(slotOf(null), waiting);
  if (waiting) replaceDesign(work, origin);
  else lay(slotOf(null), start({ work, baseline: work, origin }));
  if (!inNewSlot) goTo({ versionId: null, compare: null });
}

export function openVersion(versionId: string): void {
  goTo({ versionId, compare: null });
}

async function store(snapshot: Snapshot, note: string): Promise<VersionDetail> {
  const { work, origin } = snapshot;
  const scene = sceneOf(work.loads, "auto");
  if (origin.kind === "preset") {
    const body = { name: work.name, design: work.design, scene, note };
    return (await take(api.POST("/api/designs", { body }))).version;
  }
  return take(
    api.POST("/api/designs/{design_id}/versions", {
      params: { path: { design_id: origin.designId } },
      body: { design: work.design, scene, parent_version_id: origin.versionId, note },
    }),
  );
}

/** Keeps what is on the bench as a version, and puts that version in the address. */
export async function saveVersion(note: string): Promise<VersionDetail> {
  const snapshot = bench.get()?.present;
  if (!snapshot) throw new Error("Nothing is open.");
  const detail = await store(snapshot, note);
  queryClient.setQueryData(keys.version(detail.id), detail);
  void queryClient.invalidateQueries({ queryKey: keys.designs });
  moveToVersion(versionOrigin(detail), { ...snapshot.work, name: detail.design_name });
  goTo({ versionId: detail.id, compare: null });
  return detail;
}

/** The version that holds exactly what is on the bench, saving it first when there is none. */
export async function ensureSaved(note: string): Promise<string> {
  const snapshot = bench.get()?.present;
  if (snapshot?.origin.kind === "version" && !isChanged(snapshot)) return snapshot.origin.versionId;
  return (await saveVersion(note)).id;
}
