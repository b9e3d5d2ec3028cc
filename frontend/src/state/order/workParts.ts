/** The tracks of a program by parts and layers, which are moved together. */

import type { Blanks } from "../../api/layouts";
import { nearestOnArc, pointAt } from "../../geometry/arc";
import { unionBox } from "../../geometry/bounds";
import { isInside } from "../../geometry/lasso";
import type { Box, Edges, Point } from "../../geometry/records";
import {
  type BrokenRule,
  brokenBy,
  encloses,
  movedItem,
  ruleBetween,
  type WorkItem,
} from "./workOrder";

/** The tracks of a part that one operation makes. */
export interface WorkLayer {
  readonly stage: number;
  readonly items: readonly WorkItem[];
  /** Place among the layers of its line type in the part, from 1, and their number. */
  readonly place: number;
  readonly count: number;
}

/** The tracks of a blank, or those beside all blanks. */
export interface WorkPart {
  /** Number of the blank, from 1; 0 beside the blanks. */
  readonly number: number;
  readonly edges: readonly number[];
  readonly box: Box;
  readonly layers: readonly WorkLayer[];
}

/** Greatest distance from the outline of a blank at which a track still belongs to it (mm). */
const NEAR = 0.1;
/** Distance by which the lower left corners of blanks in one row may differ (mm). */
const ROW = 5;

interface Outline {
  readonly area: number;
  readonly box: Box;
  readonly points: readonly Point[];
}

/** The outlines of blanks in reading order from below: row by row, each from the left. */
function inReadingOrder({ blanks }: Blanks): readonly Outline[] {
  const low = [...blanks].sort((a, b) => (a.bounds[1] ?? 0) - (b.bounds[1] ?? 0));
  const rowOf = new Map<(typeof low)[number], number>();
  let [row, start] = [0, Number.NEGATIVE_INFINITY];
  for (const blank of low) {
    const y = blank.bounds[1] ?? 0;
    if (y > start + ROW) [row, start] = [row + 1, y];
    rowOf.set(blank, row);
  }
  low.sort(
    (a, b) => (rowOf.get(a) ?? 0) - (rowOf.get(b) ?? 0) || (a.bounds[0] ?? 0) - (b.bounds[0] ?? 0),
  );
  return low.map(({ area, bounds: [left = 0, below = 0, right = 0, above = 0], outline }) => ({
    area,
    box: [left, below, right, above],
    points: outline.map(([x = 0, y = 0]) => ({ x, y })),
  }));
}

/** Number of the blank to which each track belongs, by the edge that identifies the track. */
export function partNumbers(
  items: readonly WorkItem[],
  { ends, bulge }: Edges,
  blanks: Blanks,
): ReadonlyMap<number, number> {
  const outlines = inReadingOrder(blanks);
  const bySize = [...outlines.keys()].sort(
    (a, b) => (outlines[a]?.area ?? 0) - (outlines[b]?.area ?? 0),
  );
  const numbers = new Map<number, number>();
  for (const { edge } of items) {
    const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = ends.subarray(4 * edge, 4 * edge + 4);
    const [x, y] = pointAt(x0, y0, x1, y1, bulge[edge] ?? 0, 0.5);
    // A blank in a hole of another one is the smaller one.
    const found = bySize.find((index) => {
      const outline = outlines[index];
      return outline !== undefined && belongsTo(outline, x, y);
    });
    numbers.set(edge, found === undefined ? 0 : found + 1);
  }
  return numbers;
}

function belongsTo({ box, points }: Outline, x: number, y: number): boolean {
  if (x < box[0] - NEAR || y < box[1] - NEAR || x > box[2] + NEAR || y > box[3] + NEAR)
    return false;
  return isInside(points, x, y) || isNear(points, x, y);
}

function isNear(points: readonly Point[], x: number, y: number): boolean {
  let before = points.at(-1);
  for (const now of points) {
    if (before !== undefined) {
      const { distance } = nearestOnArc(x, y, before.x, before.y, now.x, now.y, 0);
      if (distance <= NEAR) return true;
    }
    before = now;
  }
  return false;
}

