/** What a profile would do to the drawing that is open, asked a moment after the last edit. */

import { useEffect, useState } from "react";
import { type Preview, service } from "../api/client";
import { type Draft, sentOf } from "./draft";

export interface Previewed {
  readonly data: Preview | null;
  readonly error: Error | null;
}

/** Milliseconds without an edit before the service is asked. */
const PAUSE = 250;

export function usePreview(drawing: string | null, draft: Draft): Previewed {
  const [found, setFound] = useState<Previewed>({ data: null, error: null });
  useEffect(() => {
    if (drawing === null) return;
    let late = false;
    // A fault of what was written before is none of what is written now.
    setFound((before) => (before.error === null ? before : { ...before, error: null }));
    const timer = window.setTimeout(() => {
      service.preview(drawing, sentOf(draft)).then(
        (data) => !late && setFound({ data, error: null }),
        (error: Error) => !late && setFound((before) => ({ ...before, error })),
      );
    }, PAUSE);
    return () => {
      // What comes after the next edit is not of it.
      late = true;
      window.clearTimeout(timer);
    };
  }, [drawing, draft]);
  return found;
}
