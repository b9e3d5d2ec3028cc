import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { drawingOf, drawingPath, returnToDrawing, showDrawing, syncWithAddress } from "./routes";
import { type OpenDrawing, useUiStore } from "./store";

const NOTHING: OpenDrawing = { drawing: null, job: null };

test.each<[string, Partial<OpenDrawing>]>([
  ["#/", {}],
  ["#/drawings/d1", { drawing: "d1" }],
  ["#/drawings/d1/jobs/j1", { drawing: "d1", job: "j1" }],
  ["#/drawings/a%20b", { drawing: "a b" }],
])("%s and back", (hash, opened) => {
  expect(drawingOf(hash)).toEqual({ ...NOTHING, ...opened });
  expect(`#${drawingPath({ ...NOTHING, ...opened })}`).toBe(hash);
});

test.each([
  "#/station/my%20table",
  "#/library",
  "#/library/tools/knife",
  "#/webhooks",
  "#/history",
])("the drawing stays open behind %s", (hash) => {
  expect(drawingOf(hash)).toBeNull();
});

test.each(["", "#", "#/nowhere", "#/drawings/", "#/drawings/%E0%A4%A", "#/station/"])(
  "%s opens nothing",
  (hash) => {
    expect(drawingOf(hash)).toEqual(NOTHING);
  },
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
    ["#/drawings/d2/jobs/j2", "/drawings/d2/jobs/j2"],
    ["#/", "/"],
  ] as const) {
    goTo(hash);
    expect(opened()).toBe(path);
    expect(place.hash).toBe(hash);
  }
  expect(pushState).not.toHaveBeenCalled();
});

test("a drawing that the page opens becomes the address, and its job replaces it", () => {
  goTo("#/");
  showDrawing("d1");
  expect(place.hash).toBe("#/drawings/d1");
  expect(pushState).toHaveBeenCalledTimes(1);
  useUiStore.getState().openJob("j2");
  expect(place.hash).toBe("#/drawings/d1/jobs/j2");
  expect([pushState.mock.calls.length, replaceState.mock.calls.length]).toEqual([1, 1]);
});

test("a drawing that is shown ends another view, also when it was open behind it", () => {
  goTo("#/drawings/d1/jobs/j1");
  goTo("#/history");
  returnToDrawing();
  expect(place.hash).toBe("#/drawings/d1/jobs/j1");
  goTo("#/history");
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
