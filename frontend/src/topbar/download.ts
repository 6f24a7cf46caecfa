/** Files of the design on the bench: a saved version's own files, or made from the parameters. */
import { api, messageOf, take } from "../api/client";
import { showToast } from "../ui/toasts";
import { isChanged } from "../workbench/timeline";
import { bench } from "../workbench/workbench";

export type Download = "mould-svg" | "actuator-stl";

function hand(url: string, name: string): void {
  const anchor = document.createElement("a");
  anchor.href = url;
  anchor.download = name;
  anchor.click();
}

function nameFrom(response: Response, fallback: string): string {
  const header = response.headers.get("content-disposition") ?? "";
  const encoded = /filename\*=(?:utf-8'')?([^;]+)/i.exec(header)?.[1];
  if (encoded) return decodeURIComponent(encoded.trim());
  return /filename="?([^";]+)"?/i.exec(header)?.[1] ?? fallback;
}

export async function download(what: Download): Promise<void> {
  const snapshot = bench.get()?.present;
  if (!snapshot) return;
  const { origin, work } = snapshot;
  try {
    if (origin.kind === "version" && !isChanged(snapshot)) {
      const files = await take(
        api.GET("/api/versions/{version_id}/files", { params: { path: { version_id: origin.versionId } } }),
      );
      const file = files.find((each) => each.what === what);
      if (file?.available) hand(file.url, file.file_name);
      else showToast({ tone: "bad", text: file?.reason ?? "This version does not have that file." });
      return;
    }
    const pending = api.POST("/api/export", {
      body: { design: work.design, what, name: work.name },
      parseAs: "blob",
    });
    const blob = await take(pending);
    const { response } = await pending;
    const url = URL.createObjectURL(blob);
    hand(url, nameFrom(response, what));
    window.setTimeout(() => URL.revokeObjectURL(url), 30_000);
  } catch (error) {
    showToast({ tone: "bad", text: messageOf(error) });
  }
}
