/** Shapes of drawings on a sheet: they are mirrored, turned, and moved by the corner of their box. */

import type { Placed } from "../../api/layouts";
import { boundsOf } from "../../geometry/bounds";
import type { Box, Segments } from "../../geometry/records";

/** Corners x, y, x, y … of a closed polygon (mm). */
export type Ring = readonly number[];

/** A drawing that can be placed. */
export interface DrawingShape {
  readonly name: string;
  /** Edges that are made. */
  readonly edges: Segments;
  /** Outlines of the blanks. */
  readonly outlines: readonly Ring[];
  /** Holes of the blanks. */
  readonly holes: readonly Ring[];
  /** Board of the blanks (mm²). */
  readonly area: number;
}

/** A drawing that is mirrored and turned, with the lower left corner of its box at the origin. */
export interface TurnedShape {
  readonly width: number;
  readonly height: number;
  readonly outlines: readonly Ring[];
  readonly holes: readonly Ring[];
}

/** One copy of a drawing on the sheet. */
export interface Copy {
  /** Index of its entry in the list of placed drawings. */
  readonly placed: number;
  readonly x: number;
  readonly y: number;
  readonly shape: TurnedShape;
}

export type Pose = Pick<Placed, "turn" | "mirror">;

/** Cosine and sine of an angle (°); those of quarter turns are exact. */
function turned(turn: number): readonly [number, number] {
  const quarters = (((turn / 90) % 4) + 4) % 4;
  if (quarters === 0) return [1, 0];
  if (quarters === 1) return [0, 1];
  if (quarters === 2) return [-1, 0];
  if (quarters === 3) return [0, -1];
  const angle = (turn * Math.PI) / 180;
  return [Math.cos(angle), Math.sin(angle)];
}

/** Points x, y, x, y … after they were mirrored at the Y axis and turned. */
export function turnPoints(points: ArrayLike<number>, { turn, mirror }: Pose): Float64Array {
  const [cosine, sine] = turned(turn);
  const result = new Float64Array(points.length);
  for (let at = 0; at + 1 < points.length; at += 2) {
    const x = (mirror ? -1 : 1) * (points[at] ?? 0);
    const y = points[at + 1] ?? 0;
    result[at] = x * cosine - y * sine;
    result[at + 1] = x * sine + y * cosine;
  }
  return result;
}

/** A drawing as it is placed. */
export function turnShape(drawing: DrawingShape, pose: Pose): TurnedShape {
  const bulge = pose.mirror ? drawing.edges.bulge.map((value) => -value) : drawing.edges.bulge;
  const [left, below, right, above] = boundsOf({
    ends: turnPoints(drawing.edges.ends, pose),
    bulge,
  }) ?? [0, 0, 0, 0];
  const moved = (ring: Ring): Ring =>
    Array.from(turnPoints(ring, pose), (value, at) => value - (at % 2 === 0 ? left : below));
  return {
    width: right - left,
    height: above - below,
    outlines: drawing.outlines.map(moved),
    holes: drawing.holes.map(moved),
  };
}

/** All copies of the placed drawings, row by row; drawings whose shape is not known have none. */
export function copiesOf(
  placed: readonly Placed[],
  shapeOf: (placed: Placed) => TurnedShape | undefined,
): Copy[] {
  const copies: Copy[] = [];
  for (const [index, one] of placed.entries()) {
    const shape = shapeOf(one);
    if (shape === undefined) continue;
    for (let row = 0; row < one.rows; row++)
      for (let column = 0; column < one.columns; column++)
        copies.push({
          placed: index,
          x: one.x + column * (shape.width + one.gap_x),
          y: one.y + row * (shape.height + one.gap_y),
          shape,
        });
  }
  return copies;
}

export const boxOfCopy = ({ x, y, shape }: Copy): Box => [x, y, x + shape.width, y + shape.height];

/** The box of all copies of a placed drawing. */
export function boxOfPlaced(one: Placed, shape: TurnedShape): Box {
  const width = one.columns * shape.width + (one.columns - 1) * one.gap_x;
  const height = one.rows * shape.height + (one.rows - 1) * one.gap_y;
  return [one.x, one.y, one.x + width, one.y + height];
}
