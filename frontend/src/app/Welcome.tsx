/** Start page. */

import { translate } from "../language/translate";
import { Permitted } from "../panels/accounts/Permitted";
import { ChooseFile } from "../panels/drawing/DrawingsPanel";
import css from "./app.module.css";
import { Logo } from "./Logo";

export function Welcome() {
  return (
    <div className={css.centre}>
      <div className={css.welcome} data-testid="welcome">
        <Logo size={44} />
        <h1>{translate("welcome.dropADielineFileHere")}</h1>
        <p>{translate("welcome.dxfSvgCf2PdfHpgl")}</p>
        <Permitted request="POST /api/v1/drawings">
          <ChooseFile large />
        </Permitted>
        <ol className={css.steps}>
          <li>
            <b>{translate("welcome.n1Open")}</b>
            {translate("welcome.dropADrawingFileOr")}
          </li>
          <li>
            <b>{translate("welcome.n2Prepare")}</b>
            {translate("welcome.chooseAMachineAndA")}
          </li>
          <li>
            <b>{translate("welcome.n3Send")}</b>
            {translate("welcome.sendTheJobToThe")}
          </li>
        </ol>
      </div>
    </div>
  );
}
