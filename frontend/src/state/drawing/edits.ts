/** Edits of the geometry of a drawing, in the form in which the server stores them. */

import type { Edit } from "../../api/drawings";
import type { Point, Segments } from "../../geometry/records";

export type EditedType = Extract<Edit, { kind: "line" }>["type"];

/** Ends nearer than this to a point are moved with it (mm). */
const SAME_POINT = 1e-4;

const pair = ({ x, y }: Point): [number, number] => [x, y];

export const addedLine = (start: Point, end: Point, type: EditedType): Edit => ({
  kind: "line",
  start: pair(start),
  end: pair(end),
  bulge: 0,
  type,
});

export const addedCircle = (centre: Point, through: Point, type: EditedType): Edit => ({
  kind: "circle",
  centre: pair(centre),
  radius: Math.hypot(through.x - centre.x, through.y - centre.y),
  type,
});

/** Edits that move all ends at a point to another one; of `rows` only, unless it is empty. */
export function movedEnds(
  { ends, bulge }: Segments,
  from: Point,
  to: Point,
  rows: ReadonlySet<number>,
): Edit[] {
  const moved: Edit[] = [];
  for (let edge = 0; edge < bulge.length; edge++) {
    if (rows.size > 0 && !rows.has(edge)) continue;
    for (const end of ["start", "end"] as const) {
      const at = edge * 4 + (end === "start" ? 0 : 2);
      const before = { x: ends[at] as number, y: ends[at + 1] as number };
      if (Math.hypot(before.x - from.x, before.y - from.y) > SAME_POINT) continue;
      moved.push({ kind: "move-end", edge, end, before: pair(before), to: pair(to) });
    }
  }
  return moved;
}
