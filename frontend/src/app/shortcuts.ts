/** Keyboard shortcuts of the page of a drawing. */

import { commandsOf } from "../state/commands/commands";
import { matches } from "../state/commands/keys";
import { useUiStore } from "../state/store";

const WRITES = "input, textarea, select, [role=listbox], [role=menu], [role=slider], [role=grid]";
/** Controls that Enter presses. */
const PRESSES = "button, a, summary";

/** Ctrl Enter, which fields do not write. */
const leavesFields = ({ key, ctrlKey, metaKey }: KeyboardEvent): boolean =>
  key === "Enter" && (ctrlKey || metaKey);

function isTaken(event: KeyboardEvent): boolean {
  const { target, key } = event;
  if (!(target instanceof HTMLElement)) return false;
  // A dialog is in front of the drawing.
  if (key !== "?" && target.closest("[role=dialog]") !== null) return true;
  if (leavesFields(event)) return false;
  return (
    target.isContentEditable ||
    target.closest(WRITES) !== null ||
    (key === "Enter" && target.closest(PRESSES) !== null)
  );
}

function runCommand(event: KeyboardEvent): void {
  if (event.defaultPrevented || isTaken(event)) return;
  const found = commandsOf(useUiStore.getState().step).find(
    ({ keys, ready }) => keys.some((one) => matches(one, event)) && ready(),
  );
  if (found === undefined) return;
  event.preventDefault();
  event.stopPropagation();
  found.run();
}

/** Run the commands whose keys are pressed, until the returned function is called. */
export function listenToKeys(): () => void {
  // Before fields receive it: lists open on Enter, with Ctrl as well.
  const early = (event: KeyboardEvent) => leavesFields(event) && runCommand(event);
  window.addEventListener("keydown", runCommand);
  window.addEventListener("keydown", early, { capture: true });
  return () => {
    window.removeEventListener("keydown", runCommand);
    window.removeEventListener("keydown", early, { capture: true });
  };
}
