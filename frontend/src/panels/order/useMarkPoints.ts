/** Marks of a printed sheet that are clicked on the canvas, snapped to the edges shown. */

import { useMemo } from "react";
import type { Point } from "../../geometry/records";
import { buildSnap, type Snapped } from "../../geometry/snap";
import { NO_MARKS, useMarkPicking, withMarks } from "../../state/order/marks";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";

/** Greatest distance at which a point snaps (pixels). */
const REACH = 14;

/** What a mark can be. The centre of a small circle is meant, also where its ends are nearer. */
const KINDS: readonly Snapped["kind"][] = ["centre", "crossing", "end"];

export function useMarkPoints(scale: number): {
  /** Returns false if no marks are being clicked. */
  pickMark(at: Point): boolean;
  markCursor(at: Point | null): void;
} {
  const { data: edges } = useEdges();
  const active = useMarkPicking((picking) => picking.active);
  const snap = useMemo(
    () => (active && edges !== undefined ? buildSnap(edges, undefined, KINDS) : null),
    [active, edges],
  );
  const markAt = (at: Point): Point | null => {
    const found = snap?.(at, REACH / scale);
    return found === undefined || !KINDS.includes(found.kind) ? null : { x: found.x, y: found.y };
  };
  return {
    pickMark: (at) => {
      if (snap === null) return false;
      const point = markAt(at);
      if (point === null) {
        useMarkPicking.setState({ fault: "none" });
        return true;
      }
      const { registration, set } = useUiStore.getState();
      const before = registration ?? NO_MARKS;
      const { marks, close } = withMarks(before.marks, [point]);
      useMarkPicking.setState({ fault: close ? "close" : null });
      set({ registration: { ...before, marks } });
      return true;
    },
    markCursor: (at) => {
      if (snap !== null) useMarkPicking.setState({ cursor: at === null ? null : markAt(at) });
    },
  };
}
