/**
 * Makes lines of the head path, the tip path and the air moves from a tool path.
 *
 * A tool path is in sheet coordinates, the canvas in drawing coordinates: the placement is
 * subtracted here.
 */

import { arcLength, flattenArc } from "../geometry/arc";
import { MOTIONS, type Motion, type Point } from "../geometry/records";
import type { Timeline } from "../geometry/timeline";
import { NO_OFFSET, type TipOffset, tipOf } from "../geometry/tip";
import { CHORD_TOLERANCE } from "./dieline";
import { DASHES, LineBuilder, type Lines, type Rgba } from "./lines";

export interface PathColours {
  readonly head: Rgba;
  readonly lead: Rgba;
  readonly tip: Rgba;
  readonly rapid: Rgba;
}

export interface PathLines {
  readonly head: Lines;
  readonly tip: Lines;
  readonly rapids: Lines;
}

const DASHED = DASHES.indexOf("dashed");
/** Step for the tip path of a swivel (degrees). */
const TURN_STEP = 5;

export function pathLines(
  line: Timeline,
  origin: Point,
  colours: PathColours,
  offsets: ReadonlyMap<number, TipOffset>,
): PathLines {
  const { clock, toolpath } = line;
  const { pose, bulge, motion, placement } = toolpath;
  const onSheet = { x: origin.x + placement[0], y: origin.y + placement[1] };
  const head = new LineBuilder(onSheet);
  const tip = new LineBuilder(onSheet);
  const rapids = new LineBuilder(onSheet);

  for (let row = 0; row < bulge.length; row++) {
    const a = row * 4;
    const x0 = pose[a] as number;
    const y0 = pose[a + 1] as number;
    const x1 = pose[a + 4] as number;
    const y1 = pose[a + 5] as number;
    const bend = bulge[row] as number;
    const kind: Motion = MOTIONS[motion[row] ?? 0] ?? "rapid";
    const start = clock[row] as number;
    const span = (clock[row + 1] as number) - start;

    const rapid = kind === "rapid";
    const into = rapid ? rapids : head;
    const colour = rapid ? colours.rapid : kind === "feed" ? colours.head : colours.lead;
    const dash = rapid ? DASHED : 0;
    const whole = arcLength(x0, y0, x1, y1, bend);
    if (whole > 0) {
      let x = x0;
      let y = y0;
      let done = 0;
      flattenArc(x0, y0, x1, y1, bend, CHORD_TOLERANCE, (nextX, nextY, fraction) => {
        into.add(x, y, nextX, nextY, colour, {
          along: whole * done,
          dash,
          from: start + span * done,
          to: start + span * fraction,
          row,
        });
        x = nextX;
        y = nextY;
        done = fraction;
      });
    }

    if (rapid) continue;
    const offset = offsets.get(toolpath.tool[row] ?? 0) ?? NO_OFFSET;
    const c0 = pose[a + 3] as number;
    const c1 = pose[a + 7] as number;
    const z = pose[a + 2] as number;
    let from = tipOf({ x: x0, y: y0, z, c: c0 }, offset);
    const turns = offset === NO_OFFSET ? 1 : Math.max(1, Math.ceil(Math.abs(c1 - c0) / TURN_STEP));
    let done = 0;
    const reach = (x: number, y: number, fraction: number) => {
      const to = tipOf({ x, y, z, c: c0 + (c1 - c0) * fraction }, offset);
      if (to.x !== from.x || to.y !== from.y) {
        tip.add(from.x, from.y, to.x, to.y, colours.tip, {
          from: start + span * done,
          to: start + span * fraction,
          row,
        });
      }
      from = to;
      done = fraction;
    };
    if (whole > 0) flattenArc(x0, y0, x1, y1, bend, CHORD_TOLERANCE, reach);
    else for (let step = 1; step <= turns; step++) reach(x1, y1, step / turns);
  }
  return { head: head.build(), tip: tip.build(), rapids: rapids.build() };
}
