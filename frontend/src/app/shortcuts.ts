/** Keyboard shortcuts. */

import { refusalOf } from "../state/accounts/accounts";
import { redo, retype, undo } from "../state/actions";
import { useDrafting } from "../state/drafting/drafting";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../state/drawing/palette";
import { queries, queryClient } from "../state/queries";
import { COLOUR_MODES, type Layer, useUiStore } from "../state/store";

/** Commands of the canvas. */
export interface PictureCommands {
  fit(): void;
  fitTable(): void;
  zoom(factor: number): void;
  pan(dx: number, dy: number): void;
}

const LAYER_KEYS: Readonly<Record<string, Layer>> = {
  n: "nominal",
  h: "head",
  t: "tip",
  r: "rapids",
  s: "swept",
  p: "moves",
};
const STEP = 80;

const typing = (target: EventTarget | null): boolean =>
  target instanceof HTMLElement &&
  (target.isContentEditable ||
    target.closest("input, textarea, select, [role=listbox], [role=menu], [role=slider]") !== null);

export function listenToKeys(picture: () => PictureCommands | null): () => void {
  const act = (event: KeyboardEvent): boolean => {
    const page = useUiStore.getState();
    const key = event.key.length === 1 ? event.key.toLowerCase() : event.key;
    if (event.ctrlKey || event.metaKey) {
      if (key === "z") void (event.shiftKey ? redo() : undo());
      else if (key === "y") void redo();
      else if (key === "a" && page.drawing !== null) {
        const edges = queryClient.getQueryData(queries.edges(page.drawing).queryKey);
        if (edges !== undefined) page.selectEdges(edges.bulge.keys());
      } else return false;
      return true;
    }
    if (event.altKey) return false;
    const layer = LAYER_KEYS[key];
    const type = ASSIGNABLE_TYPES.find((choice) => LINE_STYLES[choice].key === key);
    if (key === "f" && event.shiftKey) picture()?.fitTable();
    else if (key === "f") picture()?.fit();
    else if (key === "+" || key === "=") picture()?.zoom(1.4);
    else if (key === "-") picture()?.zoom(1 / 1.4);
    else if (key === "ArrowLeft") picture()?.pan(STEP, 0);
    else if (key === "ArrowRight") picture()?.pan(-STEP, 0);
    else if (key === "ArrowUp") picture()?.pan(0, STEP);
    else if (key === "ArrowDown") picture()?.pan(0, -STEP);
    else if (key === "]") page.set({ panelOpen: !page.panelOpen });
    else if (key === "?") page.set({ helpOpen: !page.helpOpen });
    else if (key === "Escape" && page.editedProfile !== null)
      page.set({ editedProfile: null, retypePreviews: [] });
    else if (key === "Escape" && useDrafting.getState().tool !== null)
      useDrafting.getState().cancel();
    else if (key === "Escape" && !page.helpOpen) page.selectEdges([]);
    else if (key === "m") useDrafting.getState().choose("measure");
    else if (key === "c") {
      const next = (COLOUR_MODES.indexOf(page.colourMode) + 1) % COLOUR_MODES.length;
      page.set({ colourMode: COLOUR_MODES[next] ?? "types" });
    } else if (layer !== undefined) page.toggleLayer(layer);
    else if (refusalOf("PATCH /api/v1/drawings/{id}/edges") !== null) return false;
    else if (type !== undefined && page.selection.size > 0) void retype([...page.selection], type);
    else if (key === "Delete" && page.selection.size > 0)
      void retype([...page.selection], "ignored");
    else if (key === "0" && page.selection.size > 0) void retype([...page.selection], null);
    else return false;
    return true;
  };
  const listener = (event: KeyboardEvent) => {
    if (!event.defaultPrevented && !typing(event.target) && act(event)) event.preventDefault();
  };
  window.addEventListener("keydown", listener);
  return () => window.removeEventListener("keydown", listener);
}
