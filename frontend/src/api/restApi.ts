/**
 * The client of the REST API that all groups of requests share.
 *
 * `openapi-fetch` checks paths, parameters and bodies against the generated types. Every failure
 * is a `ServiceError` with the server's problem.
 */

import createClient from "openapi-fetch";
import type { paths } from "./openapi.gen";
import { fetchOnce, fetchWithRetries, OWN_PAGE } from "./transport";

export const api = createClient<paths>({
  // Request needs an absolute URL; tests have no location.
  baseUrl: globalThis.location?.origin ?? "http://localhost",
  fetch: fetchWithRetries,
  headers: OWN_PAGE,
});

/** JSON is not cached by the browser: a newer server may return more for the same revision. */
export const uncached = (signal?: AbortSignal) =>
  ({ cache: "no-store", signal: signal ?? null }) as const;

/**
 * The browser asks whether its copy is current; if it is, the answer has no body. For what is
 * fetched again and again and whose ETag is a hash of the whole answer.
 */
export const revalidated = (signal?: AbortSignal) =>
  ({ cache: "no-cache", signal: signal ?? null }) as const;

/** Path parameter of a job, a drawing or another object with an id. */
export const byId = (id: string) => ({ path: { id } });

/** A type as `openapi-fetch` infers it: tuples are arrays. */
type Untupled<T> = T extends readonly (infer E)[]
  ? Untupled<E>[]
  : T extends object
    ? { [K in keyof T]: Untupled<T[K]> }
    : T;

/** The data of an answer. The transport has raised an error if the server refused the request. */
export async function dataOf<T>(
  call: Promise<{ data?: NoInfer<Untupled<T>> | undefined }>,
): Promise<T> {
  return (await call).data as T;
}

/** Part of a list, newest first. */
export interface Page<T> {
  readonly rows: readonly T[];
  /** Cursor of the next part; null if this is the last. */
  readonly next: number | null;
}

/** Cursor in the Link header of a list; null if there is no next page. */
export function nextCursor(link: string | null): number | null {
  const [, address = ""] = /<([^>]*)>\s*;[^,]*\brel="?next"?/.exec(link ?? "") ?? [];
  if (!address.startsWith("/api/v1/")) return null;
  const cursor = new URL(address, "http://localhost").searchParams.get("cursor");
  return cursor === null || cursor === "" ? null : Number(cursor);
}

export async function pageOf<T>(
  call: Promise<{ data?: NoInfer<Untupled<T>>[] | undefined; response: Response }>,
): Promise<Page<T>> {
  const { data = [], response } = await call;
  return { rows: data as T[], next: nextCursor(response.headers.get("Link")) };
}

/** Time (s) after which a request of a person at a machine is given up: it must not arrive late. */
const PATIENCE = 3;

/** Options of a request that must arrive now or never. */
export const nowOrNever = () => ({
  fetch: fetchOnce,
  signal: AbortSignal.timeout(PATIENCE * 1000),
});

/** The answer is bytes. */
export const binary = (signal?: AbortSignal) =>
  ({ parseAs: "arrayBuffer", signal: signal ?? null }) as const;

/** Path parameter of a machine, a board or another object with a name. */
export const byName = (name: string) => ({ path: { name } });

/** Header that applies a change to this revision only. */
export const ifMatch = (revision: number | null) => ({
  header: revision === null ? {} : { "If-Match": `"${revision}"` },
});

/** The revision in an ETag; null if there is none. */
export function revisionOf(etag: string | null): number | null {
  const [, digits] = /^(?:W\/)?"(\d+)/.exec(etag ?? "") ?? [];
  return digits === undefined ? null : Number.parseInt(digits, 10);
}
