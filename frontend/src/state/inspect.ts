/** What can be said of some edges together. */

import { type Edges, fateOf, type LineType, lineTypeOf } from "../geometry/records";
import { BY_HAND } from "./history";
import { layerOf } from "./rows";

export interface Why {
  readonly type: LineType;
  /** The rule or the evidence, in words. */
  readonly rule: string;
  /** The least of those that it decided: 0 … 1 */
  readonly confidence: number;
  readonly rows: readonly number[];
}

export interface Inspected {
  /** mm */
  readonly length: number;
  /** The reasons that decided most edges first. */
  readonly why: readonly Why[];
  /** So many reasons are not listed. */
  readonly more: number;
  /** What all of them could be besides, the likeliest first. */
  readonly alternatives: readonly LineType[];
  readonly layers: readonly string[];
  readonly colours: readonly number[];
  readonly linetypes: readonly string[];
  /** What the cleaning made of them, where that is one thing and not nothing. */
  readonly fate: string;
}

const LISTED = 4;

/** The rule or the evidence that decided an edge, in words. */
export const ruleWords = (rule: string): string =>
  rule === BY_HAND ? "decided by hand" : rule === "" ? "nothing says what it is" : rule;

export function inspected(edges: Edges, rows: readonly number[]): Inspected {
  const why = new Map<
    string,
    { type: LineType; rule: string; confidence: number; rows: number[] }
  >();
  const fates = new Set<string>();
  const layers = new Set<string>();
  const colours = new Set<number>();
  const linetypes = new Set<string>();
  let length = 0;
  for (const row of rows) {
    const type = lineTypeOf(edges.lineType[row]);
    const rule = edges.rules[edges.rule[row] ?? -1] ?? "";
    const confidence = edges.confidence[row] ?? 0;
    const key = `${type} ${rule}`;
    const known = why.get(key);
    if (known === undefined) why.set(key, { type, rule, confidence, rows: [row] });
    else {
      known.rows.push(row);
      known.confidence = Math.min(known.confidence, confidence);
    }
    length += edges.length[row] ?? 0;
    fates.add(fateWords(edges, row));
    layers.add(layerOf(edges, row));
    colours.add(edges.colour[row] ?? 0);
    linetypes.add(edges.linetypes[edges.linetype[row] ?? -1] ?? "");
  }
  const listed = [...why.values()].sort((a, b) => b.rows.length - a.rows.length);
  const [fate = ""] = fates;
  return {
    length,
    why: listed.slice(0, LISTED),
    more: Math.max(0, listed.length - LISTED),
    alternatives: alternativesOf(edges, rows),
    layers: [...layers].slice(0, LISTED),
    colours: [...colours].slice(0, LISTED),
    linetypes: [...linetypes].slice(0, LISTED),
    fate: fates.size === 1 ? fate : "",
  };
}

function fateWords(edges: Edges, row: number): string {
  const fate = fateOf(edges.fate[row]);
  const reason = edges.reasons[edges.reason[row] ?? 0] ?? "";
  return reason === "" && fate === "kept" ? "" : reason === "" ? fate : `${fate}: ${reason}`;
}

/** What each of them could be besides; in the order of the first. */
function alternativesOf(edges: Edges, rows: readonly number[]): LineType[] {
  const rules = [...new Set(rows.map((row) => edges.rule[row] ?? -1))];
  const lists = rules.map((rule) => edges.alternatives[rule] ?? []);
  const now = new Set(rows.map((row) => lineTypeOf(edges.lineType[row])));
  return (lists[0] ?? []).filter(
    (type) =>
      type !== "unclassified" &&
      !(now.size === 1 && now.has(type)) &&
      lists.every((list) => list.includes(type)),
  );
}
