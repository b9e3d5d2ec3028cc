/**
 * Binary columns of the server as typed-array views, without a copy.
 *
 *     "KTIP"  uint32 header length  JSON header, padded to 8 bytes  little-endian columns
 *
 * The header is {"columns": [{name, dtype, shape, offset}], "meta": {…}}, offsets counted from
 * where the data begins.
 */

import {
  type DrawnEdges,
  type Edges,
  LINE_TYPES,
  type LineType,
  type Toolpath,
  type VerdictColumns,
} from "../geometry/records";
import { posesOnDrawing, similarityOf } from "../geometry/similarity";
import { translate } from "../language/translate";

type Column = Float64Array | Float32Array | Int32Array | Uint8Array;

export interface Columns {
  readonly columns: ReadonlyMap<string, Column>;
  readonly meta: Readonly<Record<string, unknown>>;
}

/** The bytes have an unexpected format: server and page are of different versions. */
export class ColumnsError extends Error {
  override name = "ColumnsError";
}

interface ColumnHead {
  name: string;
  dtype: string;
  shape: number[];
  offset: number;
}

const MAGIC = "KTIP";

export function decodeColumns(bytes: ArrayBuffer): Columns {
  const magic = String.fromCharCode(...new Uint8Array(bytes, 0, Math.min(4, bytes.byteLength)));
  if (magic !== MAGIC || bytes.byteLength < 8) {
    throw new ColumnsError(translate("columns.theServerSentDataOf", { magic, magic2: MAGIC }));
  }
  const size = new DataView(bytes).getUint32(4, true);
  if (8 + size > bytes.byteLength) {
    throw new ColumnsError(translate("columns.theDataFromTheServer", { size }));
  }
  const header = JSON.parse(new TextDecoder().decode(new Uint8Array(bytes, 8, size))) as {
    columns: ColumnHead[];
    meta?: Record<string, unknown>;
  };
  const data = Math.ceil((8 + size) / 8) * 8;
  const columns = new Map<string, Column>();
  for (const { name, dtype, shape, offset } of header.columns) {
    const count = shape.reduce((product, extent) => product * extent, 1);
    const at = data + offset;
    const view = viewOf(dtype, bytes, at, count);
    if (view === null) {
      throw new ColumnsError(translate("columns.theDataFromTheServer2", { name, count, dtype }));
    }
    columns.set(name, view);
  }
  return { columns, meta: header.meta ?? {} };
}

function viewOf(dtype: string, bytes: ArrayBuffer, at: number, count: number): Column | null {
  const kinds = {
    "<f8": Float64Array,
    "<f4": Float32Array,
    "<i4": Int32Array,
    "|u1": Uint8Array,
  } as const;
  const kind = kinds[dtype as keyof typeof kinds];
  if (kind === undefined || at + count * kind.BYTES_PER_ELEMENT > bytes.byteLength) return null;
  if (at % kind.BYTES_PER_ELEMENT !== 0) {
    return new kind(bytes.slice(at, at + count * kind.BYTES_PER_ELEMENT));
  }
  return new kind(bytes, at, count);
}

function column<T extends Column>(from: Columns, name: string, kind: new (n: number) => T): T {
  const found = from.columns.get(name);
  if (!(found instanceof kind))
    throw new ColumnsError(translate("columns.theDataFromTheServer3", { name }));
  return found;
}

const strings = (value: unknown): string[] => (Array.isArray(value) ? value.map(String) : []);

const codes = (messages: unknown): string[] =>
  (Array.isArray(messages) ? messages : []).map((message) => String(message?.code ?? ""));

const isLineType = (word: string): word is LineType => LINE_TYPES.some((type) => type === word);

const lineTypeLists = (value: unknown): LineType[][] =>
  (Array.isArray(value) ? value : []).map((list) => strings(list).filter(isLineType));

/** Decode a block of edges, which has all columns or only those that are drawn. */
export function drawnEdgesOf(bytes: ArrayBuffer): DrawnEdges | Edges {
  const from = decodeColumns(bytes);
  const { origin } = from.meta;
  if (!Array.isArray(origin)) return edgesFrom(from);
  const [x, y] = origin.map(Number);
  const ends = new Float64Array(column(from, "ends", Float32Array));
  for (let at = 0; at < ends.length; at += 2) {
    (ends[at] as number) += x as number;
    (ends[at + 1] as number) += y as number;
  }
  return {
    ends,
    bulge: new Float64Array(column(from, "bulge", Float32Array)),
    lineType: column(from, "line_type", Uint8Array),
    outcome: column(from, "outcome", Uint8Array),
  };
}

export const edgesOf = (bytes: ArrayBuffer): Edges => edgesFrom(decodeColumns(bytes));

function edgesFrom(from: Columns): Edges {
  const bulge = column(from, "bulge", Float64Array);
  return {
    ends: column(from, "ends", Float64Array),
    bulge,
    lineType: column(from, "line_type", Uint8Array),
    layer: column(from, "layer", Int32Array),
    colour: column(from, "colour", Int32Array),
    rule: column(from, "rule", Int32Array),
    linetype: column(from, "linetype", Int32Array),
    // Drawings of older versions have no line widths.
    lineWidth: from.columns.has("line_width")
      ? column(from, "line_width", Int32Array)
      : new Int32Array(bulge.length).fill(-1),
    confidence: column(from, "confidence", Float64Array),
    length: column(from, "length", Float64Array),
    handles: strings(from.meta.handles),
    layers: strings(from.meta.layers),
    rules: strings(from.meta.rules),
    ruleCodes: codes(from.meta.rule_messages),
    linetypes: strings(from.meta.linetypes),
    alternatives: lineTypeLists(from.meta.alternatives),
    // Drawings of older versions have no outcome columns: all edges were kept.
    outcome: from.columns.has("outcome")
      ? column(from, "outcome", Uint8Array)
      : new Uint8Array(bulge.length),
    reason: from.columns.has("reason")
      ? column(from, "reason", Int32Array)
      : new Int32Array(bulge.length),
    reasons: strings(from.meta.reasons),
  };
}

export function verdictColumnsOf(bytes: ArrayBuffer): VerdictColumns {
  const from = decodeColumns(bytes);
  return {
    areas: {
      ends: column(from, "area_ends", Float64Array),
      bulge: column(from, "area_bulge", Float64Array),
      first: column(from, "area_first", Int32Array),
      size: column(from, "area_size", Float64Array),
    },
    samples: {
      edge: column(from, "sample_edge", Int32Array),
      place: column(from, "sample_place", Float64Array),
      deviation: column(from, "sample_deviation", Float64Array),
    },
  };
}

export function toolpathOf(bytes: ArrayBuffer): Toolpath {
  const from = decodeColumns(bytes);
  const placement = Array.isArray(from.meta.placement) ? from.meta.placement.map(Number) : [];
  const pose = column(from, "pose", Float64Array);
  const similarity = similarityOf(from.meta.similarity);
  return {
    pose: similarity === null ? pose : posesOnDrawing(pose, similarity),
    similarity,
    bulge: column(from, "bulge", Float64Array),
    motion: column(from, "motion", Uint8Array),
    feed: column(from, "feed", Float64Array),
    source: column(from, "source", Int32Array),
    tool: column(from, "tool", Uint8Array),
    line: column(from, "line", Int32Array),
    // Tool paths of older versions have neither.
    ...(from.columns.has("first_line") && {
      firstLine: column(from, "first_line", Int32Array),
      seconds: column(from, "seconds", Float64Array),
    }),
    placement: [placement[0] ?? 0, placement[1] ?? 0],
  };
}