/** Whether the operations of all tracks are known, by which the list is divided into layers. */
export const hasStages = (items: readonly WorkItem[]): boolean =>
  items.every(({ stage }) => stage > 0);

/** The parts in the order in which they are finished, with their layers in working order. */
export function workParts(
  items: readonly WorkItem[],
  numbers: ReadonlyMap<number, number>,
): readonly WorkPart[] {
  const byPart = new Map<number, WorkItem[]>();
  for (const item of items) {
    const number = numbers.get(item.edge) ?? 0;
    const own = byPart.get(number) ?? [];
    own.push(item);
    // A part whose last track comes later is later.
    byPart.delete(number);
    byPart.set(number, own);
  }
  return [...byPart].map(([number, own]) => ({
    number,
    edges: own.flatMap(({ edges }) => edges),
    box: own.map(({ box }) => box).reduce(unionBox),
    layers: layersOf(own),
  }));
}

function layersOf(items: readonly WorkItem[]): readonly WorkLayer[] {
  const layers = [...byStage(items)];
  return layers.map(([stage, own]) => {
    const alike = layers.filter(([, others]) => others[0]?.type === own[0]?.type);
    const place = alike.findIndex(([other]) => other === stage) + 1;
    return { stage, items: own, place, count: alike.length };
  });
}

function byStage(items: readonly WorkItem[]): ReadonlyMap<number, WorkItem[]> {
  const stages = new Map<number, WorkItem[]>();
  for (const item of items) {
    const own = stages.get(item.stage);
    if (own === undefined) stages.set(item.stage, [item]);
    else own.push(item);
  }
  return stages;
}

const lastItem = ({ layers }: WorkPart): WorkItem | undefined => layers.at(-1)?.items.at(-1);

/** All tracks after a part has moved to another place: in each layer, the parts follow each other. */
export function movedPart(
  items: readonly WorkItem[],
  parts: readonly WorkPart[],
  from: number,
  to: number,
): readonly WorkItem[] {
  const ranks = new Map<number, number>();
  for (const [rank, part] of movedItem(parts, from, to).entries())
    for (const layer of part.layers) for (const { edge } of layer.items) ranks.set(edge, rank);
  const rankOf = ({ edge }: WorkItem): number => ranks.get(edge) ?? 0;
  return [...byStage(items).values()].flatMap((layer) =>
    layer.sort((a, b) => rankOf(a) - rankOf(b)),
  );
}

/** All tracks after one of a layer has moved to the place of another one of the layer. */
export function movedInLayer(
  items: readonly WorkItem[],
  layer: WorkLayer,
  from: number,
  to: number,
): readonly WorkItem[] {
  const own = new Set(layer.items);
  const moved = movedItem(layer.items, from, to)[Symbol.iterator]();
  return items.map((item) => (own.has(item) ? (moved.next().value ?? item) : item));
}

/** The rule that the move of a part would break: another one must be finished before it. */
export function brokenByPart(
  parts: readonly WorkPart[],
  from: number,
  to: number,
): BrokenRule<WorkPart> | null {
  return brokenBy(parts, from, to, (first, second) => {
    const [one, other] = [lastItem(first), lastItem(second)];
    return one === undefined || other === undefined ? null : ruleBetween(one, other);
  });
}

/** The rule that keeps the layers of a part in their order. */
export function brokenByLayer(
  layers: readonly WorkLayer[],
  from: number,
  to: number,
): BrokenRule<WorkLayer> | null {
  return brokenBy(layers, from, to, (first, second) => {
    const [one, other] = [first.items[0], second.items[0]];
    if (one === undefined || other === undefined) return null;
    const inside = second.items.some((outer) =>
      first.items.some((inner) => encloses(outer, inner)),
    );
    const rule = ruleBetween(one, other);
    return rule === "pieces" && inside ? "enclosed" : rule;
  });
}
