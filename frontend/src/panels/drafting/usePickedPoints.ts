/** Points that are chosen on the canvas with a drawing tool, snapped to the edges shown. */

import { useMemo } from "react";
import type { Point } from "../../geometry/records";
import { buildSnap } from "../../geometry/snap";
import { addEdits } from "../../state/actions";
import { editsOf, isAreaKind, useDrafting } from "../../state/drafting/drafting";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";

/** Greatest distance at which a point snaps (pixels). */
const REACH = 10;

/** Choose a point with the drawing tool, and send the edit if it was the last one. */
export function choosePoint(point: Parameters<ReturnType<typeof useDrafting.getState>["pick"]>[0]) {
  const { tool, type, pick } = useDrafting.getState();
  const points = pick(point);
  return tool === null || points === null ? null : { tool, type, points };
}

export function usePickedPoints(scale: number): {
  /** Returns false if no drawing tool is active.  No point is chosen before the edges are there. */
  pickPoint(at: Point): boolean;
  draftCursor(at: Point | null): void;
} {
  const { data: edges } = useEdges();
  const active = useDrafting((draft) => draft.tool !== null && !isAreaKind(draft.tool));
  const snap = useMemo(
    () => (active && edges !== undefined ? buildSnap(edges) : null),
    [active, edges],
  );
  const reach = REACH / scale;
  return {
    pickPoint: (at) => {
      if (snap === null || edges === undefined) return active;
      const done = choosePoint(snap(at, reach));
      if (done !== null) {
        const { selection } = useUiStore.getState();
        void addEdits(editsOf(done.tool, done.points, edges, { type: done.type, selection }));
      }
      return true;
    },
    draftCursor: (at) => {
      if (snap === null) return;
      useDrafting.getState().setCursor(at === null ? null : snap(at, reach));
    },
  };
}
