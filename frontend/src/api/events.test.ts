import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { type EventSourceLike, openEventStream } from "./events";

class FakeSource implements EventSourceLike {
  static made: FakeSource[] = [];
  readyState = 0;
  onopen: EventSourceLike["onopen"] = null;
  onerror: EventSourceLike["onerror"] = null;
  closed = false;
  private readonly listeners = new Map<string, (event: MessageEvent<string>) => void>();

  constructor() {
    FakeSource.made.push(this);
  }
  addEventListener(name: string, listener: (event: MessageEvent<string>) => void) {
    this.listeners.set(name, listener);
  }
  close() {
    this.closed = true;
  }
  emit(name: string, data: string) {
    this.listeners.get(name)?.({ data } as MessageEvent<string>);
  }
  fails(readyState: number) {
    this.readyState = readyState;
    this.onerror?.(new Event("error"));
  }
}

const CONNECTING = 0;
const CLOSED = 2;
const onEvent = vi.fn();
const onConnection = vi.fn();
const start = () =>
  openEventStream("/e", ["job"], { onEvent, onConnection }, () => new FakeSource());
const source = (at: number) => FakeSource.made.at(at) as FakeSource;

beforeEach(() => {
  vi.useFakeTimers();
  FakeSource.made = [];
  onEvent.mockClear();
  onConnection.mockClear();
});
afterEach(() => vi.useRealTimers());

test("an event arrives as its name and its data", () => {
  start();
  source(0).emit("job", '{"id":"j1"}');
  expect(onEvent).toHaveBeenCalledWith("job", { id: "j1" });
});

test("messages without JSON are ignored", () => {
  start();
  source(0).emit("job", "still here");
  expect(onEvent).not.toHaveBeenCalled();
});

test("a connection that the browser restores is not opened twice", () => {
  start();
  source(0).fails(CONNECTING);
  vi.advanceTimersByTime(60_000);
  expect(FakeSource.made).toHaveLength(1);
  expect(onConnection).toHaveBeenLastCalledWith("broken");
});

test("a closed connection is opened again with growing delays", () => {
  start();
  source(0).fails(CLOSED);
  vi.advanceTimersByTime(499);
  expect(FakeSource.made).toHaveLength(1);
  vi.advanceTimersByTime(1);
  expect(FakeSource.made).toHaveLength(2);
  source(1).fails(CLOSED);
  vi.advanceTimersByTime(999);
  expect(FakeSource.made).toHaveLength(2);
  vi.advanceTimersByTime(1);
  expect(FakeSource.made).toHaveLength(3);
});

test("after a success the delay is the shortest again", () => {
  start();
  source(0).fails(CLOSED);
  vi.advanceTimersByTime(500);
  source(1).onopen?.(new Event("open"));
  source(1).fails(CLOSED);
  vi.advanceTimersByTime(500);
  expect(FakeSource.made).toHaveLength(3);
});

test("no connection is opened after the end", () => {
  const end = start();
  source(0).fails(CLOSED);
  end();
  vi.advanceTimersByTime(60_000);
  expect(FakeSource.made).toHaveLength(1);
  expect(source(0).closed).toBe(true);
});
