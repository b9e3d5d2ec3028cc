import { describe, expect, test } from "vitest";
import { isComplete } from "../geometry/records";
import {
  ColumnsError,
  decodeColumns,
  drawnEdgesOf,
  edgesOf,
  toolpathOf,
  verdictColumnsOf,
} from "./columns";

type Values = Float64Array | Float32Array | Int32Array | Uint8Array;
const DTYPES = new Map<unknown, string>([
  [Float64Array, "<f8"],
  [Float32Array, "<f4"],
  [Int32Array, "<i4"],
  [Uint8Array, "|u1"],
]);

/** Columns as the service packs them: every one at a multiple of 8. */
function packed(columns: Record<string, Values>, meta: object = {}): ArrayBuffer {
  let offset = 0;
  const heads = Object.entries(columns).map(([name, values]) => {
    const head = { name, dtype: DTYPES.get(values.constructor), shape: [values.length], offset };
    offset += Math.ceil(values.byteLength / 8) * 8;
    return head;
  });
  let header = JSON.stringify({ columns: heads, meta });
  const extra = (bytes: number) => (8 - ((8 + bytes) % 8)) % 8;
  header += " ".repeat(extra(new TextEncoder().encode(header).length));
  const text = new TextEncoder().encode(header);
  const bytes = new Uint8Array(8 + text.length + offset);
  bytes.set(new TextEncoder().encode("KTIP"));
  new DataView(bytes.buffer).setUint32(4, text.length, true);
  bytes.set(text, 8);
  Object.values(columns).forEach((values, at) => {
    const { buffer, byteOffset, byteLength } = values;
    bytes.set(
      new Uint8Array(buffer, byteOffset, byteLength),
      8 + text.length + (heads[at]?.offset ?? 0),
    );
  });
  return bytes.buffer;
}

const EDGES = {
  ends: Float64Array.of(0, 0, 100, 0),
  bulge: Float64Array.of(0.5),
  line_type: Uint8Array.of(3),
  layer: Int32Array.of(0),
  colour: Int32Array.of(6),
  linetype: Int32Array.of(0),
  rule: Int32Array.of(1),
  confidence: Float64Array.of(0.95),
  length: Float64Array.of(115.9),
};

describe("columns", () => {
  test("are decoded as encoded", () => {
    const { columns, meta } = decodeColumns(
      packed({ a: Float64Array.of(1.5, -2), b: Uint8Array.of(7), c: Int32Array.of(-1) }, { n: 3 }),
    );
    expect(columns.get("a")).toEqual(Float64Array.of(1.5, -2));
    expect(columns.get("b")).toEqual(Uint8Array.of(7));
    expect(columns.get("c")).toEqual(Int32Array.of(-1));
    expect(meta).toEqual({ n: 3 });
  });

  test("are views of the answer, not copies", () => {
    const bytes = packed({ a: Float64Array.of(1) });
    expect(decodeColumns(bytes).columns.get("a")?.buffer).toBe(bytes);
  });

  test("a layer name with an umlaut does not shift them", () => {
    const edges = edgesOf(packed(EDGES, { layers: ["RILLER ÄÖ"], handles: ["2F4"] }));
    expect(edges.layers).toEqual(["RILLER ÄÖ"]);
    expect(edges.length[0]).toBe(115.9);
  });

  test("edges have their names", () => {
    const edges = edgesOf(
      packed(EDGES, {
        handles: ["2F4"],
        layers: ["NUT"],
        rules: ["none", "profile default: layer NUT"],
        linetypes: ["Continuous"],
      }),
    );
    expect(edges.lineType[0]).toBe(3);
    expect(edges.rules[edges.rule[0] ?? 0]).toBe("profile default: layer NUT");
    expect(edges.handles).toEqual(["2F4"]);
  });

  test("edges have the widths of their lines, and none in drawings of older versions", () => {
    const names = { handles: ["2F4"], layers: ["NUT"] };
    const drawn = edgesOf(packed({ ...EDGES, line_width: Int32Array.of(50) }, names));
    expect(drawn.lineWidth).toEqual(Int32Array.of(50));
    expect(edgesOf(packed(EDGES, names)).lineWidth).toEqual(Int32Array.of(-1));
  });

  test("a tool path has its placement", () => {
    const toolpath = toolpathOf(
      packed(
        {
          pose: Float64Array.of(0, 0, 20, 0, 5, 0, 20, 90),
          bulge: Float64Array.of(0),
          motion: Uint8Array.of(0),
          feed: Float64Array.of(0),
          source: Int32Array.of(-1),
          tool: Uint8Array.of(1),
          line: Int32Array.of(4),
        },
        { placement: [20, 22.5] },
      ),
    );
    expect(toolpath.placement).toEqual([20, 22.5]);
    expect(toolpath.pose[7]).toBe(90);
  });

  test("other content is refused", () => {
    const html = new TextEncoder().encode("<!doctype html>").buffer as ArrayBuffer;
    expect(() => decodeColumns(html)).toThrow(ColumnsError);
    expect(() => decodeColumns(new ArrayBuffer(0))).toThrow(ColumnsError);
  });

  test("an answer that was cut short is refused", () => {
    const whole = packed({ a: Float64Array.of(1, 2, 3) });
    expect(() => decodeColumns(whole.slice(0, -8))).toThrow(/incomplete: column a/);
    expect(() => decodeColumns(whole.slice(0, 20))).toThrow(/incomplete: its header/);
  });

  test("a column that is missing is named", () => {
    const { length: _, ...others } = EDGES;
    expect(() => edgesOf(packed(others))).toThrow(/lacks the column length/);
  });
});

test("what a picture needs lies about its origin; few edges come with all columns", () => {
  const drawn = drawnEdgesOf(
    packed(
      {
        ends: Float32Array.of(-50, 0, 50, 0.25),
        bulge: Float32Array.of(0.5),
        line_type: Uint8Array.of(2),
        outcome: Uint8Array.of(1),
      },
      { origin: [1e6, 20] },
    ),
  );
  expect([...drawn.ends]).toEqual([999_950, 20, 1_000_050, 20.25]);
  expect([drawn.bulge[0], drawn.lineType[0], drawn.outcome[0]]).toEqual([0.5, 2, 1]);
  expect(isComplete(drawn)).toBe(false);
  const all = drawnEdgesOf(packed(EDGES, { handles: ["2F4"], layers: ["NUT"] }));
  expect(isComplete(all) && all.handles).toEqual(["2F4"]);
});

test("a verdict's areas and samples are read by their names", () => {
  const { areas, samples } = verdictColumnsOf(
    packed({
      area_ends: Float64Array.of(0, 3, 0, 0, 0, 0, 3, 0, 3, 0, 0, 3),
      area_bulge: Float64Array.of(0, 0, -0.4),
      area_first: Int32Array.of(0, 3),
      area_size: Float64Array.of(1.93),
      sample_edge: Int32Array.of(0, 0),
      sample_place: Float64Array.of(0, 1),
      sample_deviation: Float64Array.of(0.001, -0.002),
    }),
  );
  expect([...areas.first]).toEqual([0, 3]);
  expect(areas.ends[1]).toBe(3);
  expect([...samples.deviation]).toEqual([0.001, -0.002]);
});

test("a verdict without areas raises an error that names the column", () => {
  expect(() => verdictColumnsOf(packed({ deviation: Float64Array.of(0) }))).toThrow(/area_ends/);
});
