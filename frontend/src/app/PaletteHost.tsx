/** Opens the command palette and the list of shortcuts: each is fetched when it is first wanted. */

import { type ComponentType, useEffect, useState } from "react";
import { useLocation } from "wouter";
import { usePaletteRequests } from "../state/commands/paletteRequests";
import { notifyError } from "../state/notifications";
import { DRAWINGS } from "../state/routes";
import { useUiStore } from "../state/store";

type PaletteModule = typeof import("../panels/commands/Palette");

export function PaletteHost() {
  const [path] = useLocation();
  const [palette, setPalette] = useState<PaletteModule | null>(null);
  const [Shortcuts, setShortcuts] = useState<ComponentType | null>(null);
  const helpOpen = useUiStore((ui) => ui.helpOpen);
  useEffect(
    () =>
      usePaletteRequests.subscribe(() => {
        // Opened at once if it is loaded, so that its search receives the next keys.
        if (palette !== null) palette.togglePalette();
        else
          import("../panels/commands/Palette").then((module) => {
            setPalette(module);
            module.togglePalette();
          }, notifyError);
      }),
    [palette],
  );
  useEffect(() => {
    if (helpOpen)
      import("../panels/commands/ShortcutsDialog").then(
        (module) => setShortcuts(() => module.ShortcutsDialog),
        notifyError,
      );
  }, [helpOpen]);
  useEffect(() => {
    const listener = (event: KeyboardEvent) => {
      if (event.key.toLowerCase() !== "k" || !(event.ctrlKey || event.metaKey)) return;
      if (event.shiftKey || event.altKey) return;
      // Browsers have the search of the address bar on this key.
      event.preventDefault();
      usePaletteRequests.getState().request();
    };
    window.addEventListener("keydown", listener);
    return () => window.removeEventListener("keydown", listener);
  }, []);
  return (
    <>
      {palette !== null && <palette.Palette onDrawing={DRAWINGS.test(path)} />}
      {Shortcuts !== null && <Shortcuts />}
    </>
  );
}
