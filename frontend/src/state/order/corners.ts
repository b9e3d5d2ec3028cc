/** Corner types of a router, as a job request contains them. */

import type { CornerAt, Corners } from "../../api/jobs";
import { type Edges, lineTypeOf, type Point } from "../../geometry/records";

export const CORNER_TYPES = ["auto", "B", "C", "D"] as const;
export type CornerType = (typeof CORNER_TYPES)[number];

/** Defaults of the server. */
export const DEFAULT_CORNERS: Corners = {
  type: "auto",
  k: 0.5,
  interference: "trim",
  at: [],
};

/** Points closer than this are one corner (mm). */
const SAME_CORNER = 0.5;

/** The end of a cut that is closer to a point; null if the edge is not a cut. */
export function cornerNear(edges: Edges, row: number, to: Point): Point | null {
  if (lineTypeOf(edges.lineType[row]) !== "cut") return null;
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = edges.ends.subarray(row * 4, row * 4 + 4);
  const first = Math.hypot(x0 - to.x, y0 - to.y) <= Math.hypot(x1 - to.x, y1 - to.y);
  return first ? { x: x0, y: y0 } : { x: x1, y: y1 };
}

const isSameCorner = (one: CornerAt, { x, y }: Point) =>
  Math.hypot(one.x - x, one.y - y) <= SAME_CORNER;

/** Add a corner with a type of its own. */
export function addCorner(corners: Corners, place: Point): Corners {
  if (corners.at.some((one) => isSameCorner(one, place))) return corners;
  // A type that differs from the common one, so that the click has a visible effect.
  const type = corners.type === "C" ? "B" : "C";
  return { ...corners, at: [...corners.at, { x: place.x, y: place.y, type, k: null }] };
}

/** Set the type of a single corner; null removes it from the list. */
export function setCornerType(corners: Corners, which: number, type: CornerType | null): Corners {
  const at =
    type === null
      ? corners.at.filter((_, row) => row !== which)
      : corners.at.map((one, row) => (row === which ? { ...one, type } : one));
  return { ...corners, at };
}

/** Set k of a single corner; null for the common k. */
export function setCornerK(corners: Corners, which: number, k: number | null): Corners {
  return { ...corners, at: corners.at.map((one, row) => (row === which ? { ...one, k } : one)) };
}
