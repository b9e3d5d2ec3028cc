import { beforeEach, describe, expect, test } from "vitest";
import type { Job } from "../api/client";
import { heardJob, keys, queries } from "./queries";
import { usePage } from "./store";
import { deviation, duration, length, size } from "./words";

const page = () => usePage.getState();
const job = (id: string, part: Partial<Job> = {}): Job =>
  ({ id, state: "running", updated: 10, progress: 0, ...part }) as Job;

beforeEach(() => {
  page().open(null);
  queries.clear();
});

describe("the selection", () => {
  test("a click chooses one edge alone", () => {
    page().choose([1]);
    page().choose([4]);
    expect([...page().selection]).toEqual([4]);
  });

  test("with Shift one more, or one less", () => {
    page().choose([1]);
    page().choose([4], true);
    expect([...page().selection]).toEqual([1, 4]);
    page().choose([1], true);
    expect([...page().selection]).toEqual([4]);
  });

  test("a box only adds", () => {
    page().choose([1, 2]);
    page().choose([2, 3], true);
    expect([...page().selection]).toEqual([1, 2, 3]);
  });

  test("is let go with its drawing", () => {
    page().open("d1");
    page().choose([1]);
    page().open("d2");
    expect(page().selection.size).toBe(0);
  });
});

test("to look at the same edges again is a new wish", () => {
  page().look([3]);
  const first = page().focus.count;
  page().look([3]);
  expect(page().focus.count).toBe(first + 1);
});

test("moves that stay under the cursor stay the same list", () => {
  page().point({ row: null, moves: [3, 4], x: 1, y: 1 });
  const before = page().hover?.moves;
  page().point({ row: null, moves: [3, 4], x: 2, y: 1 });
  expect(page().hover?.moves).toBe(before);
  expect(page().hover?.x).toBe(2);
  page().point({ row: null, moves: [4], x: 2, y: 1 });
  expect(page().hover?.moves).toEqual([4]);
});

test("what is hidden is shown again by the same click", () => {
  page().toggleType("cut");
  expect(page().hiddenTypes.has("cut")).toBe(true);
  page().toggleType("cut");
  expect(page().hiddenTypes.has("cut")).toBe(false);
});

describe("what the service tells of a job", () => {
  test("stands in the queue and where it is looked at", () => {
    queries.setQueryData(keys.jobs().queryKey, {
      pages: [
        { rows: [job("a")], next: "/api/jobs?cursor=1" },
        { rows: [job("b")], next: null },
      ],
      pageParams: ["/api/jobs", "/api/jobs?cursor=1"],
    });
    heardJob(job("b", { progress: 0.5 }));
    heardJob(job("c"));
    const pages = queries.getQueryData(keys.jobs().queryKey)?.pages ?? [];
    expect(pages.map(({ rows }) => rows.map(({ id }) => id))).toEqual([["c", "a"], ["b"]]);
    expect(pages[1]?.rows[0]?.progress).toBe(0.5);
    expect(queries.getQueryData(keys.job("b").queryKey)?.progress).toBe(0.5);
  });

  test("is not undone by older news that comes late", () => {
    heardJob(job("a", { state: "done", updated: 12 }));
    heardJob(job("a", { state: "running", updated: 11 }));
    expect(queries.getQueryData(keys.job("a").queryKey)?.state).toBe("done");
  });
});

describe("figures in words", () => {
  test.each([
    [0, "0\u202fmm"],
    [0.002, "<\u202f0.1\u202fmm"],
    [45.25, "45.3\u202fmm"],
    [1234.4, "1234\u202fmm"],
    [25_000, "25.00\u202fm"],
  ])("a length of %f mm", (value, words) => expect(length(value)).toBe(words));

  test.each([
    [0, "0\u202fmm"],
    [0.000_02, "<\u202f0.0001\u202fmm"],
    [0.0123, "0.0123\u202fmm"],
  ])("a deviation of %f mm", (value, words) => expect(deviation(value)).toBe(words));

  test.each([
    [4.24, "4.2\u202fs"],
    [59.6, "1:00\u202fmin"],
    [75, "1:15\u202fmin"],
    [3720, "1:02\u202fh"],
  ])("%f seconds", (value, words) => expect(duration(value)).toBe(words));

  test("a size beyond ten metres is said in metres", () => {
    expect(size(60_960, 36_576)).toBe("60.96 × 36.58\u202fm");
    expect(size(200, 120)).toBe("200.0 × 120.0\u202fmm");
  });
});
