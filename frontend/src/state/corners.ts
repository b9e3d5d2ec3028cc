/** How a cutter goes round corners, as the order will say it. */

import type { CornerAt, Corners } from "../api/client";
import { type Edges, lineTypeOf, type Point } from "../geometry/records";

export const CORNER_TYPES = ["auto", "B", "C", "D"] as const;
export type CornerType = (typeof CORNER_TYPES)[number];

/** What the service takes where an order says nothing. */
export const LEFT_TO_THE_MACHINE: Corners = {
  type: "auto",
  k: 0.5,
  interference: "trim",
  at: [],
};

/** Two places nearer than this are one corner (mm). */
const SAME = 0.5;

/** The end of a cut that is nearer to a place; null where the edge is no cut. */
export function cornerNear(edges: Edges, row: number, to: Point): Point | null {
  if (lineTypeOf(edges.lineType[row]) !== "cut") return null;
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = edges.ends.subarray(row * 4, row * 4 + 4);
  const first = Math.hypot(x0 - to.x, y0 - to.y) <= Math.hypot(x1 - to.x, y1 - to.y);
  return first ? { x: x0, y: y0 } : { x: x1, y: y1 };
}

const isThere = (one: CornerAt, { x, y }: Point) => Math.hypot(one.x - x, one.y - y) <= SAME;

/** The choices with one for the corner at a place, which lies above an earlier one. */
export function withCorner(corners: Corners, place: Point): Corners {
  if (corners.at.some((one) => isThere(one, place))) return corners;
  // The opposite of what the others are, so that a click is seen to do something.
  const type = corners.type === "C" ? "B" : "C";
  return { ...corners, at: [...corners.at, { x: place.x, y: place.y, type, k: null }] };
}

/** The choices with another type for one of the corners; null takes it back. */
export function withType(corners: Corners, which: number, type: CornerType | null): Corners {
  const at =
    type === null
      ? corners.at.filter((_, row) => row !== which)
      : corners.at.map((one, row) => (row === which ? { ...one, type } : one));
  return { ...corners, at };
}

/** The choices with another knob for one of the corners; null for that of the others. */
export function withKnob(corners: Corners, which: number, k: number | null): Corners {
  return { ...corners, at: corners.at.map((one, row) => (row === which ? { ...one, k } : one)) };
}
