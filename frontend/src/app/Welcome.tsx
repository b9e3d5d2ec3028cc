/** What a newcomer sees: what this is, and the first thing to do. */

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
          DXF, SVG, CF2 or PDF, from any program. knifetip finds out what is cut, creased and
          grooved, puts the tip of each tool on its line, and proves it before the table moves.
        </p>
        <ChooseFile large />
        <ol className={css.steps}>
          <li>
            <b>1 Drop</b>a drawing, or open one of the drawings at the left
          </li>
          <li>
            <b>2 Compile</b>for your board and machine, and read the verdict
          </li>
          <li>
            <b>3 Send</b>it to the table and watch the head
          </li>
        </ol>
      </div>
    </div>
  );
}
