/** Keeps the focus where a button that has it is disabled for a while or replaced by another. */

import { type RefObject, useEffect } from "react";

const ENABLED = "button:not(:disabled), a[href]";

/** Give the focus back to the button in `ref` unless another element has received it meanwhile. */
export function useKeptFocus(ref: RefObject<HTMLElement | null>): void {
  useEffect(() => {
    const place = ref.current;
    if (place === null) return;
    let had = false;
    const note = ({ target }: Event) => {
      had = place.contains(target as Node);
    };
    const restore = () => {
      if (had && document.activeElement === document.body)
        place.querySelector<HTMLElement>(ENABLED)?.focus();
    };
    const watch = new MutationObserver(restore);
    watch.observe(place, { childList: true, subtree: true, attributeFilter: ["disabled"] });
    document.addEventListener("focusin", note);
    document.addEventListener("pointerdown", note);
    return () => {
      watch.disconnect();
      document.removeEventListener("focusin", note);
      document.removeEventListener("pointerdown", note);
    };
  }, [ref]);
}
