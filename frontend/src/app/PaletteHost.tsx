/** Opens the command palette and the list of shortcuts: each is fetched when it is first wanted. */

import { type ComponentType, useEffect, useState } from "react";
import { useLocation } from "wouter";
import { usePaletteRequests } from "../state/commands/paletteRequests";
import { notifyError } from "../state/notifications";
import { DRAWINGS } from "../state/routes";
import { useUiStore } from "../state/store";

export function PaletteHost() {
  const [path] = useLocation();
  const [Palette, setPalette] = useState<ComponentType<{ onDrawing: boolean }> | null>(null);
  const [Shortcuts, setShortcuts] = useState<ComponentType | null>(null);
  const requests = usePaletteRequests((palette) => palette.requests);
  const helpOpen = useUiStore((ui) => ui.helpOpen);
  useEffect(() => {
    if (requests > 0)
      import("../panels/commands/Palette").then((module) => {
        setPalette(() => module.Palette);
        module.togglePalette();
      }, notifyError);
  }, [requests]);
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
      {Palette !== null && <Palette onDrawing={DRAWINGS.test(path)} />}
      {Shortcuts !== null && <Shortcuts />}
    </>
  );
}
