/** The work of a tool path as data of SVG paths: what is made at a time, and what is left. */

import type { Toolpath } from "./records";
import { segmentData } from "./svgPath";

/** Motion of a move above the board. */
const RAPID = 0;
/** Parts of the work, each with the row of its move, in the order of the program. */
export interface WorkPath {
  readonly rows: readonly number[];
  readonly parts: readonly string[];
}

/** The moves of the head in the board. */
export function workPath({ pose, bulge, motion }: Toolpath): WorkPath {
  const rows: number[] = [];
  const parts: string[] = [];
  for (let row = 0; row < motion.length; row++) {
    if (motion[row] === RAPID) continue;
    const [x0 = 0, y0 = 0] = pose.subarray(4 * row, 4 * row + 2);
    const [x = 0, y = 0] = pose.subarray(4 * row + 4, 4 * row + 6);
    rows.push(row);
    parts.push(`M${x0} ${y0}${segmentData(x0, y0, x, y, bulge[row] ?? 0)}`);
  }
  return { rows, parts };
}

/** Data of the moves before a row, and of the others; the move of the row itself is left. */
export function splitWork({ rows, parts }: WorkPath, row: number): readonly [string, string] {
  const next = rows.findIndex((one) => one >= row);
  const at = next < 0 ? rows.length : next;
  return [parts.slice(0, at).join(""), parts.slice(at).join("")];
}
