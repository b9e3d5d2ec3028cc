/** The main button of a step, which the keyboard reaches from everywhere. */

/** Give the focus to the main button of the step. */
export function focusMainAction(): void {
  document.querySelector("[data-main-action]")?.querySelector<HTMLElement>("button, a")?.focus();
}
