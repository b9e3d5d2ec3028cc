import { afterEach, beforeEach, expect, test, vi } from "vitest";
import {
  drawingOf,
  drawingPath,
  HISTORY,
  returnToDrawing,
  SETTINGS,
  showDrawing,
  showHistory,
  showSettings,
  showWork,
  syncWithAddress,
  WORK_TABLE,
  type WorkView,
  workPath,
  workViewOf,
} from "./routes";
import { type OpenDrawing, useUiStore } from "./store";
import { NO_FILTER } from "./work/workFilter";
import { NEWEST } from "./work/workOrder";

const NOTHING: OpenDrawing = { drawing: null, step: null, job: null };

test.each<[string, Partial<OpenDrawing>]>([
  ["#/drawings/d1", { drawing: "d1" }],
  ["#/drawings/d1/lines", { drawing: "d1", step: "lines" }],
  ["#/drawings/d1/jobs/j1", { drawing: "d1", job: "j1" }],
  ["#/drawings/d1/check/jobs/j1", { drawing: "d1", step: "check", job: "j1" }],
  ["#/drawings/a%20b", { drawing: "a b" }],
])("%s and back", (hash, opened) => {
  expect(drawingOf(hash)).toEqual({ ...NOTHING, ...opened });
  expect(`#${drawingPath({ ...NOTHING, ...opened })}`).toBe(hash);
});

test.each([
  "",
  "#",
  "#/",
  "#/machines",
  "#/machines/demo-table",
  "#/settings",
  "#/settings/users",
  "#/nowhere",
  "#/drawings/",
  "#/drawings/d1/paint",
  "#/station/my%20table",
  "#/library",
  "#/library/tools",
  "#/library/tools/knife",
  "#/webhooks",
  "#/cartons",
  "#/cartons/ecma-a20.20",
  "#/history",
  "#/history/statistics",
  "#/drawings/d1/fold",
])("the drawing stays open behind %s", (hash) => {
  expect(drawingOf(hash)).toBeNull();
});

test("an address that is not encoded correctly opens nothing", () => {
  expect(drawingOf("#/drawings/%E0%A4%A")).toEqual(NOTHING);
});

const ALL_WORK: WorkView = { filter: NO_FILTER, order: NEWEST };
const searched = (search: string): WorkView => ({ ...ALL_WORK, filter: { ...NO_FILTER, search } });

test.each<[string, WorkView]>([
  ["/", ALL_WORK],
  ["/by/due/reversed", { ...ALL_WORK, order: { sort: "due", reverse: true } }],
  ["/search/50%25%20a%2Fb", searched("50% a/b")],
  [
    "/state/ready/machine/my%20table/search/box/by/name",
    {
      filter: { progress: "ready", machine: "my table", search: "box" },
      order: { sort: "name", reverse: false },
    },
  ],
])("the work at %s and back", (path, view) => {
  expect(workViewOf(`#${path}`)).toEqual(view);
  expect(workPath(view)).toBe(path);
});

test.each(["/state", "/state/lost", "/machine/", "/search/a/b", "/by", "/by/colour", "/x/by/due"])(
  "%s is no address of the work",
  (path) => expect(WORK_TABLE.test(path)).toBe(false),
);

let stop = () => {};
const place = { hash: "", href: "" };
const go = (url: string) => {
  place.href = new URL(url, "http://page/").href;
  place.hash = new URL(place.href).hash;
};
const pushState = vi.fn((_state: unknown, _title: string, url: string) => go(url));
const replaceState = vi.fn((_state: unknown, _title: string, url: string) => go(url));

/** Go to an address as a link or the browser's buttons do. */
const goTo = (hash: string) => {
  go(hash);
  dispatchEvent(new Event("hashchange"));
};

const opened = () => drawingPath(useUiStore.getState());

