import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { type Route, useUiStore } from "../state/store";
import { hashOf, routeOf, syncWithAddress } from "./routes";

const NOTHING: Route = {
  drawing: null,
  job: null,
  station: null,
  library: false,
  webhooks: false,
  history: false,
};

test.each<[string, Partial<Route>]>([
  ["#/", {}],
  ["#/drawings/d1", { drawing: "d1" }],
  ["#/drawings/d1/jobs/j1", { drawing: "d1", job: "j1" }],
  ["#/station/my%20table", { station: "my table" }],
  ["#/library", { library: true }],
  ["#/webhooks", { webhooks: true }],
  ["#/history", { history: true }],
])("%s and back", (hash, route) => {
  expect(routeOf(hash)).toEqual({ ...NOTHING, ...route });
  expect(hashOf({ ...NOTHING, ...route })).toBe(hash);
});

test("the station page keeps its address while it shows a job", () => {
  expect(hashOf({ ...NOTHING, drawing: "d1", job: "j1", station: "table" })).toBe(
    "#/station/table",
  );
});

test.each(["", "#", "#/nowhere", "#/drawings/", "#/drawings/%E0%A4%A", "#/station/"])(
  "%s opens nothing",
  (hash) => {
    expect(routeOf(hash)).toEqual(NOTHING);
  },
);

let stop = () => {};

const goTo = (hash: string) => {
  window.location.hash = hash;
  window.dispatchEvent(new Event("hashchange"));
};

beforeEach(() => {
  const location = { hash: "#/history" };
  const show = (_state: unknown, _title: string, hash: string) => {
    location.hash = hash;
  };
  const history = { pushState: vi.fn(show), replaceState: vi.fn(show) };
  vi.stubGlobal("window", Object.assign(new EventTarget(), { location, history }));
  stop = syncWithAddress();
});

afterEach(() => {
  stop();
  useUiStore.getState().openRoute(NOTHING);
  vi.unstubAllGlobals();
});

test("an address changes the view in one step", () => {
  const addresses: string[] = [];
  const end = useUiStore.subscribe((page) => addresses.push(hashOf(page)));
  for (const hash of ["#/station/table", "#/drawings/d1", "#/webhooks", "#/drawings/d2/jobs/j2"]) {
    goTo(hash);
    expect(window.location.hash).toBe(hash);
    expect(window.history.pushState).not.toHaveBeenCalled();
  }
  end();
  expect(addresses).toEqual([
    "#/station/table",
    "#/drawings/d1",
    "#/webhooks",
    "#/drawings/d2/jobs/j2",
  ]);
});

test("a view that the page opens becomes the address", () => {
  useUiStore.getState().open("d1", "j1");
  expect(window.location.hash).toBe("#/drawings/d1/jobs/j1");
  useUiStore.getState().set({ history: true });
  expect(window.location.hash).toBe("#/history");
  useUiStore.getState().set({ history: false });
  expect(window.location.hash).toBe("#/drawings/d1/jobs/j1");
  expect(window.history.pushState).toHaveBeenCalledTimes(3);
  useUiStore.getState().openJob("j2");
  expect(window.location.hash).toBe("#/drawings/d1/jobs/j2");
  expect(window.history.replaceState).toHaveBeenCalledTimes(1);
});
