/**
 * Arcs as bulges: a chord and tan(sweep / 4), positive to the left, 0 a straight line.
 *
 * Conventions as in `geometry/arc.py` of the backend. Each function handles one segment.
 */

import type { Millimetre } from "./units";

/** A smaller bulge counts as a line: it bends a chord of 1 m by less than 1 nm. */
const STRAIGHT = 1e-12;

/** Maximum number of chords of an arc. */
const MAX_CHORDS = 720;

export interface Circle {
  readonly x: number;
  readonly y: number;
  readonly radius: number;
  /** Angle of the start about the centre (radians). */
  readonly first: number;
  /** Angle of travel, counter-clockwise positive (radians). */
  readonly sweep: number;
}

/** The circle that an arc is part of; null for a line. */
export function circleOf(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  bulge: number,
): Circle | null {
  const dx = x1 - x0;
  const dy = y1 - y0;
  const chord = Math.hypot(dx, dy);
  if (Math.abs(bulge) < STRAIGHT || chord === 0) return null;
  const apothem = (1 - bulge * bulge) / (4 * bulge);
  const x = (x0 + x1) / 2 - dy * apothem;
  const y = (y0 + y1) / 2 + dx * apothem;
  return {
    x,
    y,
    radius: (chord * (1 + bulge * bulge)) / (4 * Math.abs(bulge)),
    first: Math.atan2(y0 - y, x0 - x),
    sweep: 4 * Math.atan(bulge),
  };
}

/** Number of chords that approximate an arc within `tolerance`. */
export function chordCount(radius: number, sweep: number, tolerance: Millimetre): number {
  if (radius <= tolerance) return Math.max(3, Math.ceil(Math.abs(sweep)));
  // The sagitta of a chord over the angle φ is r (1 - cos φ/2).
  const widest = 2 * Math.acos(1 - tolerance / radius);
  return Math.min(MAX_CHORDS, Math.max(1, Math.ceil(Math.abs(sweep) / widest)));
}

/**
 * Visit the vertices of a line or arc after its start, the end last and exact.
 *
 * `fraction` is the fraction of the length from the start to that vertex, in (0, 1].
 */
export function flattenArc(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  bulge: number,
  tolerance: Millimetre,
  visit: (x: number, y: number, fraction: number) => void,
): void {
  const round = circleOf(x0, y0, x1, y1, bulge);
  if (round !== null) {
    const count = chordCount(round.radius, round.sweep, tolerance);
    for (let step = 1; step < count; step++) {
      const angle = round.first + (round.sweep * step) / count;
      visit(
        round.x + round.radius * Math.cos(angle),
        round.y + round.radius * Math.sin(angle),
        step / count,
      );
    }
  }
  visit(x1, y1, 1);
}

/** Length travelled a line or arc (mm). */
export function arcLength(x0: number, y0: number, x1: number, y1: number, bulge: number): number {
  const round = circleOf(x0, y0, x1, y1, bulge);
  return round === null ? Math.hypot(x1 - x0, y1 - y0) : round.radius * Math.abs(round.sweep);
}

/** The point at a fraction of the length. */
export function pointAt(
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  bulge: number,
  fraction: number,
): [number, number] {
  const round = circleOf(x0, y0, x1, y1, bulge);
  if (round === null) return [x0 + (x1 - x0) * fraction, y0 + (y1 - y0) * fraction];
  const angle = round.first + round.sweep * fraction;
  return [round.x + round.radius * Math.cos(angle), round.y + round.radius * Math.sin(angle)];
}

/** Bulge of a part of a line or arc with this fraction of its length. */
export const partialBulge = (bulge: number, share: number): number =>
  Math.tan(Math.atan(bulge) * share);

/** Distance (mm) of a point from a line or arc, and its nearest point as a fraction of length. */
export function nearestOnArc(
  x: number,
  y: number,
  x0: number,
  y0: number,
  x1: number,
  y1: number,
  bulge: number,
): { distance: number; fraction: number } {
  const round = circleOf(x0, y0, x1, y1, bulge);
  let fraction: number;
  if (round === null) {
    const dx = x1 - x0;
    const dy = y1 - y0;
    const square = dx * dx + dy * dy;
    fraction = square === 0 ? 0 : ((x - x0) * dx + (y - y0) * dy) / square;
    fraction = Math.min(1, Math.max(0, fraction));
  } else {
    const turn = 2 * Math.PI;
    const angle = Math.atan2(y - round.y, x - round.x) - round.first;
    const travelled = (((round.sweep > 0 ? angle : -angle) % turn) + turn) % turn;
    const sweep = Math.abs(round.sweep);
    if (travelled <= sweep) fraction = travelled / sweep;
    // The point is beyond the ends: take the nearer end.
    else fraction = travelled - sweep < (turn - sweep) / 2 ? 1 : 0;
  }
  const [px, py] = pointAt(x0, y0, x1, y1, bulge, fraction);
  return { distance: Math.hypot(x - px, y - py), fraction };
}
