/** The map from a drawing to a printed sheet that lies shifted, turned and scaled on the table. */

/** (x, y) comes to (a x − b y + shift x, b x + a y + shift y). */
export type Similarity = readonly [a: number, b: number, x: number, y: number];

/** The similarity in the metadata of a tool path; null if there is none. */
export const similarityOf = (value: unknown): Similarity | null => {
  if (!Array.isArray(value) || value.length !== 4) return null;
  const [a, b, x, y] = value.map(Number);
  return [a as number, b as number, x as number, y as number];
};

/** Poses on the table (X, Y, Z, C by fours) as poses on the drawing. */
export function posesOnDrawing(pose: Float64Array, [a, b, x, y]: Similarity): Float64Array {
  const square = a * a + b * b;
  const turn = (Math.atan2(b, a) * 180) / Math.PI;
  const found = pose.slice();
  for (let at = 0; at + 3 < found.length; at += 4) {
    const u = (pose[at] as number) - x;
    const v = (pose[at + 1] as number) - y;
    found[at] = (a * u + b * v) / square;
    found[at + 1] = (a * v - b * u) / square;
    found[at + 3] = (pose[at + 3] as number) - turn;
  }
  return found;
}
