/** Start page. */

import { ChooseFile } from "../panels/DrawingsPanel";
import { Permitted } from "../panels/Permitted";
import css from "./app.module.css";
import { Logo } from "./Logo";

export function Welcome() {
  return (
    <div className={css.centre}>
      <div className={css.welcome} data-testid="welcome">
        <Logo size={44} />
        <h1>Drop a dieline file here</h1>
        <p>
          DXF, SVG, CF2, PDF, HPGL or LightBurn. knifetip recognises cuts, creases and grooves,
          calculates the tool paths for your machine, and checks the program before the machine
          moves.
        </p>
        <Permitted request="POST /api/v1/drawings">
          <ChooseFile large />
        </Permitted>
        <ol className={css.steps}>
          <li>
            <b>1. Open</b>Drop a drawing file, or choose a drawing from the list.
          </li>
          <li>
            <b>2. Prepare</b>Choose a machine and a board, prepare the machine program, and see how
            far it deviates from the drawing.
          </li>
          <li>
            <b>3. Send</b>Send the job to the machine. The operator checks the table there and
            starts it. Follow the progress.
          </li>
        </ol>
      </div>
    </div>
  );
}
