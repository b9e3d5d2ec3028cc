/**
 * State of the user interface: open drawing and job, selection, visible layers, undo history.
 *
 * Server data (drawings, jobs, library) is not copied here; `queries.ts` fetches and caches it.
 */

import { create } from "zustand";
import type { Question } from "../api/drawings";
import type { ConnectionState } from "../api/events";
import type { Corners, Lift, OrderDetails, Registration, Sheet } from "../api/jobs";
import type { Box, LineType } from "../geometry/records";
import { changedSelection, type SelectMode } from "../geometry/selection";
import type { Change } from "./drawing/history";
import { DEFAULT_CORNERS } from "./order/corners";
import { DEFAULT_OPTIONS, type Options } from "./order/options";
import { NO_DETAILS } from "./order/orderDetails";

export type Layer = "nominal" | "head" | "tip" | "rapids" | "swept" | "moves" | "uncut";

/** What the colour of a nominal line shows. */
export const COLOUR_MODES = ["types", "deviation", "overcut"] as const;
export type ColourMode = (typeof COLOUR_MODES)[number];

export interface Hover {
  /** row of the edge; null if only moves lie under the cursor */
  readonly row: number | null;
  /** rows of the toolpath */
  readonly moves: readonly number[];
  /** CSS pixels from the upper left corner of the canvas */
  readonly x: number;
  readonly y: number;
}

/** Request to zoom to some edges or to a box; a new `count` is a new request. */
export interface ZoomRequest {
  readonly rows: readonly number[];
  /** zoomed to instead of `rows` unless null */
  readonly box: Box | null;
  readonly count: number;
}

/** Edges and the line type that they would get: shown on the canvas before it is applied. */
export interface RetypePreview {
  readonly rows: readonly number[];
  readonly type: LineType;
}

export interface Upload {
  readonly name: string;
  readonly fraction: number;
}

/** Steps from a drawing to a job. */
export const STEPS = ["lines", "sheet", "process", "check"] as const;
export type Step = (typeof STEPS)[number];

/** The open drawing, its step and a job of it; they stay open behind other views. */
export interface OpenDrawing {
  readonly drawing: string | null;
  /** null until it is known which step needs the user first */
  readonly step: Step | null;
  readonly job: string | null;
}

/** What is chosen for the next job of a drawing, and for no other drawing. */
export type Choices = Pick<
  UiState,
  "board" | "copies" | "corners" | "sheet" | "registration" | "lift" | "options"
>;

export interface UiState extends OpenDrawing {
  readonly selection: ReadonlySet<number>;
  readonly hover: Hover | null;
  readonly hiddenTypes: ReadonlySet<string>;
  readonly hiddenLayers: ReadonlySet<string>;
  readonly layers: Readonly<Record<Layer, boolean>>;
  readonly colourMode: ColourMode;
  readonly zoomRequest: ZoomRequest;
  /** A marked place where there is no edge. */
  readonly pin: Box | null;
  readonly past: readonly Change[];
  readonly future: readonly Change[];
  readonly busy: boolean;
  readonly upload: Upload | null;
  readonly connection: ConnectionState;
  readonly panelOpen: boolean;
  readonly helpOpen: boolean;
  /** Program time (s) at which the preview shows the head; null while it follows the machine. */
  readonly previewTime: number | null;
  readonly machine: string | null;
  /** Board of the next job; null until it is chosen for the open drawing. */
  readonly board: string | null;
  readonly copies: number;
  /** How a router goes round corners; unused on other machines. */
  readonly corners: Corners;
  /** The sheet if it was cut to size; null if it may be larger than the drawing. */
  readonly sheet: Sheet | null;
  /** Marks of a printed sheet; null for a sheet without marks. */
  readonly registration: Registration | null;
  /** Height of the tool in turns; unused on machines without a turn clearance. */
  readonly lift: Lift;
  readonly options: Options;
  /** Choices for drawings that were open before, by their id. */
  readonly choices: ReadonlyMap<string, Choices>;
  /** Details of the next order. */
  readonly details: OrderDetails;
  /** A click on the canvas selects a corner instead of an edge. */
  readonly pickingCorners: boolean;
  /** Questions that the last compile request was refused with. */
  readonly compileQuestions: readonly Question[];
  /** Line types shown on the canvas but not applied. */
  readonly retypePreviews: readonly RetypePreview[];
  /** Name of the profile in the editor. */
  readonly editedProfile: string | null;

  open(drawing: string | null, job?: string | null, step?: Step | null): void;
  openJob(job: string | null): void;
  selectEdges(rows: Iterable<number>, mode?: SelectMode): void;
  setHover(hover: Hover | null): void;
  toggleType(type: string): void;
  toggleFileLayer(layer: string): void;
  toggleLayer(layer: Layer): void;
  /** Select edges and zoom to them. */
  zoomToEdges(rows: readonly number[]): void;
  /** Zoom to a box and mark a place in it. */
  zoomToBox(box: Box, pin?: Box): void;
  /** Append a change to the undo history and clear the redo history. */
  recordChange(change: Change): void;
  /** Move the last change from the undo to the redo history. */
  recordUndo(): void;
  /** Move the last change from the redo to the undo history. */
  recordRedo(): void;
  /** Replace the undo history and clear the redo history. */
  replaceHistory(past: readonly Change[]): void;
  set(part: Partial<UiValues>): void;
}

