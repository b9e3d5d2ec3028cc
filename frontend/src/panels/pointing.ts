/** Shows in the picture what an answer would make of edges, as long as it is pointed at or focused. */

import { LINE_TYPES, type LineType } from "../geometry/records";
import { type Proposed, usePage } from "../state/store";

const isLineType = (word: string | undefined): word is LineType =>
  LINE_TYPES.some((type) => type === word);

/** The attributes of an element that stands for these proposals. */
export function showing(make: () => readonly Proposed[]) {
  const { set } = usePage.getState();
  const show = () => set({ proposed: make() });
  const hide = () => set({ proposed: [] });
  return { onMouseEnter: show, onMouseLeave: hide, onFocus: show, onBlur: hide };
}

/**
 * The attributes of an element about these edges that holds answers.
 *
 * What is pointed at in it may say by `data-answer` which type it gives them; all else lights them
 * as what they are.
 */
export function answering(rows: readonly number[], now: LineType) {
  const { set } = usePage.getState();
  const show = ({ target }: { target: EventTarget }) => {
    const held = target instanceof Element ? target.closest<HTMLElement>("[data-answer]") : null;
    const word = held?.dataset.answer;
    const type = isLineType(word) ? word : now;
    const [shown] = usePage.getState().proposed;
    if (shown?.rows !== rows || shown.type !== type) set({ proposed: [{ rows, type }] });
  };
  const hide = () => set({ proposed: [] });
  return { onMouseOver: show, onMouseLeave: hide, onFocus: show, onBlur: hide };
}
