/** Lines around the drawing: grid, table, datum, marks and the head. */

import type { Box, Point, Pose } from "../geometry/records";
import { type TipOffset, tipOf } from "../geometry/tip";
import { degree, radians } from "../geometry/units";
import { LineBuilder, type Lines, type Rgba } from "./lines";

/** Minimum distance of grid lines (pixels). */
const MIN_GRID_PIXELS = 9;

/** Step of the grid (mm): the smallest power of ten at least `MIN_GRID_PIXELS` wide. */
export function gridStep(pixelsPerMm: number): number {
  return 10 ** Math.ceil(Math.log10(MIN_GRID_PIXELS / pixelsPerMm));
}

/** Grid lines across a box; every tenth line is stronger. */
export function gridLines(
  box: Box,
  origin: Point,
  pixelsPerMm: number,
  minor: Rgba,
  major: Rgba,
): Lines {
  const step = gridStep(pixelsPerMm);
  // Fade in the finer lines while zooming in.
  const near = Math.min(
    1,
    Math.max(0, (step * pixelsPerMm - MIN_GRID_PIXELS) / (MIN_GRID_PIXELS * 4)),
  );
  const faint: Rgba = [minor[0], minor[1], minor[2], minor[3] * near];
  const lines = new LineBuilder(origin);
  const stroke = (index: number) => (index % 10 === 0 ? major : faint);
  for (let index = Math.ceil(box[0] / step); index * step <= box[2]; index++) {
    lines.add(index * step, box[1], index * step, box[3], stroke(index));
  }
  for (let index = Math.ceil(box[1] / step); index * step <= box[3]; index++) {
    lines.add(box[0], index * step, box[2], index * step, stroke(index));
  }
  return lines.build();
}

/** Outline of a rectangle between two corners. */
export function frameLines(corners: readonly Point[], origin: Point, colour: Rgba): Lines {
  const lines = new LineBuilder(origin);
  addOutline(lines, corners, colour);
  return lines.build();
}

/** Keep-out zones: the outline of each rectangle, with slanted lines across it. */
export function zoneLines(
  zones: readonly (readonly Point[])[],
  origin: Point,
  colour: Rgba,
): Lines {
  const lines = new LineBuilder(origin);
  for (const corners of zones) {
    addOutline(lines, corners, colour);
    addHatch(lines, corners, colour);
  }
  return lines.build();
}

/** Number of slanted lines across a zone. */
const HATCHES = 8;

/** Lines at 45° across a rectangle, at equal distances. */
function addHatch(lines: LineBuilder, corners: readonly Point[], colour: Rgba) {
  const [first, second, , last] = corners;
  if (first === undefined || second === undefined || last === undefined) return;
  const [width, height] = [distance(first, second), distance(first, last)];
  const at = (along: number, up: number): readonly [number, number] => [
    first.x + ((second.x - first.x) * along) / width + ((last.x - first.x) * up) / height,
    first.y + ((second.y - first.y) * along) / width + ((last.y - first.y) * up) / height,
  ];
  for (let index = 1; index < HATCHES; index++) {
    // The line x + y = constant, from the lower or right side to the left or upper side.
    const sum = ((width + height) * index) / HATCHES;
    const low = Math.max(0, sum - width);
    const high = Math.min(height, sum);
    lines.add(...at(sum - low, low), ...at(sum - high, high), colour);
  }
}

const distance = (a: Point, b: Point): number => Math.hypot(b.x - a.x, b.y - a.y);

function addOutline(lines: LineBuilder, corners: readonly Point[], colour: Rgba) {
  for (const [at, { x, y }] of corners.entries()) {
    const next = corners[(at + 1) % corners.length] as Point;
    lines.add(x, y, next.x, next.y, colour);
  }
}

function addFrame(lines: LineBuilder, [x0, y0, x1, y1]: Box, colour: Rgba) {
  lines.add(x0, y0, x1, y0, colour);
  lines.add(x1, y0, x1, y1, colour);
  lines.add(x1, y1, x0, y1, colour);
  lines.add(x0, y1, x0, y0, colour);
}

