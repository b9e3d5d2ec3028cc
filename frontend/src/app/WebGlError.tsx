/** Shown instead of the canvas if the browser has no WebGL. */

import { Button } from "@mantine/core";
import css from "./app.module.css";

export function WebGlError({ why }: { why: string }) {
  return (
    <div className={css.centre} role="alert">
      <div className={css.welcome} data-testid="no-webgl">
        <h1>The drawing cannot be displayed</h1>
        <p>
          {why} To see the drawing, turn on hardware acceleration in the browser settings, or use a
          current Firefox, Chrome, Edge or Safari. The rest of this page works without it.
        </p>
        <Button variant="default" onClick={() => window.location.reload()}>
          Reload the page
        </Button>
      </div>
    </div>
  );
}
