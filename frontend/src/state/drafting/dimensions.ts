/**
 * Dimensions on the canvas: whether they are shown, and measurements that the user keeps.
 *
 * Kept measurements belong to the view of a drawing: they are stored in this browser, not in the
 * drawing.
 */

import { create } from "zustand";
import type { Point } from "../../geometry/records";

/** A distance between two points of the drawing (mm). */
export interface Dimension {
  readonly from: Point;
  readonly to: Point;
}

interface Dimensions {
  readonly shown: boolean;
  /** By drawing, that which was changed last at the end. */
  readonly kept: ReadonlyMap<string, readonly Dimension[]>;
  toggle(): void;
  keep(drawing: string, dimension: Dimension): void;
  remove(drawing: string, dimension: Dimension): void;
}

/** Drawings whose dimensions are stored at most, and dimensions of each. */
const MAX_DRAWINGS = 50;
const MAX_KEPT = 100;
const KEY = "knifetip.dimensions";

export const dimensionKey = ({ from, to }: Dimension): string =>
  [from.x, from.y, to.x, to.y].join(" ");

const isNumber = (value: unknown): value is number =>
  typeof value === "number" && Number.isFinite(value);

function dimensionOf(stored: unknown): Dimension[] {
  if (!Array.isArray(stored)) return [];
  const [x0, y0, x1, y1] = stored as unknown[];
  return isNumber(x0) && isNumber(y0) && isNumber(x1) && isNumber(y1)
    ? [{ from: { x: x0, y: y0 }, to: { x: x1, y: y1 } }]
    : [];
}

/** Dimensions by drawing from a stored text; what cannot be read is left out. */
export function parseDimensions(text: string | null): ReadonlyMap<string, readonly Dimension[]> {
  try {
    const stored: unknown = JSON.parse(text ?? "[]");
    if (!Array.isArray(stored)) return new Map();
    return new Map(
      stored
        .filter((entry): entry is [string, unknown[]] => typeof entry?.[0] === "string")
        .map(([drawing, list]) => [
          drawing,
          Array.isArray(list) ? list.flatMap(dimensionOf).slice(0, MAX_KEPT) : [],
        ]),
    );
  } catch {
    return new Map();
  }
}

export const formatDimensions = (kept: ReadonlyMap<string, readonly Dimension[]>): string =>
  JSON.stringify(
    [...kept].map(([drawing, list]) => [
      drawing,
      list.map(({ from, to }) => [from.x, from.y, to.x, to.y]),
    ]),
  );

function stored(): string | null {
  try {
    return localStorage.getItem(KEY);
  } catch {
    // The browser does not let the page store anything.
    return null;
  }
}

function store(kept: ReadonlyMap<string, readonly Dimension[]>): void {
  try {
    localStorage.setItem(KEY, formatDimensions(kept));
  } catch {
    // They are kept until the page is closed.
  }
}

/** The dimensions after those of a drawing were changed, which becomes the last one. */
export function withDimensions(
  kept: ReadonlyMap<string, readonly Dimension[]>,
  drawing: string,
  list: readonly Dimension[],
): ReadonlyMap<string, readonly Dimension[]> {
  const others = [...kept].filter(([id]) => id !== drawing);
  const all = list.length === 0 ? others : [...others, [drawing, list.slice(-MAX_KEPT)] as const];
  return new Map(all.slice(-MAX_DRAWINGS));
}

export const useDimensions = create<Dimensions>()((set, get) => {
  const change = (drawing: string, dimension: Dimension, added: readonly Dimension[]) => {
    const { kept } = get();
    const others = (kept.get(drawing) ?? []).filter(
      (one) => dimensionKey(one) !== dimensionKey(dimension),
    );
    const next = withDimensions(kept, drawing, [...others, ...added]);
    store(next);
    set({ kept: next });
  };
  return {
    shown: true,
    kept: parseDimensions(stored()),
    toggle: () => set(({ shown }) => ({ shown: !shown })),
    keep: (drawing, dimension) => {
      change(drawing, dimension, [dimension]);
      // What was just kept is seen.
      set({ shown: true });
    },
    remove: (drawing, dimension) => change(drawing, dimension, []),
  };
});
