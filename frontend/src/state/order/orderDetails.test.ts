import { describe, expect, test } from "vitest";
import { fromLocalInput, localInput, secondsOf, timeOf } from "../times";
import { detailsOf, hasDetails, isOverdue, NO_DETAILS } from "./orderDetails";

const DUE = "2030-01-02T03:04:05.000Z";
const NOW = secondsOf(DUE);

describe("an order", () => {
  test("is overdue after its time until it is done", () => {
    expect(isOverdue({ due: DUE, state: "queued" }, NOW + 1)).toBe(true);
    expect(isOverdue({ due: DUE, state: "queued" }, NOW - 1)).toBe(false);
    expect(isOverdue({ due: DUE, state: "interrupted" }, NOW + 1)).toBe(true);
    expect(isOverdue({ due: DUE, state: "done" }, NOW + 1)).toBe(false);
    expect(isOverdue({ due: null, state: "queued" }, NOW + 1)).toBe(false);
  });

  test("without number, customer and due time has nothing to show", () => {
    expect(hasDetails(NO_DETAILS)).toBe(false);
    expect(hasDetails({ ...NO_DETAILS, customer: "K-12" })).toBe(true);
    expect(hasDetails({ ...NO_DETAILS, due: DUE })).toBe(true);
    expect(detailsOf({ ...NO_DETAILS, notes: "x" })).toEqual({ ...NO_DETAILS, notes: "x" });
  });
});

describe("a time", () => {
  test("is the same after it was shown in a field", () => {
    const minute = "2030-01-02T03:04:00.000Z";
    expect(fromLocalInput(localInput(minute))).toBe(minute);
    expect(localInput(null)).toBe("");
    expect(fromLocalInput("")).toBeNull();
    expect(fromLocalInput("nonsense")).toBeNull();
    expect(timeOf(secondsOf(DUE))).toBe(DUE);
  });
});
