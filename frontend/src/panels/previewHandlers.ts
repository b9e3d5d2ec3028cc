/** Event handlers that preview line types on the canvas while an element is hovered or focused. */

import { LINE_TYPES, type LineType } from "../geometry/records";
import { type RetypePreview, useUiStore } from "../state/store";

const isLineType = (name: string | undefined): name is LineType =>
  LINE_TYPES.some((type) => type === name);

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
 * A child with `data-answer` previews that line type; the rest of the element previews `now`.
 */
export function answerHandlers(rows: readonly number[], now: LineType) {
  const { set } = useUiStore.getState();
  const show = ({ target }: { target: EventTarget }) => {
    const answer = target instanceof Element ? target.closest<HTMLElement>("[data-answer]") : null;
    const name = answer?.dataset.answer;
    const type = isLineType(name) ? name : now;
    const [shown] = useUiStore.getState().retypePreviews;
    if (shown?.rows !== rows || shown.type !== type) set({ retypePreviews: [{ rows, type }] });
  };
  const hide = () => set({ retypePreviews: [] });
  return { onMouseOver: show, onMouseLeave: hide, onFocus: show, onBlur: hide };
}
