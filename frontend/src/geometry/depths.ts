/** Working depth of each station. */

import { MOTIONS, type Toolpath } from "./records";

const FEED = MOTIONS.indexOf("feed");
const PLUNGE = MOTIONS.indexOf("plunge");

/** Lowest Z of the feeds and plunges of each station (mm), by station number. */
export function deepestZ({ motion, tool, pose }: Toolpath): Map<number, number> {
  const found = new Map<number, number>();
  for (let row = 0; row < motion.length; row++) {
    if (motion[row] !== FEED && motion[row] !== PLUNGE) continue;
    const station = tool[row] as number;
    const z = pose[row * 4 + 6] as number;
    found.set(station, Math.min(z, found.get(station) ?? z));
  }
  return found;
}
