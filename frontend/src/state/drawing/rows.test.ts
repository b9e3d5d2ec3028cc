import { describe, expect, test } from "vitest";
import type { Edges } from "../../geometry/records";
import { concernedRows } from "./rows";

/** Four edges, of which three are parts of one polyline. */
const edges = { bulge: new Float64Array(4), handles: ["2F", "2F", "2F", "30"] } as unknown as Edges;

describe("the edges that a refusal concerns", () => {
  test("are those that it names, not the whole object of the file", () => {
    expect(concernedRows(edges, { edges: [1], source: ["2F"] })).toEqual([1]);
  });

  test("are those of the object if an older server names no edges", () => {
    expect(concernedRows(edges, { edges: [], source: ["2F"] })).toEqual([0, 1, 2]);
  });

  test("exist in the drawing", () => {
    expect(concernedRows(edges, { edges: [3, 4], source: ["30"] })).toEqual([3]);
  });
});
