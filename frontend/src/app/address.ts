/** The address: /, /v/<version>, and ?compare=<left>,<right> over either. */
import { Store } from "../api/store";

export interface Address {
  readonly versionId: string | null;
  readonly compare: readonly [string, string] | null;
}

export function parseAddress(url: URL): Address {
  const match = /^\/v\/([^/]+)\/?$/.exec(url.pathname);
  const pair = url.searchParams.get("compare")?.split(",") ?? [];
  const [left, right] = pair;
  return {
    versionId: match?.[1] ? decodeURIComponent(match[1]) : null,
    compare: left && right ? [left, right] : null,
  };
}

export function formatAddress(address: Address): string {
  const path = address.versionId ? `/v/${encodeURIComponent(address.versionId)}` : "/";
  return address.compare ? `${path}?compare=${address.compare.map(encodeURIComponent).join(",")}` : path;
}

export const address = new Store<Address>(parseAddress(new URL(window.location.href)));

window.addEventListener("popstate", () => address.set(parseAddress(new URL(window.location.href))));

export function goTo(next: Address, how: "push" | "replace" = "push"): void {
  const target = formatAddress(next);
  if (how === "push") window.history.pushState(null, "", target);
  else window.history.replaceState(null, "", target);
  address.set(next);
}