beforeEach(() => {
  const target = new EventTarget();
  go("#/history");
  vi.stubGlobal("location", place);
  vi.stubGlobal("history", { pushState, replaceState });
  vi.stubGlobal("addEventListener", target.addEventListener.bind(target));
  vi.stubGlobal("removeEventListener", target.removeEventListener.bind(target));
  vi.stubGlobal("dispatchEvent", target.dispatchEvent.bind(target));
  pushState.mockClear();
  replaceState.mockClear();
  useUiStore.getState().open(null);
  stop = syncWithAddress();
});

afterEach(() => {
  stop();
  vi.unstubAllGlobals();
});

test("an address opens its drawing, and adds nothing to the browser history", () => {
  for (const [hash, path] of [
    ["#/drawings/d1", "/drawings/d1"],
    ["#/webhooks", "/drawings/d1"],
    ["#/drawings/d2/check/jobs/j2", "/drawings/d2/check/jobs/j2"],
    ["#/", "/drawings/d2/check/jobs/j2"],
  ] as const) {
    goTo(hash);
    expect(opened()).toBe(path);
    expect(place.hash).toBe(hash);
  }
  expect(pushState).not.toHaveBeenCalled();
});

test("a drawing and its steps are entries of the browser history, a job replaces one", () => {
  goTo("#/drawings/d0");
  showDrawing("d1");
  expect(place.hash).toBe("#/drawings/d1");
  expect(pushState).toHaveBeenCalledTimes(1);
  // The step that the page chooses is no entry of its own.
  useUiStore.getState().set({ step: "sheet" });
  expect(place.hash).toBe("#/drawings/d1/sheet");
  useUiStore.getState().openJob("j2");
  expect(place.hash).toBe("#/drawings/d1/sheet/jobs/j2");
  expect([pushState.mock.calls.length, replaceState.mock.calls.length]).toEqual([1, 2]);
  useUiStore.getState().set({ step: "check" });
  expect(place.hash).toBe("#/drawings/d1/check/jobs/j2");
  expect(pushState).toHaveBeenCalledTimes(2);
  goTo("#/drawings/d1/sheet/jobs/j2");
  expect(useUiStore.getState().step).toBe("sheet");
});

test("a drawing that is shown ends another view, also when it was open behind it", () => {
  goTo("#/drawings/d1/check/jobs/j1");
  goTo("#/history");
  returnToDrawing();
  expect(place.hash).toBe("#/drawings/d1/check/jobs/j1");
  goTo("#/");
  showDrawing("d1");
  expect(place.hash).toBe("#/drawings/d1");
});

test("the station page keeps its address while it follows a job", () => {
  goTo("#/station/table");
  useUiStore.getState().open("d1", "j1");
  useUiStore.getState().openJob("j2");
  expect(place.hash).toBe("#/station/table");
  expect(opened()).toBe("/drawings/d1/jobs/j2");
});

test("each condition on the work is an entry of the browser history, a search is one in all", () => {
  goTo("#/");
  const views = ["b", "bo", "box", ""].map(searched);
  views.reduce((before, view) => {
    showWork(view, before);
    expect(place.hash).toBe(`#${workPath(view)}`);
    return view;
  }, ALL_WORK);
  expect([pushState.mock.calls.length, replaceState.mock.calls.length]).toEqual([2, 2]);
  showWork({ ...ALL_WORK, order: { sort: "due", reverse: false } }, ALL_WORK);
  expect(pushState).toHaveBeenCalledTimes(3);
});

test("the tabs of the history and of the settings have addresses, and no others", () => {
  for (const view of ["jobs", "statistics", "tools"] as const) {
    showHistory(view);
    expect(HISTORY.exec(place.hash.slice(1))?.groups?.view ?? "jobs").toBe(view);
  }
  for (const tab of ["own", "users", "keys", "audit"] as const) {
    showSettings(tab);
    expect(SETTINGS.exec(place.hash.slice(1))?.groups?.tab ?? "own").toBe(tab);
  }
  for (const path of ["/history/nothing", "/history/tools/x", "/settings/user", "/settings/"])
    expect([HISTORY.test(path), SETTINGS.test(path)]).toEqual([false, false]);
});
