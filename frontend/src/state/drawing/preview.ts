/** Preview of an edited profile on the open drawing, requested shortly after the last edit. */

import { useEffect, useState } from "react";
import { drawingService, type Preview } from "../../api/drawings";
import { type Draft, profileRequest } from "./draft";

export interface PreviewState {
  readonly data: Preview | null;
  readonly error: Error | null;
}

/** Delay between the last edit and the request (ms). */
const DELAY = 250;

export function usePreview(drawing: string | null, draft: Draft): PreviewState {
  const [found, setFound] = useState<PreviewState>({ data: null, error: null });
  useEffect(() => {
    if (drawing === null) return;
    let outdated = false;
    // Clear an error of the previous draft.
    setFound((before) => (before.error === null ? before : { ...before, error: null }));
    const timer = window.setTimeout(() => {
      drawingService.preview(drawing, profileRequest(draft)).then(
        (data) => !outdated && setFound({ data, error: null }),
        (error: Error) => !outdated && setFound((before) => ({ ...before, error })),
      );
    }, DELAY);
    return () => {
      // Discard answers that arrive after the next edit.
      outdated = true;
      window.clearTimeout(timer);
    };
  }, [drawing, draft]);
  return found;
}
