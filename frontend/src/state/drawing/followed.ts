/** Edges whose line type follows from answers about other edges of the same drawing. */

import { type Edges, type LineType, lineTypeOf } from "../../geometry/records";
import type { Code } from "../../messages/catalogue";

const FOLLOWS: Code = "classification.follows";

/** The rows of these edges by line type. */
export function followedEdges(edges: Edges): { type: LineType; rows: number[] }[] {
  const code = edges.ruleCodes.indexOf(FOLLOWS);
  const byType = new Map<LineType, number[]>();
  if (code < 0) return [];
  edges.rule.forEach((rule, row) => {
    if (rule !== code) return;
    const type = lineTypeOf(edges.lineType[row]);
    const rows = byType.get(type);
    if (rows === undefined) byType.set(type, [row]);
    else rows.push(row);
  });
  return [...byType].map(([type, rows]) => ({ type, rows }));
}
