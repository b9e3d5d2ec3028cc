/**
 * The service, as functions: one to an endpoint, each answerHandlers with what the service promises.
 *
 * Everything that goes wrong is a `ServiceError` with the service's own words: what, and the hint.
 */

import type { Edges, Toolpath, VerdictColumns } from "../geometry/records";
import { edgesOf, toolpathOf, verdictColumnsOf } from "./columns";
import type { components } from "./openapi.gen";

type Schemas = components["schemas"];
export type Board = Schemas["BoardOut"];
export type CornerAt = Schemas["CornerAt"];
export type Corners = Schemas["Corners"];
export type Drawing = Schemas["DrawingOut"];
export type DrawingSummary = Schemas["DrawingSummary"];
export type Format = Schemas["FormatOut"];
export type Finding = Schemas["FindingOut"];
export type Job = Schemas["JobOut"];
export type JobOrder = Pick<Schemas["JobIn"], "drawing" | "machine" | "board"> & {
  /** Of the drawing that is shown; null where that is not known. */
  revision: number | null;
  copies: number;
  corners: Corners | null;
};
export type JobState = Job["state"];
export type LedgerRow = Schemas["LedgerRow"];
export type Machine = Schemas["MachineOut"];
export type Override = { [K in keyof Schemas["Override"]]?: Schemas["Override"][K] } & {
  type: Schemas["Override"]["type"];
};
export type Problem = Schemas["Problem"];
export type Profile = Schemas["ProfileOut"];
export type ProfileDraft = Schemas["ProfileIn"];
export type Preview = Schemas["PreviewOut"];
export type Proposal = Schemas["ProposalOut"];
export type ReportGroup = Schemas["ReportGroup"];
export type Retyped = Schemas["ChangeOut"];
export type Rule = Schemas["RuleOut"];
export type Question = Schemas["QuestionOut"];
export type Unit = NonNullable<Drawing["unit"]>;
export type Verdict = Schemas["VerdictOut"];
export type VerdictSummary = Schemas["VerdictSummary"];

/** What the operator can ask of a job. */
export type JobCommand =
  | "release"
  | "confirm"
  | "hold"
  | "resume"
  | "cancel"
  | "finish"
  | "requeue"
  | "scrap";

/** The service said no, or did not answer. */
export class ServiceError extends Error {
  override name = "ServiceError";

  constructor(readonly problem: Problem) {
    super(problem.detail || problem.title);
  }

  get hint(): string {
    return this.problem.hint;
  }

  /** The drawing was changed since the request was made for it. */
  get stale(): boolean {
    return this.problem.type === "urn:knifetip:problem:stale-revision";
  }
}

const NO_ANSWER: Problem = {
  type: "about:blank",
  title: "No answer",
  status: 0,
  code: "stored.text",
  arguments: {},
  detail: "knifetip does not answer.",
  text: "knifetip does not answer.",
  hint: "See whether it is still running, then try again.",
  source: [],
  questions: [],
  revision: null,
};

/** No page of another origin can send this header without asking first. */
const OWN = { "X-Knifetip": "page" } as const;

/** How often a request is sent that a busy service refused, and how long (s) it waits at most. */
const TRIES = 6;
const LONGEST_WAIT = 30;

/** Seconds after which to send a request again that was refused unbegun; null for never. */
export function retryAfter(status: number, header: string | null, tried: number): number | null {
  const seconds = Number.parseInt(header ?? "", 10);
  if ((status !== 503 && status !== 429) || Number.isNaN(seconds) || tried >= TRIES) return null;
  // Pages that were refused together do not come back together.
  return Math.min(Math.max(seconds, 1), LONGEST_WAIT) * (1 + Math.random() / 4);
}

const sleep = (seconds: number): Promise<void> =>
  new Promise((resolve) => setTimeout(resolve, seconds * 1000));

/** The session is over: the service answers the page's address with where to sign in. */
const signIn = (): void => globalThis.location?.reload();

/** What an answer that is not a success says, however badly it says it. */
export function parseProblem(status: number, title: string, body: string): Problem {
  const plain: Problem = {
    ...NO_ANSWER,
    status,
    title: title || `Status ${status}`,
    detail: `knifetip answered ${status}${title ? ` ${title}` : ""}.`,
    hint: status >= 500 ? "Try again; if it stays, look into the server's log." : "",
  };
  let said: unknown;
  try {
    said = JSON.parse(body);
  } catch {
    return plain;
  }
  if (typeof said !== "object" || said === null) return plain;
  const known = said as Partial<Problem>;
  return {
    ...plain,
    ...known,
    detail: typeof known.detail === "string" ? known.detail : plain.detail,
    hint: typeof known.hint === "string" ? known.hint : plain.hint,
    source: known.source ?? [],
    questions: known.questions ?? [],
    status,
  };
}

