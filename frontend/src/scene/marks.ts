/** Where the tool goes down, comes up and is turned: moves that a path seen from above hides. */

import { MOTIONS, type Point, type Toolpath } from "../geometry/records";
import { LineBuilder, type Lines, type Rgba } from "./lines";

export const MARKED = ["plunge", "lift", "swivel"] as const;
export type Marked = (typeof MARKED)[number];

/** A dot, a line of no length, to each such move: where it is down, or turns. */
export function motionMarks(
  { pose, motion, placement }: Toolpath,
  origin: Point,
  colours: Readonly<Record<Marked, Rgba>>,
): Record<Marked, Lines> {
  const onSheet = { x: origin.x + placement[0], y: origin.y + placement[1] };
  const dots = {
    plunge: new LineBuilder(onSheet),
    lift: new LineBuilder(onSheet),
    swivel: new LineBuilder(onSheet),
  };
  for (let row = 0; row < motion.length; row++) {
    const kind = MARKED.find((word) => word === MOTIONS[motion[row] ?? 0]);
    if (kind === undefined) continue;
    const down = (row + (kind === "plunge" ? 1 : 0)) * 4;
    const x = pose[down] as number;
    const y = pose[down + 1] as number;
    dots[kind].add(x, y, x, y, colours[kind], { row });
  }
  return { plunge: dots.plunge.done(), lift: dots.lift.done(), swivel: dots.swivel.done() };
}
