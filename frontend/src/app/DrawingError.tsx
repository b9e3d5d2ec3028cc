/** Shown instead of a drawing that cannot be loaded. */

import { Button } from "@mantine/core";
import { ServiceError } from "../api/errors";
import { translate } from "../language/translate";
import { errorText, messageHint } from "../messages/translateMessage";
import { TO_ALL_DRAWINGS } from "../panels/shared/labels";
import css from "./app.module.css";

export function DrawingError({ error }: { error: Error }) {
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome}>
        <h1>{translate("drawingError.thisDrawingCannotBeOpened")}</h1>
        <p>
          {errorText(error)} {error instanceof ServiceError && messageHint(error.problem)}
        </p>
        <Button component="a" variant="default" href="#/">
          {TO_ALL_DRAWINGS}
        </Button>
      </div>
    </div>
  );
}
