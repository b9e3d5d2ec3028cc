/** The map from a drawing to a printed sheet that lies shifted, turned and scaled on the table. */

import type { Box, Point } from "./records";

/** (x, y) comes to (a x − b y + shift x, b x + a y + shift y). */
export type Similarity = readonly [a: number, b: number, x: number, y: number];

/** A point on the table as a point of the drawing. */
export const pointOnDrawing = ({ x, y }: Point, [a, b, dx, dy]: Similarity): Point => {
  const square = a * a + b * b;
  const [u, v] = [x - dx, y - dy];
  return { x: (a * u + b * v) / square, y: (a * v - b * u) / square };
};

/** The corners of a box on the table, counter-clockwise from the lower left, on the drawing. */
export const cornersOnDrawing = ([x0, y0, x1, y1]: Box, lies: Similarity): readonly Point[] =>
  [
    { x: x0, y: y0 },
    { x: x1, y: y0 },
    { x: x1, y: y1 },
    { x: x0, y: y1 },
  ].map((corner) => pointOnDrawing(corner, lies));

/** The similarity in the metadata of a tool path; null if there is none. */
export const similarityOf = (value: unknown): Similarity | null => {
  if (!Array.isArray(value) || value.length !== 4) return null;
  const [a, b, x, y] = value.map(Number);
  return [a as number, b as number, x as number, y as number];
};

/** Poses on the table (X, Y, Z, C by fours) as poses on the drawing. */
export function posesOnDrawing(pose: Float64Array, [a, b, x, y]: Similarity): Float64Array {
  const turn = (Math.atan2(b, a) * 180) / Math.PI;
  const found = pose.slice();
  for (let at = 0; at + 3 < found.length; at += 4) {
    const on = { x: pose[at] as number, y: pose[at + 1] as number };
    const drawn = pointOnDrawing(on, [a, b, x, y]);
    found[at] = drawn.x;
    found[at + 1] = drawn.y;
    found[at + 3] = (pose[at + 3] as number) - turn;
  }
  return found;
}
