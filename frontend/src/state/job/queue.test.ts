import { describe, expect, test } from "vitest";
import type { QueueEntry } from "../../api/machines";
import { neighboursAt, priorityTitle, startText, waitingIds } from "./queue";

const entry = (change: object, job: object = {}): QueueEntry =>
  ({ place: 1, starts_in: 90, job: { id: "a", on_hold: false, ...job }, ...change }) as QueueEntry;

describe("a place in the queue", () => {
  const ids = ["a", "b", "c"];

  test.each([
    ["a", 1, { previous: "b", next: "c" }],
    ["a", 2, { previous: "c", next: "" }],
    ["c", 0, { previous: "", next: "a" }],
    ["b", 1, null],
    ["a", -1, null],
    ["a", 3, null],
  ])("of %s with %i jobs before it", (id, index, expected) => {
    expect(neighboursAt(ids, id, index)).toEqual(expected);
  });

  test("belongs to jobs that no machine has taken", () => {
    expect(waitingIds([entry({ place: 0 }, { id: "x" }), entry({})])).toEqual(["a"]);
  });
});

test.each([
  [100, "Urgent"],
  [20, "Urgent"],
  [5, "Normal"],
  [-1, "Low"],
  [-100, "Low"],
])("priority %i is %s", (priority, title) => {
  expect(priorityTitle(priority)).toBe(title);
});

test.each([
  [entry({ place: 0 }), ""],
  [entry({}, { on_hold: true }), "on hold"],
  [entry({ starts_in: null }), "start unknown"],
  [entry({ starts_in: 0 }), "next"],
  [entry({}), "in 1:30\u202fmin"],
])("start of a job", (row, text) => {
  expect(startText(row)).toBe(text);
});
