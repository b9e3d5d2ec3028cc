/**
 * Views in the hash of the address, shown by the router.
 *
 *     #/                                   drawings and their orders
 *     #/by/COLUMN, #/by/COLUMN/reversed    the same, sorted by a column
 *     #/state/GROUP/machine/NAME/search/TEXT/by/COLUMN
 *                                          the same, with conditions; each part can be missing
 *     #/drawings/ID                        a drawing, at the first step that needs the user
 *     #/drawings/ID/STEP                   a step of a drawing: lines, sheet, process or check
 *     #/drawings/ID/STEP/jobs/ID           the same, with a job of the drawing
 *     #/drawings/ID/fold                   a drawing folded in 3D
 *     #/layouts/ID/sheet                   the sheet of a layout
 *     #/machines                           machines with their queues
 *     #/machines/NAME                      one of them
 *     #/station/MACHINE                    the page of the person at a machine
 *     #/library                            machines, boards and tools
 *     #/library/SHELF                      one shelf: machines, boards or tools
 *     #/library/SHELF/NAME                 one of them, such as #/library/machines/demo-table
 *     #/cartons                            carton styles
 *     #/cartons/CODE                       one of them, such as #/cartons/fefco-0427
 *     #/history                            ended jobs
 *     #/history/VIEW                       statistics or tools
 *     #/settings                           language, colour scheme, account, webhooks
 *     #/settings/TAB                       the same, with users, keys or the audit log
 *     #/webhooks                           endpoints of other systems
 *
 * The open drawing, step and job are state, because they stay open behind the other views.
 */

import { navigate } from "wouter/use-hash-location";
import { type OpenDrawing, type Step, useUiStore } from "./store";
import { NO_FILTER, type WorkFilter } from "./work/workFilter";
import { NEWEST, type WorkOrder } from "./work/workOrder";

export const WORK = "/";

/** Addresses of the work, with conditions, sorted by the newest drawing or by a column. */
export const WORK_TABLE = new RegExp(
  [
    "^(?:/|(?=/.)",
    "(?:/state/(?<progress>prepare|ready|machine|ended))?",
    "(?:/machine/(?<machine>[^/]+))?",
    "(?:/search/(?<search>[^/]+))?",
    "(?:/by/(?<column>name|customer|due|board|machine|state|time)(?<reversed>/reversed)?)?",
    ")$",
  ].join(""),
);

/** What the table of work shows: its conditions and its order. */
export interface WorkView {
  readonly filter: WorkFilter;
  readonly order: WorkOrder;
}

/** What an address of the work shows; the router's own parts of it are decoded already. */
export function workViewOf(hash: string): WorkView {
  const { progress, machine, search, column, reversed } =
    WORK_TABLE.exec(hash.slice(1))?.groups ?? {};
  return {
    filter: {
      search: decodedPart(search),
      progress: (progress ?? NO_FILTER.progress) as WorkFilter["progress"],
      machine: decodedPart(machine),
    },
    order: {
      sort: (column ?? NEWEST.sort) as WorkOrder["sort"],
      reverse: reversed !== undefined,
    },
  };
}

export function workPath({ filter, order }: WorkView): string {
  const { progress, machine, search } = filter;
  const parts = [
    progress === NO_FILTER.progress ? "" : `/state/${progress}`,
    machine === "" ? "" : `/machine/${encodeURIComponent(machine)}`,
    search === "" ? "" : `/search/${encodeURIComponent(search)}`,
    order.sort === NEWEST.sort ? "" : `/by/${order.sort}${order.reverse ? "/reversed" : ""}`,
  ];
  return parts.join("") || WORK;
}

export const MACHINES = "/machines/:machine?";
export const STATIONS = "/station";
export const STATION = "/station/:machine";
export const LIBRARY = "/library/:shelf?/:name?";
export const CARTONS = "/cartons/:code?";
export const FOLD = "/drawings/:drawing/fold";
/** Addresses of the history; the jobs have no word of their own. */
export const HISTORY = /^\/history(?:\/(?<view>statistics|tools))?$/;
export type HistoryView = "jobs" | "statistics" | "tools";

/** Addresses of the settings; the account of the user has no word of its own. */
export const SETTINGS = /^\/settings(?:\/(?<tab>users|keys|audit))?$/;
export type AccountTab = "own" | "users" | "keys" | "audit";