async function request(path: string, init?: RequestInit): Promise<Response> {
  const headers = { ...OWN, ...(init?.headers as Record<string, string> | undefined) };
  for (let tried = 1; ; tried++) {
    let answer: Response;
    try {
      answer = await fetch(path, { ...init, headers });
    } catch (cause) {
      if (cause instanceof DOMException && cause.name === "AbortError") throw cause;
      throw new ServiceError(NO_ANSWER);
    }
    if (answer.ok) return answer;
    const wait = retryAfter(answer.status, answer.headers.get("Retry-After"), tried);
    if (wait === null) {
      if (answer.status === 401) signIn();
      throw new ServiceError(parseProblem(answer.status, answer.statusText, await answer.text()));
    }
    await sleep(wait);
    init?.signal?.throwIfAborted();
  }
}

/** Part of a list, the newest first. */
export interface Page<T> {
  readonly rows: readonly T[];
  /** Where the service has the next part; null where this is the last. */
  readonly next: string | null;
}

/** The address that a Link header gives for the next page; null for none, or for another site's. */
export function nextPageOf(link: string | null): string | null {
  const [, address] = /<([^>]*)>\s*;[^,]*\brel="?next"?/.exec(link ?? "") ?? [];
  return address?.startsWith("/api/") ? address : null;
}

const page = async <T>(path: string, signal?: AbortSignal): Promise<Page<T>> => {
  const answer = await request(path, signal ? { signal } : {});
  return { rows: (await answer.json()) as T[], next: nextPageOf(answer.headers.get("Link")) };
};

/** JSON is not kept by the browser: a newer service may have more to tell of the same revision. */
const get = async <T>(path: string, signal?: AbortSignal): Promise<T> =>
  (await request(path, { cache: "no-store", ...(signal ? { signal } : {}) })).json() as Promise<T>;

const send = async <T>(
  method: string,
  path: string,
  body?: unknown,
  headers: Record<string, string> = {},
): Promise<T> => {
  const answer = await request(path, {
    method,
    ...(body === undefined
      ? { headers }
      : {
          headers: { "Content-Type": "application/json", ...headers },
          body: JSON.stringify(body),
        }),
  });
  return answer.json() as Promise<T>;
};

/** Makes a change apply to this revision only. */
const ifMatch = (revision: number | null): Record<string, string> =>
  revision === null ? {} : { "If-Match": `"${revision}"` };

/** Send a profile as the text or the data that it is; `version` is the one that was looked at. */
const putProfile = async (
  name: string,
  body: string | ProfileDraft,
  version: number | null,
): Promise<Profile> => {
  const text = typeof body === "string";
  const answer = await request(at("profiles", name), {
    method: "PUT",
    headers: {
      "Content-Type": text ? "application/toml" : "application/json",
      ...ifMatch(version),
    },
    body: text ? body : JSON.stringify(body),
  });
  return answer.json() as Promise<Profile>;
};

/** The revision that an ETag names; null for none. */
export function revisionOf(etag: string | null): number | null {
  const [, digits] = /^(?:W\/)?"(\d+)/.exec(etag ?? "") ?? [];
  return digits === undefined ? null : Number.parseInt(digits, 10);
}

/** The edges, and the revision of the drawing that they are of. */
const edges = async (id: string, signal?: AbortSignal): Promise<Edges> => {
  const path = at("drawings", id, "/edges?format=columns");
  const answer = await request(path, signal ? { signal } : {});
  const revision = revisionOf(answer.headers.get("ETag"));
  const read = edgesOf(await answer.arrayBuffer());
  return revision === null ? read : { ...read, revision };
};

const bytes = async (path: string, signal?: AbortSignal): Promise<ArrayBuffer> =>
  (await request(path, signal ? { signal } : {})).arrayBuffer();

const at = (kind: string, id: string, rest = ""): string =>
  `/api/${kind}/${encodeURIComponent(id)}${rest}`;

