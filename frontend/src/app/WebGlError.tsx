/** Shown instead of the canvas if the browser has no WebGL. */

import { Button } from "@mantine/core";
import { translate } from "../language/translate";
import css from "./app.module.css";

export function WebGlError({ why }: { why: string }) {
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome} data-testid="no-webgl">
        <h1>{translate("webGlError.theDrawingCannotBeDisplayed")}</h1>
        <p>{translate("webGlError.toSeeTheDrawingTurn", { why })}</p>
        <Button variant="default" onClick={() => window.location.reload()}>
          {translate("webGlError.reloadThePage")}
        </Button>
      </div>
    </div>
  );
}
