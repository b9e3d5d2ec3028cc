/** The tracks of a program in working order, and the order that a user chooses for the next one. */

import type { Job, Track } from "../../api/jobs";
import { boundsOf } from "../../geometry/bounds";
import {
  type Box,
  type Edges,
  type LineType,
  lineTypeOf,
  type Point,
} from "../../geometry/records";

/** A track, or all tracks along the same edges, as one entry of the list. */
export interface WorkItem {
  /** The edge by which the chosen order names the track. */
  readonly edge: number;
  readonly edges: readonly number[];
  readonly type: LineType;
  readonly station: number;
  /** Number of its operation, from 1; 0 if the program does not have it. */
  readonly stage: number;
  /** Start on the sheet: the head's axis (mm). */
  readonly start: Point;
  /** The track ends where it starts. */
  readonly closed: boolean;
  /** Box of the edges in the drawing. */
  readonly box: Box;
}

/** Rule of the order that stays whatever the user chooses. */
export type Rule = "types" | "tools" | "enclosed" | "pieces";

export interface BrokenRule<Kind = WorkItem> {
  readonly rule: Rule;
  /** The item that must come first, and the one after it. */
  readonly first: Kind;
  readonly second: Kind;
}

/** Greatest distance of the ends of a closed track: leads and overruns lie between them (mm). */
const CLOSED = 10;

const distance = (a: readonly [number, number], b: readonly [number, number]): number =>
  Math.hypot(a[0] - b[0], a[1] - b[1]);

/** The items of a program, in its order. Tracks along edges of earlier items only are left out. */
export function workItems(tracks: readonly Track[], edges: Edges): readonly WorkItem[] {
  const uses = new Map<number, number>();
  for (const track of tracks)
    for (const row of track.edges) uses.set(row, (uses.get(row) ?? 0) + 1);
  const listed = new Set<number>();
  const items: WorkItem[] = [];
  for (const track of tracks) {
    const fresh = track.edges.filter((row) => !listed.has(row) && row < edges.bulge.length);
    // An edge that no other track has identifies this one.
    const edge = fresh.find((row) => uses.get(row) === 1) ?? fresh[0];
    if (edge === undefined) continue;
    for (const row of track.edges) listed.add(row);
    items.push({
      edge,
      edges: track.edges,
      type: lineTypeOf(edges.lineType[edge]),
      station: track.station,
      stage: track.stage,
      start: { x: track.start[0], y: track.start[1] },
      closed: distance(track.start, track.end) < CLOSED,
      box: boundsOf(edges, track.edges) ?? [0, 0, 0, 0],
    });
  }
  return items;
}

/** The items in the chosen order: those without a place keep theirs, as in the program. */
export function inChosenOrder(
  items: readonly WorkItem[],
  order: readonly number[],
): readonly WorkItem[] {
  const places = new Map<number, number>();
  for (const [place, row] of order.entries()) if (!places.has(row)) places.set(row, place);
  const placeOf = ({ edges }: WorkItem): number =>
    Math.min(...edges.map((row) => places.get(row) ?? Number.POSITIVE_INFINITY));
  const placed = items
    .filter((item) => Number.isFinite(placeOf(item)))
    .sort((a, b) => placeOf(a) - placeOf(b));
  let next = 0;
  return items.map((item) =>
    Number.isFinite(placeOf(item)) ? (placed[next++] as WorkItem) : item,
  );
}

/** A list after one of its items has moved to another position. */
export function movedItem<Kind>(items: readonly Kind[], from: number, to: number): readonly Kind[] {
  const moved = items[from];
  if (moved === undefined) return items;
  const others = items.filter((_, at) => at !== from);
  return [...others.slice(0, to), moved, ...others.slice(to)];
}

/** The rule that a move would break; null if it breaks none that the page knows. */
export const brokenRule = (
  items: readonly WorkItem[],
  from: number,
  to: number,
): BrokenRule | null => brokenBy(items, from, to, ruleBetween);

/** The rule that a move in a list breaks; `rule` is the one by which an item precedes another. */
export function brokenBy<Kind>(
  items: readonly Kind[],
  from: number,
  to: number,
  rule: (first: Kind, second: Kind) => Rule | null,
): BrokenRule<Kind> | null {
  const moved = items[from];
  if (moved === undefined) return null;
  const passed = from < to ? items.slice(from + 1, to + 1) : items.slice(to, from).reverse();
  for (const other of passed) {
    const [first, second] = from < to ? [moved, other] : [other, moved];
    const broken = rule(first, second);
    if (broken !== null) return { rule: broken, first, second };
  }
  return null;
}

/** The rule by which one item must come before another one. */
export function ruleBetween(first: WorkItem, second: WorkItem): Rule | null {
  if (first.type !== second.type) return "types";
  if (first.station !== second.station) return "tools";
  if (first.type === "cut" && encloses(second, first)) return "enclosed";
  return first.stage === second.stage ? null : "pieces";
}

/** Whether a track goes round another one, by their boxes. */
export const encloses = (outer: WorkItem, inner: WorkItem): boolean =>
  outer.closed && isInside(inner.box, outer.box);

const isInside = (inner: Box, outer: Box): boolean =>
  outer[0] < inner[0] && outer[1] < inner[1] && inner[2] < outer[2] && inner[3] < outer[3];

/** The order that keeps the items as they are listed. */
export const orderOf = (items: readonly WorkItem[]): number[] => items.map(({ edge }) => edge);

/** The newest job with a program of a drawing, whose tracks are listed; null if there is none. */
export const newestProgram = <Kind extends Pick<Job, "program_sha256" | "created">>(
  jobs: readonly Kind[],
): Kind | null =>
  jobs
    .filter(({ program_sha256: sum }) => sum !== "")
    .reduce<Kind | null>(
      (newest, job) => (newest === null || job.created > newest.created ? job : newest),
      null,
    );

interface Mark {
  readonly at: Point;
  readonly selected: boolean;
}

/** The marks that cover no other one: selected ones first, then in their order. */
export function freeOf<Kind extends Mark>(marks: readonly Kind[], size: number): readonly Kind[] {
  const taken = new Map<string, Point[]>();
  const cellOf = ({ x, y }: Point) => [Math.floor(x / size), Math.floor(y / size)] as const;
  const isFree = ({ at }: Kind): boolean => {
    const [column, row] = cellOf(at);
    for (const i of [-1, 0, 1])
      for (const j of [-1, 0, 1])
        for (const other of taken.get(`${column + i} ${row + j}`) ?? [])
          if (Math.hypot(other.x - at.x, other.y - at.y) < size) return false;
    return true;
  };
  const sorted = [...marks].sort((a, b) => Number(b.selected) - Number(a.selected));
  return sorted.filter((mark) => {
    if (!isFree(mark)) return false;
    const name = cellOf(mark.at).join(" ");
    taken.set(name, [...(taken.get(name) ?? []), mark.at]);
    return true;
  });
}