/** Send a file; `onProgress` hears how much of it (0 … 1) is up. */
async function upload(file: File, onProgress: (fraction: number) => void): Promise<Drawing> {
  for (let tried = 1; ; tried++) {
    const door = await sendFile(file, onProgress);
    if (door.status >= 200 && door.status < 300) return JSON.parse(door.responseText) as Drawing;
    const wait = retryAfter(door.status, door.getResponseHeader("Retry-After"), tried);
    if (wait === null) {
      if (door.status === 401) signIn();
      throw new ServiceError(parseProblem(door.status, door.statusText, door.responseText));
    }
    await sleep(wait);
  }
}

function sendFile(file: File, onProgress: (fraction: number) => void): Promise<XMLHttpRequest> {
  // fetch does not tell how much of a body it has sent; this old door does.
  return new Promise((resolve, reject) => {
    const door = new XMLHttpRequest();
    door.open("POST", "/api/drawings");
    for (const [name, value] of Object.entries(OWN)) door.setRequestHeader(name, value);
    door.upload.onprogress = (event) => {
      if (event.lengthComputable) onProgress(event.loaded / event.total);
    };
    door.onerror = () => reject(new ServiceError(NO_ANSWER));
    door.onload = () => resolve(door);
    const form = new FormData();
    form.append("file", file, file.name);
    door.send(form);
  });
}

/** Where the lists begin. */
export const FIRST = { drawings: "/api/drawings", jobs: "/api/jobs" } as const;

export const service = {
  drawings: (signal?: AbortSignal, from: string = FIRST.drawings) =>
    page<DrawingSummary>(from, signal),
  drawing: (id: string, signal?: AbortSignal) => get<Drawing>(at("drawings", id), signal),
  edges,
  ledger: (id: string, fate: LedgerRow["fate"], signal?: AbortSignal) =>
    get<Schemas["LedgerOut"]>(at("drawings", id, `/ledger?fate=${fate}`), signal),
  upload,
  patchDrawing: (
    id: string,
    change: { unit?: Unit | "file"; profile?: string; rules?: string },
    revision: number | null,
  ) => send<Drawing>("PATCH", at("drawings", id), change, ifMatch(revision)),
  override: (id: string, overrides: readonly Override[], revision: number | null) =>
    send<Drawing>("PATCH", at("drawings", id, "/edges"), { overrides }, ifMatch(revision)),

  jobs: (signal?: AbortSignal, from: string = FIRST.jobs) => page<Job>(from, signal),
  job: (id: string, signal?: AbortSignal) => get<Job>(at("jobs", id), signal),
  compile: (order: JobOrder) => send<Job>("POST", "/api/jobs", order),
  command: (id: string, command: JobCommand) => send<Job>("POST", at("jobs", id, `/${command}`)),
  verdict: (id: string, signal?: AbortSignal) => get<Verdict>(at("jobs", id, "/verdict"), signal),
  verdictColumns: async (id: string, signal?: AbortSignal): Promise<VerdictColumns> =>
    verdictColumnsOf(await bytes(at("jobs", id, "/verdict?format=columns"), signal)),
  toolpath: async (id: string, signal?: AbortSignal): Promise<Toolpath> =>
    toolpathOf(await bytes(at("jobs", id, "/toolpath"), signal)),
  programUrl: (id: string) => at("jobs", id, "/program"),

  machines: (signal?: AbortSignal) => get<Machine[]>("/api/machines", signal),
  formats: (signal?: AbortSignal) => get<Format[]>("/api/formats", signal),
  boards: (signal?: AbortSignal) => get<Board[]>("/api/boards", signal),
  profiles: (signal?: AbortSignal) => get<Profile[]>("/api/profiles", signal),
  profile: (name: string, signal?: AbortSignal) => get<Profile>(at("profiles", name), signal),
  profileText: async (name: string): Promise<string> =>
    (await request(at("profiles", name, ".toml"))).text(),
  profileUrl: (name: string) => at("profiles", name, ".toml"),
  putProfile,
  deleteProfile: async (name: string, version: number): Promise<void> => {
    await request(at("profiles", name), { method: "DELETE", headers: ifMatch(version) });
  },
  preview: (id: string, profile: ProfileDraft) =>
    send<Preview>("POST", at("drawings", id, "/preview"), profile),
  learned: (id: string, signal?: AbortSignal) =>
    request(at("drawings", id, "/learned"), {
      method: "POST",
      ...(signal ? { signal } : {}),
    }).then((answer) => answer.json() as Promise<Proposal[]>),
};
