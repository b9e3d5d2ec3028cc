/**
 * Makes the area that each tool cuts or presses, in plan view, from tool path and tools.
 *
 *     cutter, beam   the disc that removes material, along every move that cuts
 *     V-cutter       on each pass one flank, h tan θ wide at the top face: both make the groove
 *     crease wheel   the rim over the length that it touches, with a mark where that ends
 */

import { circleOf, flattenArc } from "../geometry/arc";
import { MOTIONS, type Motion, type Point, type Toolpath } from "../geometry/records";
import { halfContactLength, type Sweep } from "../geometry/sweep";
import { NO_OFFSET, type TipOffset, tipOf } from "../geometry/tip";
import { degree, mm, radians } from "../geometry/units";
import { LineBuilder, type Lines, type Rgba } from "./lines";

/** Triangles for display, float32 relative to an origin. */
export interface Bands {
  /** number of triangles */
  readonly count: number;
  /** (m, 3, 2) mm */
  readonly corners: Float32Array;
  /** (m, 3, 4) */
  readonly colour: Uint8Array;
}

export interface SweptColours {
  readonly cutter: Rgba;
  readonly groove: Rgba;
  readonly crease: Rgba;
  /** Colour of the marks at the ends of a wheel's contact. */
  readonly groovesRim: Rgba;
  readonly contact: Rgba;
}

export interface Swept {
  readonly bands: Bands;
  readonly rims: Lines;
}

/** The tools of the stations, by number. */
export interface Tools {
  readonly sweeps: ReadonlyMap<number, Sweep>;
  readonly offsets: ReadonlyMap<number, TipOffset>;
  /** Thickness of the board (mm): Z of its top face. */
  readonly caliper: number;
}

/** Greatest distance of a chord from the rim of a disc (mm). */
const CHORD_TOLERANCE = mm(0.02);
/** Cosine of the largest turn between moves that continue straight. */
const STRAIGHT_COSINE = 0.9999;
/** Minimum half length of the mark across the end of a crease (mm). */
const TICK = 1.2;

const CUTTING: ReadonlySet<Motion> = new Set(["lead-in", "feed", "lead-out"]);

type Pair = readonly [number, number];

class BandBuilder {
  private readonly corners: number[] = [];
  private readonly colour: number[] = [];

  constructor(private readonly origin: Point) {}

  triangle(a: Pair, b: Pair, c: Pair, colour: Rgba): void {
    const { x, y } = this.origin;
    this.corners.push(a[0] - x, a[1] - y, b[0] - x, b[1] - y, c[0] - x, c[1] - y);
    this.colour.push(...colour, ...colour, ...colour);
  }

  quad(a: Pair, b: Pair, c: Pair, d: Pair, colour: Rgba): void {
    this.triangle(a, b, c, colour);
    this.triangle(a, c, d, colour);
  }

  disc([x, y]: Pair, radius: number, colour: Rgba): void {
    const widest = 2 * Math.acos(1 - Math.min(1, CHORD_TOLERANCE / radius));
    const count = Math.min(96, Math.max(12, Math.ceil((2 * Math.PI) / widest)));
    const rim = (step: number): Pair => {
      const angle = (2 * Math.PI * step) / count;
      return [x + radius * Math.cos(angle), y + radius * Math.sin(angle)];
    };
    for (let step = 0; step < count; step++)
      this.triangle([x, y], rim(step), rim(step + 1), colour);
  }

  build(): Bands {
    return {
      count: this.corners.length / 6,
      corners: Float32Array.from(this.corners),
      colour: Uint8Array.from(this.colour),
    };
  }
}

export function sweptShapes(
  toolpath: Toolpath,
  origin: Point,
  { sweeps, offsets, caliper }: Tools,
  colours: SweptColours,
): Swept {
  const { motion, tool, placement } = toolpath;
  const onSheet = { x: origin.x + placement[0], y: origin.y + placement[1] };
  const bands = new BandBuilder(onSheet);
  const rims = new LineBuilder(onSheet);
  for (let row = 0; row < motion.length; row++) {
    const station = tool[row] ?? 0;
    const sweep = sweeps.get(station);
    const kind = MOTIONS[motion[row] ?? 0] ?? "rapid";
    if (sweep === undefined) continue;
    const move = moveAt(toolpath, row);
    const depth = [caliper - move.z0, caliper - move.z1] as const;
    if (sweep.kind === "disc" && CUTTING.has(kind) && (sweep.anyHeight || Math.min(...depth) > 0)) {
      addDisc(bands, toolpath, row, sweep.radius, colours.cutter);
    } else if (sweep.kind === "groove" && kind === "feed" && Math.max(...depth) > 0) {
      const offset = offsets.get(station) ?? NO_OFFSET;
      addGroove(bands, rims, move, depth, sweep, offset, colours);
    } else if (sweep.kind === "wheel" && depth[1] > 0) {
      const pressed = kind === "plunge" && MOTIONS[motion[row + 1] ?? 0] === "lift";
      if (kind === "feed" || pressed)
        addCrease(bands, rims, toolpath, row, depth[1], sweep, colours);
    }
  }
  return { bands: bands.build(), rims: rims.build() };
}

interface Move {
  readonly x0: number;
  readonly y0: number;
  readonly z0: number;
  readonly c0: number;
  readonly x1: number;
  readonly y1: number;
  readonly z1: number;
  readonly c1: number;
  readonly bulge: number;
}

function moveAt({ pose, bulge }: Toolpath, row: number): Move {
  const a = row * 4;
  return {
    x0: pose[a] as number,
    y0: pose[a + 1] as number,
    z0: pose[a + 2] as number,
    c0: pose[a + 3] as number,
    x1: pose[a + 4] as number,
    y1: pose[a + 5] as number,
    z1: pose[a + 6] as number,
    c1: pose[a + 7] as number,
    bulge: bulge[row] as number,
  };
}

