/** Keyboard shortcuts of the page of a drawing. */

import { commandsOf } from "../state/commands/commands";
import { matches } from "../state/commands/keys";
import { useUiStore } from "../state/store";

const WRITES = "input, textarea, select, [role=listbox], [role=menu], [role=slider], [role=grid]";
/** Controls that Enter presses. */
const PRESSES = "button, a, summary";

const isTaken = ({ target, key }: KeyboardEvent): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target.closest(WRITES) !== null ||
    // A dialog is in front of the drawing.
    (target.closest("[role=dialog]") !== null && key !== "?") ||
    (key === "Enter" && target.closest(PRESSES) !== null));

/** Run the commands whose keys are pressed, until the returned function is called. */
export function listenToKeys(): () => void {
  const listener = (event: KeyboardEvent) => {
    if (event.defaultPrevented || isTaken(event)) return;
    const found = commandsOf(useUiStore.getState().step).find(
      ({ keys, ready }) => keys.some((one) => matches(one, event)) && ready(),
    );
    if (found === undefined) return;
    event.preventDefault();
    found.run();
  };
  window.addEventListener("keydown", listener);
  return () => window.removeEventListener("keydown", listener);
}
