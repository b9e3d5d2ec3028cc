/** Event handlers that preview line types on the canvas while an element is hovered or focused. */

import type { FollowingEdges } from "../../api/drawings";
import type { LineType } from "../../geometry/records";
import { followingTypes, isLineType } from "../../state/drawing/questions";
import { type RetypePreview, useUiStore } from "../../state/store";

/** Handlers of an element that previews some line types. */
export function previewHandlers(make: () => readonly RetypePreview[]) {
  const { set } = useUiStore.getState();
  const show = () => set({ retypePreviews: make() });
  const hide = () => set({ retypePreviews: [] });
  return { onMouseEnter: show, onMouseLeave: hide, onFocus: show, onBlur: hide };
}

/**
 * Handlers of an element that contains answers to a question about some edges.
 *
 * A child with `data-answer` previews that line type, and those of the edges that follow from it;
 * the rest of the element previews `now`.
 */
export function answerHandlers(
  rows: readonly number[],
  now: LineType,
  follows: readonly FollowingEdges[] = [],
) {
  const { set } = useUiStore.getState();
  const show = ({ target }: { target: EventTarget }) => {
    const answer = target instanceof Element ? target.closest<HTMLElement>("[data-answer]") : null;
    const name = answer?.dataset.answer;
    const type = isLineType(name) ? name : now;
    const [shown] = useUiStore.getState().retypePreviews;
    if (shown?.rows !== rows || shown.type !== type)
      set({ retypePreviews: [{ rows, type }, ...followingTypes(follows, type)] });
  };
  const hide = () => set({ retypePreviews: [] });
  return { onMouseOver: show, onMouseLeave: hide, onFocus: show, onBlur: hide };
}