/** Unit tangents at the ends of a move; the direction of C for a move without length. */
function tangents({ x0, y0, x1, y1, c1, bulge }: Move): { first: Pair; last: Pair } {
  const chord = Math.hypot(x1 - x0, y1 - y0);
  if (chord < 1e-9) {
    const angle = radians(degree(c1));
    const ahead: Pair = [Math.cos(angle), Math.sin(angle)];
    return { first: ahead, last: ahead };
  }
  const angle = Math.atan2(y1 - y0, x1 - x0);
  const half = 2 * Math.atan(bulge);
  return {
    first: [Math.cos(angle - half), Math.sin(angle - half)],
    last: [Math.cos(angle + half), Math.sin(angle + half)],
  };
}

/** Whether the next move is of the same tool and continues in the same direction. */
function continuesStraight(
  toolpath: Toolpath,
  row: number,
  makes: (kind: Motion) => boolean,
): boolean {
  const { motion, tool, bulge } = toolpath;
  if (row < 0 || row + 1 >= bulge.length || tool[row] !== tool[row + 1]) return false;
  const both = [row, row + 1].every((at) => makes(MOTIONS[motion[at] ?? 0] ?? "rapid"));
  if (!both) return false;
  const { last } = tangents(moveAt(toolpath, row));
  const { first } = tangents(moveAt(toolpath, row + 1));
  return last[0] * first[0] + last[1] * first[1] > STRAIGHT_COSINE;
}

/** Add a strip along a move. */
function addStrip(bands: BandBuilder, move: Move, half: number, colour: Rgba): void {
  const { x0, y0, x1, y1, bulge } = move;
  const chord = Math.hypot(x1 - x0, y1 - y0);
  if (chord === 0) return;
  const round = circleOf(x0, y0, x1, y1, bulge);
  const across = (x: number, y: number): Pair => {
    if (round === null) return [(y0 - y1) / chord, (x1 - x0) / chord];
    return [(x - round.x) / round.radius, (y - round.y) / round.radius];
  };
  let before: Pair = [x0, y0];
  flattenArc(x0, y0, x1, y1, bulge, CHORD_TOLERANCE, (x, y) => {
    const a = across(...before);
    const b = across(x, y);
    bands.quad(
      [before[0] + a[0] * half, before[1] + a[1] * half],
      [x + b[0] * half, y + b[1] * half],
      [x - b[0] * half, y - b[1] * half],
      [before[0] - a[0] * half, before[1] - a[1] * half],
      colour,
    );
    before = [x, y];
  });
}

function addDisc(
  bands: BandBuilder,
  toolpath: Toolpath,
  row: number,
  radius: number,
  colour: Rgba,
): void {
  const move = moveAt(toolpath, row);
  const cuts = (kind: Motion) => CUTTING.has(kind);
  addStrip(bands, move, radius, colour);
  if (!continuesStraight(toolpath, row - 1, cuts)) bands.disc([move.x0, move.y0], radius, colour);
  if (!continuesStraight(toolpath, row, cuts)) bands.disc([move.x1, move.y1], radius, colour);
}

function addGroove(
  bands: BandBuilder,
  rims: LineBuilder,
  { x0, y0, z0, c0, x1, y1, z1, c1 }: Move,
  depth: Pair,
  { slope, blade }: Extract<Sweep, { kind: "groove" }>,
  offset: TipOffset,
  colours: SweptColours,
): void {
  const from = tipOf({ x: x0, y: y0, z: z0, c: c0 }, offset);
  const to = tipOf({ x: x1, y: y1, z: z1, c: c1 }, offset);
  const c = radians(degree(c1));
  const ahead: Pair = [Math.cos(c), Math.sin(c)];
  const right: Pair = [ahead[1], -ahead[0]];
  const [wide0, wide1] = [Math.max(0, depth[0]) * slope, Math.max(0, depth[1]) * slope];
  // The blade's edge reaches ahead of the tip: the flank ends that much behind the line's end.
  const end: Pair = [to.x + ahead[0] * blade, to.y + ahead[1] * blade];
  const rim0: Pair = [from.x + right[0] * wide0, from.y + right[1] * wide0];
  const rim1: Pair = [end[0] + right[0] * wide1, end[1] + right[1] * wide1];
  bands.quad([from.x, from.y], end, rim1, rim0, colours.groove);
  rims.add(...rim0, ...rim1, colours.groovesRim);
}

function addCrease(
  bands: BandBuilder,
  rims: LineBuilder,
  toolpath: Toolpath,
  row: number,
  depth: number,
  { radius, width }: Extract<Sweep, { kind: "wheel" }>,
  colours: SweptColours,
): void {
  const move = moveAt(toolpath, row);
  const reach = halfContactLength(radius, depth);
  const creases = (kind: Motion) => kind === "feed";
  const { first, last } = tangents(move);
  addStrip(bands, move, width / 2, colours.crease);
  const end = (x: number, y: number, [ux, uy]: Pair) => {
    const [ex, ey] = [x + ux * reach, y + uy * reach];
    const [px, py] = [(-uy * width) / 2, (ux * width) / 2];
    bands.quad(
      [x + px, y + py],
      [ex + px, ey + py],
      [ex - px, ey - py],
      [x - px, y - py],
      colours.crease,
    );
    const tick = Math.max(TICK, width);
    rims.add(ex - uy * tick, ey + ux * tick, ex + uy * tick, ey - ux * tick, colours.contact);
  };
  if (!continuesStraight(toolpath, row - 1, creases)) end(move.x0, move.y0, [-first[0], -first[1]]);
  if (!continuesStraight(toolpath, row, creases)) end(move.x1, move.y1, last);
}
