import { readFileSync } from "node:fs";
import { beforeEach, describe, expect, test } from "vitest";
import type { Job, Sheet } from "../api/jobs";
import { upsertJob } from "./cacheUpdates";
import { formatDeviation, formatDuration, formatLength, formatSize } from "./format";
import { DEFAULT_OPTIONS } from "./order/options";
import { queries, queryClient } from "./queries";
import { useUiStore } from "./store";

const SHEET = { width: 400, height: 300, margin: 10 } as Sheet;
const page = () => useUiStore.getState();
const job = (id: string, part: Partial<Job> = {}): Job =>
  ({ id, state: "running", updated: "2030-01-01T00:00:10.000Z", progress: 0, ...part }) as Job;

beforeEach(() => {
  page().open(null);
  queryClient.clear();
});

describe("the selection", () => {
  test("a click selects one edge", () => {
    page().selectEdges([1]);
    page().selectEdges([4]);
    expect([...page().selection]).toEqual([4]);
  });

  test("with Shift a click adds or removes an edge", () => {
    page().selectEdges([1]);
    page().selectEdges([4], "toggle");
    expect([...page().selection]).toEqual([1, 4]);
    page().selectEdges([1], "toggle");
    expect([...page().selection]).toEqual([4]);
  });

  test("a box only adds", () => {
    page().selectEdges([1, 2]);
    page().selectEdges([2, 3], "add");
    expect([...page().selection]).toEqual([1, 2, 3]);
  });

  test("is cleared with its drawing", () => {
    page().open("d1");
    page().selectEdges([1]);
    page().open("d2");
    expect(page().selection.size).toBe(0);
  });
});

describe("the choices for a job", () => {
  const usual = DEFAULT_OPTIONS;
  const start = { board: null, copies: 1, sheet: null, lift: "clearance", options: usual };
  const chosen = () => {
    const { board, copies, sheet, lift, options } = page();
    return { board, copies, sheet, lift, options };
  };

  test("belong to one drawing: another one starts without a board", () => {
    page().open("d1");
    const options = { ...usual, feed_factor: 0.5 };
    page().set({ board: "b-flute", copies: 7, lift: "least", sheet: SHEET, options });
    page().open("d2");
    expect(chosen()).toEqual(start);
    page().set({ board: "greyboard" });
    page().open("d1");
    const first = { board: "b-flute", copies: 7, lift: "least", sheet: SHEET, options };
    expect(chosen()).toEqual(first);
    page().open("d2", "job");
    expect(chosen()).toEqual({ ...start, board: "greyboard" });
  });

  test("are not taken over from a page without a drawing", () => {
    page().open("d3");
    page().set({ board: "b-flute" });
    page().open(null);
    expect(page().board).toBeNull();
    page().open("d4");
    expect(page().board).toBeNull();
  });
});

test("zooming to the same edges again is a new request", () => {
  page().zoomToEdges([3]);
  const first = page().zoomRequest.count;
  page().zoomToEdges([3]);
  expect(page().zoomRequest.count).toBe(first + 1);
});

test("unchanged moves under the cursor keep the same list", () => {
  page().setHover({ row: null, moves: [3, 4], x: 1, y: 1 });
  const before = page().hover?.moves;
  page().setHover({ row: null, moves: [3, 4], x: 2, y: 1 });
  expect(page().hover?.moves).toBe(before);
  expect(page().hover?.x).toBe(2);
  page().setHover({ row: null, moves: [4], x: 2, y: 1 });
  expect(page().hover?.moves).toEqual([4]);
});

test("a second click shows a hidden type again", () => {
  page().toggleType("cut");
  expect(page().hiddenTypes.has("cut")).toBe(true);
  page().toggleType("cut");
  expect(page().hiddenTypes.has("cut")).toBe(false);
});

describe("an update of a job", () => {
  test("is shown in the queue and in the job panel", () => {
    queryClient.setQueryData(queries.jobs().queryKey, {
      pages: [
        { rows: [job("a")], next: 1 },
        { rows: [job("b")], next: null },
      ],
      pageParams: [null, 1],
    });
    upsertJob(job("b", { progress: 0.5 }));
    upsertJob(job("c"));
    const pages = queryClient.getQueryData(queries.jobs().queryKey)?.pages ?? [];
    expect(pages.map(({ rows }) => rows.map(({ id }) => id))).toEqual([["c", "a"], ["b"]]);
    expect(pages[1]?.rows[0]?.progress).toBe(0.5);
    expect(queryClient.getQueryData(queries.job("b").queryKey)?.progress).toBe(0.5);
  });

  test("is not replaced by an older one that arrives later", () => {
    upsertJob(job("a", { state: "done", updated: "2030-01-01T00:00:12.000Z" }));
    upsertJob(job("a", { state: "running", updated: "2030-01-01T00:00:11.000Z" }));
    expect(queryClient.getQueryData(queries.job("a").queryKey)?.state).toBe("done");
  });
});

/** The job ticket is tested with the same table. */
const DURATIONS: readonly (readonly [number, string])[] = JSON.parse(
  readFileSync(new URL("../../../tests/support/durations.json", import.meta.url), "utf8"),
);

describe("formatted figures", () => {
  test.each([
    [0, "0\u202fmm"],
    [0.002, "<\u202f0.1\u202fmm"],
    [45.25, "45.3\u202fmm"],
    [1234.4, "1234\u202fmm"],
    [25_000, "25.00\u202fm"],
  ])("a length of %f mm", (value, words) => expect(formatLength(value)).toBe(words));

  test.each([
    [0, "0\u202fmm"],
    [0.000_02, "<\u202f0.0001\u202fmm"],
    [0.0123, "0.0123\u202fmm"],
  ])("a deviation of %f mm", (value, words) => expect(formatDeviation(value)).toBe(words));

  test.each(DURATIONS)("%f seconds", (value, words) =>
    expect(formatDuration(value).replace("\u202f", " ")).toBe(words),
  );

  test("a size above ten metres is in metres", () => {
    expect(formatSize(60_960, 36_576)).toBe("60.96 × 36.58\u202fm");
    expect(formatSize(200, 120)).toBe("200.0 × 120.0\u202fmm");
  });
});
