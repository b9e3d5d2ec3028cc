/** Areas that are drawn with the pointer to select edges: a box, or a lasso drawn by hand. */

import type { Point } from "../geometry/records";
import type { SelectMode } from "../geometry/selection";

export interface AreaTool {
  readonly kind: "box" | "lasso";
  /** What the edges in the area do to the selection without a key. */
  readonly mode: SelectMode;
}

interface Keys {
  readonly shiftKey: boolean;
  readonly altKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
}

/**
 * What a drag draws with a tool and with keys; null if it moves the view.
 *
 * Shift draws a box and Alt a lasso without a tool. Shift adds to the selection, Ctrl removes.
 */
export function areaOfDrag(tool: AreaTool | null, keys: Keys): AreaTool | null {
  const kind = keys.altKey ? "lasso" : (tool?.kind ?? (keys.shiftKey ? "box" : null));
  if (kind === null) return null;
  const mode = keys.ctrlKey || keys.metaKey ? "remove" : keys.shiftKey ? "add" : tool?.mode;
  return { kind, mode: mode ?? "replace" };
}

/** Points of a lasso nearer than this to the last one are left out (pixels). */
const LASSO_STEP = 3;

/** The corners of an area after the pointer has moved; `corners` begins where it was pressed. */
export function extendedArea(
  kind: AreaTool["kind"],
  corners: readonly Point[],
  to: Point,
): readonly Point[] {
  const [from = to] = corners;
  if (kind === "box") return [from, { x: to.x, y: from.y }, to, { x: from.x, y: to.y }];
  const last = corners.at(-1) ?? from;
  return Math.hypot(to.x - last.x, to.y - last.y) < LASSO_STEP ? corners : [...corners, to];
}
