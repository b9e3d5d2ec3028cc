/** Marks of plunges, lifts and swivels, which are not visible in a plan view of the path. */

import { MOTIONS, type Point, type Toolpath } from "../geometry/records";
import { LineBuilder, type Lines, type Rgba } from "./lines";

export const MARKED = ["plunge", "lift", "swivel"] as const;
export type Marked = (typeof MARKED)[number];

/** One dot (a line without length) per plunge, lift and swivel. */
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
  return { plunge: dots.plunge.build(), lift: dots.lift.build(), swivel: dots.swivel.build() };
}
