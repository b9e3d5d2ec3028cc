import { expect, test } from "vitest";
import { ariaSort, NEWEST, nextOrder } from "./workOrder";

test("a column is ascending, then descending, then not sorted by", () => {
  const seen = [];
  let order = NEWEST;
  for (let click = 0; click < 3; click++) {
    order = nextOrder(order, "due");
    seen.push([ariaSort(order, "due"), ariaSort(order, "customer")]);
  }
  expect(seen).toEqual([
    ["ascending", "none"],
    ["descending", "none"],
    ["none", "none"],
  ]);
  expect(nextOrder({ sort: "due", reverse: true }, "board")).toEqual({
    sort: "board",
    reverse: false,
  });
});
