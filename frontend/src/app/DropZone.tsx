/** Accepts files dropped anywhere on the page. */

import { useEffect, useState } from "react";
import { translate } from "../language/translate";
import { useRefusal } from "../state/accounts/accounts";
import { uploadFiles } from "../state/actions";
import css from "./app.module.css";

export function DropZone() {
  const reason = useRefusal("POST /api/v1/drawings");
  const [over, setOver] = useState(false);
  useEffect(() => {
    let depth = 0;
    const listeners = new AbortController();
    const listen = (
      name: "dragenter" | "dragover" | "dragleave" | "drop",
      act: (e: DragEvent) => void,
    ) =>
      window.addEventListener(
        name,
        (event) => {
          if (!event.dataTransfer?.types.includes("Files")) return;
          event.preventDefault();
          act(event);
        },
        { signal: listeners.signal },
      );
    listen("dragenter", () => {
      depth++;
      setOver(true);
    });
    listen("dragover", () => undefined);
    listen("dragleave", () => {
      depth--;
      if (depth <= 0) setOver(false);
    });
    listen("drop", (event) => {
      depth = 0;
      setOver(false);
      if (reason === null) void uploadFiles([...(event.dataTransfer?.files ?? [])]);
    });
    return () => listeners.abort();
  }, [reason]);
  if (!over) return null;
  return (
    <div className={css.drop} data-testid="drop-zone">
      <div className={css.dropCard}>{reason ?? translate("dropZone.dropDrawingFilesHereTo")}</div>
    </div>
  );
}
