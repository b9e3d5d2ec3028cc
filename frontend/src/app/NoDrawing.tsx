/** A drawing that cannot be shown: why, and the way back. */

import { Button } from "@mantine/core";
import { ServiceError } from "../api/client";
import { usePage } from "../state/store";
import css from "./app.module.css";

export function NoDrawing({ error }: { error: Error }) {
  const open = usePage((page) => page.open);
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome}>
        <h1>This drawing cannot be shown</h1>
        <p>
          {error.message} {error instanceof ServiceError && error.hint}
        </p>
        <Button variant="default" onClick={() => open(null)}>
          All drawings
        </Button>
      </div>
    </div>
  );
}
