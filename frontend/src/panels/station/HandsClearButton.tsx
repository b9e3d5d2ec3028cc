/** Press before the machine moves by itself, with the time for which the statement counts. */

import { IconHandOff } from "@tabler/icons-react";
import { translate } from "../../language/translate";
import type { HandsClear } from "../../state/station/handsClear";
import css from "./station.module.css";

interface Props {
  readonly hands: HandsClear;
  readonly reached: boolean;
}

export function HandsClearButton({ hands, reached }: Props) {
  return (
    <button
      type="button"
      className={css.check}
      aria-pressed={hands.left > 0}
      disabled={!reached}
      onClick={hands.toggle}
      data-testid="hands-clear"
    >
      <IconHandOff aria-hidden />
      <span>
        <b>{translate("handsClearButton.handsClear")}</b>
        <small>
          {hands.left > 0
            ? translate("handsClearButton.countsForSMoreOr", { left: hands.left })
            : translate("handsClearButton.lookThatNobodyReachesInto")}
        </small>
      </span>
    </button>
  );
}
