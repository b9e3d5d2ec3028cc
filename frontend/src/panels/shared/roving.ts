/** One Tab stop for a bar of controls; the arrow keys move within it (WAI-ARIA toolbar). */

import { type RefObject, useEffect } from "react";

const CONTROLS = "button, a[href]";

const controlsOf = (bar: HTMLElement): HTMLElement[] =>
  [...bar.querySelectorAll<HTMLElement>(CONTROLS)].filter(
    (one) => !one.matches(":disabled") && one.offsetParent !== null,
  );

/** The control that a key moves to; null if the key moves to none. */
export function movedTo<T>(key: string, controls: readonly T[], from: T): T | null {
  const place = controls.indexOf(from);
  const last = controls.length - 1;
  if (place < 0) return null;
  const next: Readonly<Record<string, number>> = {
    ArrowRight: place === last ? 0 : place + 1,
    ArrowDown: place === last ? 0 : place + 1,
    ArrowLeft: place === 0 ? last : place - 1,
    ArrowUp: place === 0 ? last : place - 1,
    Home: 0,
    End: last,
  };
  const at = next[key];
  return at === undefined ? null : (controls[at] ?? null);
}

/**
 * Controls may appear, vanish and be disabled: one of those that remain is the Tab stop.
 *
 * It is the one that had the focus last, or that which is current where the focus is elsewhere.
 */
function keepOneStop(bar: HTMLElement): void {
  const controls = controlsOf(bar);
  const kept = controls.find((one) => one.dataset.stop === "");
  const current = controls.find((one) => one.ariaCurrent !== null);
  const first = bar.contains(document.activeElement) ? kept : current;
  const stop = first ?? kept ?? current ?? controls[0];
  for (const one of bar.querySelectorAll<HTMLElement>(CONTROLS)) {
    const index = one === stop ? 0 : -1;
    if (one.getAttribute("tabindex") !== String(index)) one.tabIndex = index;
    if (one === stop) one.dataset.stop = "";
    else delete one.dataset.stop;
  }
}

export function useRovingFocus(ref: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    const bar = ref.current;
    if (bar === null) return;
    const focused = (event: FocusEvent) => {
      const control = (event.target as HTMLElement).closest<HTMLElement>(CONTROLS);
      if (control === null) return;
      for (const one of bar.querySelectorAll<HTMLElement>("[data-stop]")) delete one.dataset.stop;
      control.dataset.stop = "";
      control.tabIndex = 0;
      keepOneStop(bar);
    };
    const pressed = (event: KeyboardEvent) => {
      const next = movedTo(event.key, controlsOf(bar), event.target as HTMLElement);
      if (next === null) return;
      event.preventDefault();
      // The arrow keys also move in the drawing.
      event.stopPropagation();
      next.focus();
    };
    keepOneStop(bar);
    const watch = new MutationObserver(() => keepOneStop(bar));
    const attributes = ["disabled", "href", "aria-current"];
    watch.observe(bar, { childList: true, subtree: true, attributeFilter: attributes });
    bar.addEventListener("focusin", focused);
    bar.addEventListener("keydown", pressed);
    return () => {
      watch.disconnect();
      bar.removeEventListener("focusin", focused);
      bar.removeEventListener("keydown", pressed);
    };
  }, [ref]);
}
