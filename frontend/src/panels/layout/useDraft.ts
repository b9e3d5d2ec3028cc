/** The draft of a layout with its history, and the revision that the server has of it. */

import { useEffect, useState } from "react";
import { type Layout, layoutService, type Placed } from "../../api/layouts";
import { queryClient } from "../../state/queries";
import { begin, type Draft, type History, NEW_SHEET, record, redo, undo } from "./placing";

const draftOf = ({ sheet, placed }: Layout): Draft => ({
  sheet: { ...NEW_SHEET, ...sheet },
  // The page lays out the present revisions.
  placed: placed.map((one) => ({ ...(one as Placed), revision: null })),
});

export interface EditedDraft {
  readonly draft: Draft;
  readonly canUndo: boolean;
  readonly canRedo: boolean;
  readonly unsaved: boolean;
  /** Record a new draft; one that is `joined` replaces the present one, as while dragging. */
  put(next: Draft, joined?: boolean): void;
  undo(): void;
  redo(): void;
  /** Store the draft as a new revision, unless the server has it. */
  save(): Promise<void>;
}

export function useDraft(layout: Layout): EditedDraft {
  const [history, setHistory] = useState<History>(() => begin(draftOf(layout)));
  const [stored, setStored] = useState<{ revision: number; draft: Draft }>(() => ({
    revision: layout.revision,
    draft: history.present,
  }));
  const draft = history.present;
  const unsaved = draft !== stored.draft;
  useEffect(() => {
    if (!unsaved) return;
    const warn = (event: BeforeUnloadEvent) => event.preventDefault();
    addEventListener("beforeunload", warn);
    return () => removeEventListener("beforeunload", warn);
  }, [unsaved]);

  const save = async () => {
    if (!unsaved) return;
    const next = await layoutService.replace(layout.id, stored.revision, draft);
    setStored({ revision: next.revision, draft });
    queryClient.setQueryData(["layout", layout.id], next);
    await queryClient.invalidateQueries({ queryKey: ["drawing", layout.id] });
    await queryClient.invalidateQueries({ queryKey: ["edges", layout.id] });
  };
  return {
    draft,
    canUndo: history.past.length > 0,
    canRedo: history.future.length > 0,
    unsaved,
    put: (next, joined = false) => setHistory((now) => record(now, next, joined)),
    undo: () => setHistory(undo),
    redo: () => setHistory(redo),
    save,
  };
}
