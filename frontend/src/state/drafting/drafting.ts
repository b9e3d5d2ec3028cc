/** The tool of the canvas: what is being measured or drawn, point by point, or selected. */

import { create } from "zustand";
import type { Edit } from "../../api/drawings";
import type { Point, Segments } from "../../geometry/records";
import type { SelectMode } from "../../geometry/selection";
import type { Snapped } from "../../geometry/snap";
import { addedCircle, addedLine, type EditedType, movedEnds } from "../drawing/edits";

export type DraftTool = "measure" | "line" | "circle" | "move";
/** Tools with which a drag selects edges. */
export type AreaKind = "box" | "lasso";
export type Tool = DraftTool | AreaKind;

export const isAreaKind = (tool: Tool | null): tool is AreaKind =>
  tool === "box" || tool === "lasso";

interface Drafting {
  /** null: a click on the canvas selects an edge, and a drag moves the view. */
  readonly tool: Tool | null;
  /** First point; null before it is chosen. */
  readonly first: Snapped | null;
  /** Second point of a finished measurement. */
  readonly second: Snapped | null;
  /** Point under the cursor. */
  readonly cursor: Snapped | null;
  /** Line type of new edges. */
  readonly type: EditedType;
  /** What the edges in an area do to the selection. */
  readonly areaMode: SelectMode;
  choose(tool: Tool | null): void;
  setType(type: EditedType): void;
  setAreaMode(areaMode: SelectMode): void;
  setCursor(cursor: Snapped | null): void;
  /** Choose a point; returns both points if it was the second one. */
  pick(point: Snapped): readonly [Snapped, Snapped] | null;
  /** Forget the chosen points; without points, leave the tool. */
  cancel(): void;
}

const NO_POINTS = { first: null, second: null } as const;

export const useDrafting = create<Drafting>()((set, get) => ({
  tool: null,
  ...NO_POINTS,
  cursor: null,
  type: "cut",
  areaMode: "replace",
  choose: (tool) => set({ tool, ...NO_POINTS, cursor: null, areaMode: "replace" }),
  setType: (type) => set({ type }),
  setAreaMode: (areaMode) => set({ areaMode }),
  setCursor: (cursor) => set({ cursor }),
  pick: (point) => {
    const { first, second, tool } = get();
    if (first === null || second !== null) {
      set({ first: point, second: null });
      return null;
    }
    // A measurement stays until the next one begins.
    set(tool === "measure" ? { second: point } : NO_POINTS);
    return [first, point];
  },
  cancel: () => set(({ first }) => (first === null ? { tool: null, cursor: null } : NO_POINTS)),
}));

/** The edits that two points mean for a tool; none for a measurement. */
export function editsOf(
  tool: Tool,
  [from, to]: readonly [Point, Point],
  segments: Segments,
  { type, selection }: { type: EditedType; selection: ReadonlySet<number> },
): Edit[] {
  if (from.x === to.x && from.y === to.y) return [];
  if (tool === "line") return [addedLine(from, to, type)];
  if (tool === "circle") return [addedCircle(from, to, type)];
  if (tool === "move") return movedEnds(segments, from, to, selection);
  return [];
}
