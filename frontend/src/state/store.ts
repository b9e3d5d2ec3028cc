/**
 * The one store: which document, what is chosen, what is shown, and how it came to be.
 *
 * What the service knows (drawings, jobs, the library) is not copied here: `queries.ts` asks for
 * it and keeps it fresh. Here is what only this page knows.
 */

import { create } from "zustand";
import type { Corners, Question } from "../api/client";
import type { LineState } from "../api/events";
import type { Box, LineType } from "../geometry/records";
import { LEFT_TO_THE_MACHINE } from "./corners";
import type { Change } from "./history";

export type Layer = "nominal" | "head" | "tip" | "rapids" | "swept" | "moves" | "uncut";

/** What the colour of a nominal line says. */
export const COLOUR_MODES = ["types", "deviation", "overcut"] as const;
export type ColourMode = (typeof COLOUR_MODES)[number];

export interface Hover {
  /** of the edge; null where there are only moves */
  readonly row: number | null;
  /** rows of the toolpath */
  readonly moves: readonly number[];
  /** CSS pixels from the upper left of the picture */
  readonly x: number;
  readonly y: number;
}

/** Somebody wants to see these edges: the picture goes there. */
export interface Focus {
  readonly rows: readonly number[];
  /** Or this part of the drawing. */
  readonly box: Box | null;
  readonly count: number;
}

/** Edges that would get another line type, shown before anybody says so. */
export interface Proposed {
  readonly rows: readonly number[];
  readonly type: LineType;
}

export interface Upload {
  readonly name: string;
  readonly fraction: number;
}

export interface PageState {
  readonly drawing: string | null;
  readonly job: string | null;
  readonly selection: ReadonlySet<number>;
  readonly hover: Hover | null;
  readonly hiddenTypes: ReadonlySet<string>;
  readonly hiddenLayers: ReadonlySet<string>;
  readonly layers: Readonly<Record<Layer, boolean>>;
  readonly colourMode: ColourMode;
  readonly focus: Focus;
  /** A place of the drawing that is meant, where no edge is. */
  readonly pin: Box | null;
  readonly past: readonly Change[];
  readonly future: readonly Change[];
  readonly busy: boolean;
  readonly upload: Upload | null;
  readonly line: LineState;
  readonly leftOpen: boolean;
  readonly rightOpen: boolean;
  readonly helpOpen: boolean;
  /** Where the head is put by hand in the preview (s), while no table moves it. */
  readonly scrub: number | null;
  readonly machine: string | null;
  readonly board: string | null;
  readonly copies: number;
  /** How a cutter goes round corners, where the machine has one. */
  readonly corners: Corners;
  /** A click means a corner now, and not an edge. */
  readonly picking: boolean;
  /** What the service asked when it was told to compile. */
  readonly asked: readonly Question[];
  /** What would become of which edges: shown in the picture, and not said. */
  readonly proposed: readonly Proposed[];
  /** The profile that is being edited. */
  readonly editing: string | null;

  open(drawing: string | null, job?: string | null): void;
  openJob(job: string | null): void;
  choose(rows: Iterable<number>, add?: boolean): void;
  point(hover: Hover | null): void;
  toggleType(type: string): void;
  toggleLayerOfDrawing(layer: string): void;
  toggleLayer(layer: Layer): void;
  look(rows: readonly number[]): void;
  /** Bring a part of the drawing into view, and mark a place in it. */
  lookAt(box: Box, pin?: Box): void;
  /** A change was made: it can be undone, and what was undone is forgotten. */
  made(change: Change): void;
  /** The last change was undone (or done again). */
  undone(): void;
  redone(): void;
  /** Others changed the drawing: only these steps can still be undone. */
  rebase(past: readonly Change[]): void;
  set(part: Partial<PageValues>): void;
}

type PageValues = Pick<
  PageState,
  | "busy"
  | "upload"
  | "line"
  | "leftOpen"
  | "rightOpen"
  | "helpOpen"
  | "scrub"
  | "machine"
  | "board"
  | "copies"
  | "corners"
  | "picking"
  | "asked"
  | "proposed"
  | "editing"
  | "colourMode"