export const WEBHOOKS = "/webhooks";
export const SHEET = "/layouts/:id/sheet";

/** Addresses of drawings. */
export const DRAWINGS =
  /^\/drawings\/([^/]+)(?:\/(lines|sheet|process|check))?(?:\/jobs\/([^/]+))?$/;

const NOTHING: OpenDrawing = { drawing: null, step: null, job: null };

/** What an address opens; null if it names another view, behind which the drawing stays open. */
export function drawingOf(hash: string): OpenDrawing | null {
  const found = DRAWINGS.exec(hash.slice(1));
  if (found === null) return null;
  const [, drawing, step, job] = found;
  try {
    return { drawing: decoded(drawing), step: (step as Step) ?? null, job: decoded(job) };
  } catch {
    // Invalid percent-encoding in a typed address.
    return NOTHING;
  }
}

const decoded = (part: string | undefined): string | null =>
  part === undefined ? null : decodeURIComponent(part);

/** A part of a path as it was before it was encoded; as it is typed if the encoding is invalid. */
export function decodedPart(part = ""): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return part;
  }
}

/** Path of a drawing with its step and a job of it; that of all drawings without a drawing. */
export function drawingPath({ drawing, step, job }: OpenDrawing): string {
  if (drawing === null) return WORK;
  const steps = step === null ? "" : `/${step}`;
  const jobs = job === null ? "" : `/jobs/${encodeURIComponent(job)}`;
  return `/drawings/${encodeURIComponent(drawing)}${steps}${jobs}`;
}

/** Address of a machine with its queue. */
export const machineAddress = (machine: string): string =>
  `#/machines/${encodeURIComponent(machine)}`;

/** Address of the station page of a machine. */
export const stationAddress = (machine: string): string =>
  `#/station/${encodeURIComponent(machine)}`;

/** Show the open drawing instead of another view. */
export function returnToDrawing(): void {
  const path = drawingPath(useUiStore.getState());
  if (location.hash !== `#${path}`) navigate(path);
}

/** Open a drawing and a job of it and show them, at the first step that needs the user. */
export function showDrawing(
  drawing: string | null,
  job: string | null = null,
  step: Step | null = null,
): void {
  useUiStore.getState().open(drawing, job, step);
  returnToDrawing();
}

export const showHistory = (view: HistoryView): void =>
  navigate(view === "jobs" ? "/history" : `/history/${view}`);

export const showSettings = (tab: AccountTab): void =>
  navigate(tab === "own" ? "/settings" : `/settings/${tab}`);

/**
 * Show the work with other conditions or in another order.
 *
 * This adds an entry to the browser history, except for each further letter of a search.
 */
export function showWork(view: WorkView, before: WorkView): void {
  const typed = view.filter.search !== before.filter.search && before.filter.search !== "";
  navigate(workPath(view), { replace: typed && view.filter.search !== "" });
}

const layoutPath = (id: string): string => `/layouts/${encodeURIComponent(id)}/sheet`;
export const layoutAddress = (id: string): string => `#${layoutPath(id)}`;

/** Show the sheet of a layout. */
export const showLayout = (id: string): void => navigate(layoutPath(id));

/** Open the drawing that the address names. */
export function openAddress(): void {
  const named = drawingOf(location.hash);
  if (named !== null) useUiStore.getState().open(named.drawing, named.job, named.step);
}

/** Whether another drawing, or another step that the user has seen, is open now. */
const isElsewhere = (page: OpenDrawing, before: OpenDrawing): boolean =>
  page.drawing !== before.drawing || (page.step !== before.step && before.step !== null);

/** Keep the address and the open drawing equal until the returned function is called. */
export function syncWithAddress(): () => void {
  openAddress();
  addEventListener("hashchange", openAddress);
  const stop = useUiStore.subscribe((page, before) => {
    const path = drawingPath(page);
    if (path === drawingPath(before) || location.hash === `#${path}`) return;
    if (drawingOf(location.hash) === null) return;
    // A drawing and a step add an entry to the browser history; a job replaces it.
    navigate(path, { replace: !isElsewhere(page, before) });
  });
  return () => {
    stop();
    removeEventListener("hashchange", openAddress);
  };
}
