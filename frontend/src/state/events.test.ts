import { QueryObserver } from "@tanstack/react-query";
import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { subscribeToEvents } from "./cacheUpdates";
import { queryClient } from "./queries";

class FakeSource {
  static last: FakeSource;
  readyState = 1;
  onopen: ((event: Event) => void) | null = null;
  onerror: ((event: Event) => void) | null = null;
  private readonly listeners = new Map<string, (event: MessageEvent<string>) => void>();

  constructor() {
    FakeSource.last = this;
  }
  addEventListener(name: string, listener: (event: MessageEvent<string>) => void) {
    this.listeners.set(name, listener);
  }
  close() {}
  emit(name: string, data: string) {
    this.listeners.get(name)?.({ data } as MessageEvent<string>);
  }
}

const onDrawing = vi.fn();
const isStale = (key: string) => queryClient.getQueryState([key])?.isInvalidated;

beforeEach(() => {
  vi.stubGlobal("EventSource", FakeSource);
  onDrawing.mockClear();
  for (const key of ["jobs", "edges"]) queryClient.setQueryData([key], []);
});
afterEach(() => {
  vi.unstubAllGlobals();
  queryClient.clear();
});

test("lists that were fetched before the stream began are fetched again", () => {
  const end = subscribeToEvents(onDrawing);
  FakeSource.last.onopen?.(new Event("open"));
  expect(isStale("jobs")).toBe(false);
  FakeSource.last.emit("connected", "{}");
  expect(isStale("jobs")).toBe(true);
  expect(isStale("edges")).toBe(false);
  expect(onDrawing).not.toHaveBeenCalled();
  end();
});

test("after a lost connection the open drawing is compared, once", () => {
  const end = subscribeToEvents(onDrawing);
  FakeSource.last.emit("connected", "{}");
  FakeSource.last.onerror?.(new Event("error"));
  FakeSource.last.emit("connected", "{}");
  FakeSource.last.emit("connected", "{}");
  expect(onDrawing.mock.calls).toEqual([[null]]);
  end();
});

test("a stream that breaks makes the page check whether it is still signed in", () => {
  queryClient.setQueryData(["me"], { name: "anna" });
  const end = subscribeToEvents(onDrawing);
  expect(isStale("me")).toBe(false);
  FakeSource.last.onerror?.(new Event("error"));
  expect(isStale("me")).toBe(true);
  end();
});

test("a change of the library fetches again what can be chosen, and no definition", () => {
  for (const key of ["machines", "boards", "profiles", "library", "definition"])
    queryClient.setQueryData([key], []);
  const end = subscribeToEvents(onDrawing);
  FakeSource.last.emit("library", "{}");
  for (const key of ["machines", "boards", "profiles", "library"]) expect(isStale(key)).toBe(true);
  for (const key of ["definition", "jobs"]) expect(isStale(key)).toBe(false);
  expect(onDrawing).not.toHaveBeenCalled();
  end();
});

test("an answer that was requested before the stream began is requested again", async () => {
  const answers: ((rows: string[]) => void)[] = [];
  const observer = new QueryObserver(queryClient, {
    queryKey: ["statistics"],
    queryFn: () => new Promise<string[]>((answer) => answers.push(answer)),
  });
  const stop = observer.subscribe(() => {});
  const end = subscribeToEvents(onDrawing);
  FakeSource.last.emit("connected", "{}");
  expect(answers).toHaveLength(1);
  answers[0]?.(["old"]);
  await vi.waitFor(() => expect(answers).toHaveLength(2));
  answers[1]?.(["new"]);
  await vi.waitFor(() => expect(observer.getCurrentResult().data).toEqual(["new"]));
  end();
  stop();
});