>;

const NOTHING: ReadonlySet<number> = new Set();

const toggled = (set: ReadonlySet<string>, word: string): ReadonlySet<string> => {
  const next = new Set(set);
  if (!next.delete(word)) next.add(word);
  return next;
};

const same = (a: readonly number[], b: readonly number[]): boolean =>
  a.length === b.length && a.every((row, at) => row === b[at]);

export const usePage = create<PageState>()((put) => ({
  drawing: null,
  job: null,
  selection: NOTHING,
  hover: null,
  hiddenTypes: new Set<string>(),
  hiddenLayers: new Set<string>(),
  layers: {
    nominal: true,
    head: true,
    tip: false,
    rapids: false,
    swept: false,
    moves: false,
    uncut: true,
  },
  colourMode: "types",
  focus: { rows: [], box: null, count: 0 },
  pin: null,
  past: [],
  future: [],
  busy: false,
  upload: null,
  line: "connecting",
  leftOpen: true,
  rightOpen: true,
  helpOpen: false,
  scrub: null,
  machine: null,
  board: null,
  copies: 1,
  corners: LEFT_TO_THE_MACHINE,
  picking: false,
  asked: [],
  proposed: [],
  editing: null,

  open: (drawing, job = null) =>
    put((page) =>
      page.drawing === drawing
        ? { job, scrub: null }
        : {
            drawing,
            job,
            selection: NOTHING,
            pin: null,
            hover: null,
            hiddenTypes: new Set<string>(),
            hiddenLayers: new Set<string>(),
            past: [],
            future: [],
            scrub: null,
            asked: [],
            proposed: [],
            picking: false,
            // Single corners are places of the drawing that was open.
            corners: { ...page.corners, at: [] },
          },
    ),
  openJob: (job) => put({ job, scrub: null }),
  choose: (rows, add = false) =>
    put(({ selection }) => {
      if (!add) return { selection: new Set(rows), pin: null };
      const listed = [...rows];
      const next = new Set(selection);
      // A single edge that is chosen already is let go; a box only adds.
      const [only] = listed;
      if (listed.length === 1 && only !== undefined && next.delete(only))
        return { selection: next };
      for (const row of listed) next.add(row);
      return { selection: next };
    }),
  point: (hover) =>
    put((page) => {
      const before = page.hover?.moves;
      if (hover === null || before === undefined || !same(before, hover.moves)) return { hover };
      // The cursor moved on along the same moves: they are the same list.
      return { hover: { ...hover, moves: before } };
    }),
  toggleType: (type) => put(({ hiddenTypes }) => ({ hiddenTypes: toggled(hiddenTypes, type) })),
  toggleLayerOfDrawing: (layer) =>
    put(({ hiddenLayers }) => ({ hiddenLayers: toggled(hiddenLayers, layer) })),
  toggleLayer: (layer) => put(({ layers }) => ({ layers: { ...layers, [layer]: !layers[layer] } })),
  look: (rows) =>
    put(({ focus }) => ({
      selection: new Set(rows),
      pin: null,
      focus: { rows, box: null, count: focus.count + 1 },
    })),
  lookAt: (box, pin) =>
    put(({ selection, focus }) => ({
      // What is marked is not one of the edges that are chosen.
      selection: pin === undefined ? selection : NOTHING,
      pin: pin ?? null,
      focus: { rows: [], box, count: focus.count + 1 },
    })),
  made: (change) => put(({ past }) => ({ past: [...past, change], future: [] })),
  undone: () =>
    put(({ past, future }) => {
      const last = past.at(-1);
      return last === undefined ? {} : { past: past.slice(0, -1), future: [...future, last] };
    }),
  redone: () =>
    put(({ past, future }) => {
      const next = future.at(-1);
      return next === undefined ? {} : { past: [...past, next], future: future.slice(0, -1) };
    }),
  rebase: (past) => put({ past, future: [] }),
  set: (part) => put(part),
}));
