/**
 * Graphics over the canvas that follow the view without being painted anew.
 *
 * Each is placed at whole pixels by a transform, and drawn relative to that place. A view that is
 * panned then changes the transform only, so the browser moves the painted layer.
 */

import type { Point } from "../../geometry/records";

const hundredths = (value: number): number => Math.round(value * 100) / 100;

export interface Anchor {
  readonly transform: string;
  /** The pixel of a place, relative to the anchor; rounded, so that it is the same after a pan. */
  local(pixel: Point): Point;
}

/** Anchor at the whole pixel nearest to a pixel of the canvas. */
export function anchorAt(pixel: Point): Anchor {
  const [left, top] = [Math.round(pixel.x), Math.round(pixel.y)];
  return {
    transform: `translate(${left}px, ${top}px)`,
    local: ({ x, y }) => ({ x: hundredths(x - left), y: hundredths(y - top) }),
  };
}