/** The X and Y axis of a table at its first corner; `arm` in mm. */
export function datumLines(
  corners: readonly Point[],
  origin: Point,
  arm: number,
  x: Rgba,
  y: Rgba,
): Lines {
  const lines = new LineBuilder(origin);
  const [datum, alongX, , alongY] = corners;
  if (datum === undefined) return lines.build();
  for (const [end, colour] of [
    [alongX, x],
    [alongY, y],
  ] as const) {
    if (end === undefined) continue;
    const share = arm / distance(datum, end);
    const [dx, dy] = [(end.x - datum.x) * share, (end.y - datum.y) * share];
    lines.add(datum.x, datum.y, datum.x + dx, datum.y + dy, colour);
  }
  return lines.build();
}

/** Rings about points of the drawing. */
export function ringLines(
  places: readonly Point[],
  origin: Point,
  radius: number,
  colour: Rgba,
): Lines {
  const lines = new LineBuilder(origin);
  for (const { x, y } of places) addRing(lines, x, y, radius, colour);
  return lines.build();
}

/** Sizes of a pin (pixels): radius of the ring, length of the arms, distance of the frame. */
const PIN = { ring: 12, arm: 9, gap: 4 };

/** Pin: a ring about a small box, or a frame about a larger one, with four arms. */
export function pinLines(box: Box, origin: Point, mmPerPixel: number, colour: Rgba): Lines {
  const lines = new LineBuilder(origin);
  const [x, y] = [(box[0] + box[2]) / 2, (box[1] + box[3]) / 2];
  const ring = PIN.ring * mmPerPixel;
  const arm = PIN.arm * mmPerPixel;
  let [wide, high] = [(box[2] - box[0]) / 2, (box[3] - box[1]) / 2];
  if (Math.max(wide, high) <= ring) {
    wide = high = ring;
    addRing(lines, x, y, ring, colour);
  } else {
    wide += PIN.gap * mmPerPixel;
    high += PIN.gap * mmPerPixel;
    addFrame(lines, [x - wide, y - high, x + wide, y + high], colour);
  }
  lines.add(x + wide, y, x + wide + arm, y, colour);
  lines.add(x - wide, y, x - wide - arm, y, colour);
  lines.add(x, y + high, x, y + high + arm, colour);
  lines.add(x, y - high, x, y - high - arm, colour);
  return lines.build();
}

const RING = 40;

function addRing(lines: LineBuilder, x: number, y: number, radius: number, colour: Rgba) {
  for (let step = 0; step < RING; step++) {
    const a = (2 * Math.PI * step) / RING;
    const b = (2 * Math.PI * (step + 1)) / RING;
    lines.add(
      x + radius * Math.cos(a),
      y + radius * Math.sin(a),
      x + radius * Math.cos(b),
      y + radius * Math.sin(b),
      colour,
    );
  }
}

/**
 * Marker of the head: a ring about its axis, an arrow along C, and the tip.
 *
 * Ring and arrow have a fixed size on the screen; tip and blade are to scale.
 */
export function headLines(
  pose: Pose,
  offset: TipOffset,
  origin: Point,
  mmPerPixel: number,
  colour: Rgba,
  blade: Rgba,
): Lines {
  const lines = new LineBuilder(origin);
  const c = radians(degree(pose.c));
  const ahead = { x: Math.cos(c), y: Math.sin(c) };
  const left = { x: -ahead.y, y: ahead.x };
  addRing(lines, pose.x, pose.y, 10 * mmPerPixel, colour);
  const point = (forward: number, sideways: number): [number, number] => [
    pose.x + (ahead.x * forward + left.x * sideways) * mmPerPixel,
    pose.y + (ahead.y * forward + left.y * sideways) * mmPerPixel,
  ];
  lines.add(...point(0, 0), ...point(26, 0), colour);
  lines.add(...point(26, 0), ...point(19, 4.5), colour);
  lines.add(...point(26, 0), ...point(19, -4.5), colour);
  lines.add(...point(0, -4), ...point(0, 4), colour);

  const tip = tipOf(pose, offset);
  if (offset.left !== 0 || offset.behind !== 0) {
    lines.add(pose.x, pose.y, tip.x, tip.y, [blade[0], blade[1], blade[2], 120]);
  }
  if (offset.blade > 0) {
    const back = { x: tip.x + ahead.x * offset.blade, y: tip.y + ahead.y * offset.blade };
    lines.add(tip.x, tip.y, back.x, back.y, blade);
  }
  const dot = 2.5 * mmPerPixel;
  lines.add(tip.x - dot, tip.y, tip.x + dot, tip.y, blade);
  lines.add(tip.x, tip.y - dot, tip.x, tip.y + dot, blade);
  return lines.build();
}