type UiValues = Pick<
  UiState,
  | "busy"
  | "upload"
  | "connection"
  | "step"
  | "panelOpen"
  | "helpOpen"
  | "previewTime"
  | "machine"
  | "board"
  | "copies"
  | "corners"
  | "pickingCorners"
  | "sheet"
  | "registration"
  | "lift"
  | "options"
  | "details"
  | "compileQuestions"
  | "retypePreviews"
  | "editedProfile"
  | "colourMode"
>;

const NO_ROWS: ReadonlySet<number> = new Set();

const withToggled = (set: ReadonlySet<string>, word: string): ReadonlySet<string> => {
  const next = new Set(set);
  if (!next.delete(word)) next.add(word);
  return next;
};

const equalRows = (a: readonly number[], b: readonly number[]): boolean =>
  a.length === b.length && a.every((row, at) => row === b[at]);

/** The choices for a drawing that is opened; a board that was chosen for another one is none. */
const choicesFor = (page: UiState, drawing: string | null): Choices =>
  (drawing === null ? undefined : page.choices.get(drawing)) ?? {
    board: null,
    copies: 1,
    // Single corners belong to the drawing that was open.
    corners: { ...page.corners, at: [] },
    sheet: null,
    registration: null,
    lift: "clearance",
    options: DEFAULT_OPTIONS,
  };

const withChoices = (page: UiState): ReadonlyMap<string, Choices> => {
  const { drawing, choices, board, copies, corners, sheet, registration, lift, options } = page;
  if (drawing === null) return choices;
  const chosen = { board, copies, corners, sheet, registration, lift, options };
  return new Map(choices).set(drawing, chosen);
};

/** What changes when a drawing and a job of it are opened. */
const withDrawing = (
  page: UiState,
  drawing: string | null,
  job: string | null,
  step: Step | null,
): Partial<UiState> => {
  if (page.drawing === drawing)
    return page.job === job ? { step } : { step, job, previewTime: null };
  return {
    drawing,
    step,
    job,
    selection: NO_ROWS,
    pin: null,
    hover: null,
    hiddenTypes: new Set<string>(),
    hiddenLayers: new Set<string>(),
    past: [],
    future: [],
    previewTime: null,
    compileQuestions: [],
    retypePreviews: [],
    pickingCorners: false,
    ...choicesFor(page, drawing),
    choices: withChoices(page),
    // The details of an order belong to the drawing that was open.
    details: NO_DETAILS,
  };
};

export const useUiStore = create<UiState>()((set) => ({
  drawing: null,
  step: null,
  job: null,
  selection: NO_ROWS,
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
  zoomRequest: { rows: [], box: null, count: 0 },
  pin: null,
  past: [],
  future: [],
  busy: false,
  upload: null,
  connection: "connecting",
  panelOpen: true,
  helpOpen: false,
  previewTime: null,
  machine: null,
  board: null,
  copies: 1,
  corners: DEFAULT_CORNERS,
  pickingCorners: false,
  sheet: null,
  registration: null,
  lift: "clearance",
  options: DEFAULT_OPTIONS,
  choices: new Map<string, Choices>(),
  details: NO_DETAILS,
  compileQuestions: [],
  retypePreviews: [],
  editedProfile: null,

  open: (drawing, job = null, step = null) => set((page) => withDrawing(page, drawing, job, step)),
  openJob: (job) => set({ job, previewTime: null }),
  selectEdges: (rows, mode = "replace") =>
    set((page) => ({
      selection: changedSelection(page.selection, rows, mode),
      pin: mode === "replace" ? null : page.pin,
    })),
  setHover: (hover) =>
    set((page) => {
      const before = page.hover?.moves;
      if (hover === null || before === undefined || !equalRows(before, hover.moves))
        return { hover };
      // Keep the identity of an unchanged list, so that nothing is rendered again.
      return { hover: { ...hover, moves: before } };
    }),
  toggleType: (type) => set(({ hiddenTypes }) => ({ hiddenTypes: withToggled(hiddenTypes, type) })),
  toggleFileLayer: (layer) =>
    set(({ hiddenLayers }) => ({ hiddenLayers: withToggled(hiddenLayers, layer) })),
  toggleLayer: (layer) => set(({ layers }) => ({ layers: { ...layers, [layer]: !layers[layer] } })),
  zoomToEdges: (rows) =>
    set(({ zoomRequest }) => ({
      selection: new Set(rows),
      pin: null,
      zoomRequest: { rows, box: null, count: zoomRequest.count + 1 },
    })),
  zoomToBox: (box, pin) =>
    set(({ selection, zoomRequest }) => ({
      // A mark replaces the selection.
      selection: pin === undefined ? selection : NO_ROWS,
      pin: pin ?? null,
      zoomRequest: { rows: [], box, count: zoomRequest.count + 1 },
    })),
  recordChange: (change) => set(({ past }) => ({ past: [...past, change], future: [] })),
  recordUndo: () =>
    set(({ past, future }) => {
      const last = past.at(-1);
      return last === undefined ? {} : { past: past.slice(0, -1), future: [...future, last] };
    }),
  recordRedo: () =>
    set(({ past, future }) => {
      const next = future.at(-1);
      return next === undefined ? {} : { past: [...past, next], future: future.slice(0, -1) };
    }),
  replaceHistory: (past) => set({ past, future: [] }),
  set: (part) => set(part),
}));
