/** Summary of some edges: types, reasons, layers, colours. */

import { type Edges, type LineType, lineTypeOf, outcomeOf } from "../../geometry/records";
import { translate } from "../../language/translate";
import { layerOf } from "./rows";

export interface TypeReason {
  readonly type: LineType;
  /** Rule or evidence. */
  readonly rule: string;
  /** Lowest confidence of its edges, 0 … 1. */
  readonly confidence: number;
  readonly rows: readonly number[];
}

export interface EdgeSummary {
  /** mm */
  readonly length: number;
  /** Ordered by number of edges, most first. */
  readonly reasons: readonly TypeReason[];
  /** Number of reasons not listed. */
  readonly more: number;
  /** Other line types possible for all of them, most likely first. */
  readonly alternatives: readonly LineType[];
  readonly layers: readonly string[];
  readonly colours: readonly number[];
  readonly linetypes: readonly string[];
  /** Widths with which the file draws them (1/100 mm), without those that it does not state. */
  readonly lineWidths: readonly number[];
  /** Outcome of cleaning if it is the same for all; empty if kept as drawn. */
  readonly outcome: string;
}

const LISTED = 4;

/** Text for the rule or evidence that decided an edge. */
export const ruleText = (rule: string): string =>
  rule === "" ? translate("inspect.noRuleOfTheProfile") : rule;

export function summarizeEdges(edges: Edges, rows: readonly number[]): EdgeSummary {
  const reasons = new Map<
    string,
    { type: LineType; rule: string; confidence: number; rows: number[] }
  >();
  const outcomes = new Set<string>();
  const layers = new Set<string>();
  const colours = new Set<number>();
  const linetypes = new Set<string>();
  const lineWidths = new Set<number>();
  let length = 0;
  for (const row of rows) {
    const type = lineTypeOf(edges.lineType[row]);
    const rule = edges.rules[edges.rule[row] ?? -1] ?? "";
    const confidence = edges.confidence[row] ?? 0;
    const key = `${type} ${rule}`;
    const known = reasons.get(key);
    if (known === undefined) reasons.set(key, { type, rule, confidence, rows: [row] });
    else {
      known.rows.push(row);
      known.confidence = Math.min(known.confidence, confidence);
    }
    length += edges.length[row] ?? 0;
    outcomes.add(outcomeText(edges, row));
    layers.add(layerOf(edges, row));
    colours.add(edges.colour[row] ?? 0);
    linetypes.add(edges.linetypes[edges.linetype[row] ?? -1] ?? "");
    lineWidths.add(edges.lineWidth[row] ?? -1);
  }
  const listed = [...reasons.values()].sort((a, b) => b.rows.length - a.rows.length);
  const [outcome = ""] = outcomes;
  return {
    length,
    reasons: listed.slice(0, LISTED),
    more: Math.max(0, listed.length - LISTED),
    alternatives: alternativesOf(edges, rows),
    layers: [...layers].slice(0, LISTED),
    colours: [...colours].slice(0, LISTED),
    linetypes: [...linetypes].slice(0, LISTED),
    lineWidths: [...lineWidths].filter((width) => width >= 0).slice(0, LISTED),
    outcome: outcomes.size === 1 ? outcome : "",
  };
}

function outcomeText(edges: Edges, row: number): string {
  const outcome = outcomeOf(edges.outcome[row]);
  const reason = edges.reasons[edges.reason[row] ?? 0] ?? "";
  return reason === "" && outcome === "kept"
    ? ""
    : reason === ""
      ? outcome
      : `${outcome}: ${reason}`;
}

/** Alternatives that all edges share, in the order of the first edge. */
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
