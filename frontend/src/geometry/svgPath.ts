/** Lines and arcs as data of an SVG path. */

import type { Segments } from "./records";

/** A line or arc from the current point of the path at (x0, y0) to (x, y). */
export function segmentData(x0: number, y0: number, x: number, y: number, bulge: number): string {
  const chord = Math.hypot(x - x0, y - y0);
  if (Math.abs(bulge) < 1e-9 || chord === 0) return `L${x} ${y}`;
  const radius = (chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge));
  return `A${radius} ${radius} 0 ${Math.abs(bulge) > 1 ? 1 : 0} ${bulge > 0 ? 1 : 0} ${x} ${y}`;
}

/** Some lines and arcs, each from its own start. */
export const pathData = ({ ends, bulge }: Segments, rows: readonly number[]): string =>
  rows
    .map((row) => {
      const [x0 = 0, y0 = 0, x = 0, y = 0] = ends.subarray(4 * row, 4 * row + 4);
      return `M${x0} ${y0}${segmentData(x0, y0, x, y, bulge[row] ?? 0)}`;
    })
    .join("");
