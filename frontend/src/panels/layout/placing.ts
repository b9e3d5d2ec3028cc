/** Changes of placed drawings: move, snap, align, repeat; and the history of changes. */

import type { LayoutSheet, Placed } from "../../api/layouts";
import type { Box } from "../../geometry/records";

/** What is edited. */
export interface Draft {
  readonly sheet: LayoutSheet;
  readonly placed: readonly Placed[];
}

/** A draft with the drafts before it, and those that were undone. */
export interface History {
  readonly past: readonly Draft[];
  readonly present: Draft;
  readonly future: readonly Draft[];
}

/** What a new sheet has apart from its size. */
export const NEW_SHEET = {
  grain: null,
  side_up: "outside",
  board: "",
  gap: 5,
  margin: 10,
} as const satisfies Omit<LayoutSheet, "width" | "height">;

const MOST_STEPS = 200;
/** Decimals of places (mm). */
const DECIMALS = 1000;

export const round = (value: number): number => Math.round(value * DECIMALS) / DECIMALS;

export const begin = (present: Draft): History => ({ past: [], present, future: [] });

/** Record a new draft; one that is `joined` replaces the present one, as while a copy is dragged. */
export function record(history: History, present: Draft, joined = false): History {
  if (joined) return { ...history, present, future: [] };
  return {
    past: [...history.past, history.present].slice(-MOST_STEPS),
    present,
    future: [],
  };
}

export function undo({ past, present, future }: History): History {
  const before = past.at(-1);
  if (before === undefined) return { past, present, future };
  return { past: past.slice(0, -1), present: before, future: [present, ...future] };
}

export function redo({ past, present, future }: History): History {
  const [next, ...rest] = future;
  if (next === undefined) return { past, present, future };
  return { past: [...past, present], present: next, future: rest };
}

/** A draft with changed fields of the chosen drawings. */
export const change = (
  draft: Draft,
  chosen: ReadonlySet<number>,
  fields: (placed: Placed) => Partial<Placed>,
): Draft => ({
  ...draft,
  placed: draft.placed.map((one, index) => (chosen.has(index) ? { ...one, ...fields(one) } : one)),
});

/** A turn in the range of the server (°). */
export const normalTurn = (turn: number): number => ((turn % 360) + 360) % 360;

export const ALIGNMENTS = ["left", "right", "below", "above", "centreX", "centreY"] as const;
export type Alignment = (typeof ALIGNMENTS)[number];

/** How far a box must move to lie in a frame as aligned (mm). */
export function alignShift(box: Box, frame: Box, alignment: Alignment): readonly [number, number] {
  switch (alignment) {
    case "left":
      return [frame[0] - box[0], 0];
    case "right":
      return [frame[2] - box[2], 0];
    case "below":
      return [0, frame[1] - box[1]];
    case "above":
      return [0, frame[3] - box[3]];
    case "centreX":
      return [(frame[0] + frame[2] - box[0] - box[2]) / 2, 0];
    case "centreY":
      return [0, (frame[1] + frame[3] - box[1] - box[3]) / 2];
  }
}

/** Move a box to the nearest sides of others within a reach, and beside them with a gap. */
export function snapShift(
  box: Box,
  others: readonly Box[],
  gap: number,
  reach: number,
): readonly [number, number] {
  const best: [number, number] = [reach, reach];
  const found: [number, number] = [0, 0];
  for (const other of others)
    for (const axis of [0, 1] as const) {
      const [low, high] = [box[axis], box[axis + 2] ?? 0];
      const [from, to] = [other[axis], other[axis + 2] ?? 0];
      for (const shift of [from - low, to - high, to + gap - low, from - gap - high])
        if (Math.abs(shift) < best[axis]) {
          best[axis] = Math.abs(shift);
          found[axis] = shift;
        }
    }
  return found;
}

/** The most rows and columns of a box that fit on a sheet, from its present place. */
export function mostCopies(
  one: Placed,
  size: { readonly width: number; readonly height: number },
  sheet: { readonly width: number; readonly height: number },
): { columns: number; rows: number } {
  const most = (from: number, length: number, gap: number, end: number) =>
    Math.max(1, Math.min(200, Math.floor((end - from + gap + 1e-6) / (length + gap))));
  return {
    columns: most(one.x, size.width, one.gap_x, sheet.width),
    rows: most(one.y, size.height, one.gap_y, sheet.height),
  };
}

/** One copy of a drawing at the lower left corner of the sheet. */
export const atOrigin = (drawing: string): Placed => ({
  ...{ drawing, revision: null, x: 0, y: 0, turn: 0, mirror: false },
  ...{ columns: 1, rows: 1, gap_x: NEW_SHEET.gap, gap_y: NEW_SHEET.gap },
});
