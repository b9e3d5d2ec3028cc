/** The moves of a tool path as lines and arcs in drawing coordinates, for picking. */

import type { Segments, Toolpath } from "./records";

export function moveSegments({ pose, bulge, placement }: Toolpath): Segments {
  const ends = new Float64Array(bulge.length * 4);
  for (let row = 0; row < bulge.length; row++) {
    const a = row * 4;
    ends[a] = (pose[a] as number) - placement[0];
    ends[a + 1] = (pose[a + 1] as number) - placement[1];
    ends[a + 2] = (pose[a + 4] as number) - placement[0];
    ends[a + 3] = (pose[a + 5] as number) - placement[1];
  }
  return { ends, bulge };
}
