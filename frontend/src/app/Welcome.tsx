/** Start page. */

import { ChooseFile } from "../panels/DrawingsPanel";
import css from "./app.module.css";
import { Logo } from "./Logo";

export function Welcome() {
  return (
    <div className={css.centre}>
      <div className={css.welcome} data-testid="welcome">
        <Logo size={44} />
        <h1>Drop a dieline here</h1>
        <p>
          DXF, SVG, CF2 or PDF. knifetip recognises cuts, creases and grooves, computes the tool
          paths for your machine, and verifies the program before anything moves.
        </p>
        <ChooseFile large />
        <ol className={css.steps}>
          <li>
            <b>1 Open</b>a drawing: drop a file, or pick one from the list
          </li>
          <li>
            <b>2 Compile</b>for your machine and board, and check the verdict
          </li>
          <li>
            <b>3 Send</b>the job to the table and follow its progress
          </li>
        </ol>
      </div>
    </div>
  );
}
