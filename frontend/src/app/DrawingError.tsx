/** Shown instead of a drawing that cannot be loaded. */

import { Button } from "@mantine/core";
import { ServiceError } from "../api/client";
import { errorText, renderHint } from "../messages/render";
import { TO_ALL_DRAWINGS } from "../panels/labels";
import { useUiStore } from "../state/store";
import css from "./app.module.css";

export function DrawingError({ error }: { error: Error }) {
  const open = useUiStore((ui) => ui.open);
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome}>
        <h1>This drawing cannot be opened</h1>
        <p>
          {errorText(error)} {error instanceof ServiceError && renderHint(error.problem)}
        </p>
        <Button variant="default" onClick={() => open(null)}>
          {TO_ALL_DRAWINGS}
        </Button>
      </div>
    </div>
  );
}
