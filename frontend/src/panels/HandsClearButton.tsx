/** Press before the machine moves by itself, with the time for which the statement counts. */

import { IconHandOff } from "@tabler/icons-react";
import type { HandsClear } from "../state/handsClear";
import css from "./station.module.css";

interface Props {
  readonly hands: HandsClear;
  readonly reached: boolean;
}

export function HandsClearButton({ hands, reached }: Props) {
  return (
    <button
      type="button"
      className={css.hands}
      aria-pressed={hands.left > 0}
      disabled={!reached}
      onClick={hands.toggle}
      data-testid="hands-clear"
    >
      <IconHandOff aria-hidden />
      <span>
        <b>Hands clear</b>
        <small>
          {hands.left > 0
            ? `Counts for ${hands.left} s more, or until the machine has moved.`
            : "Look that nobody reaches into the machine, then press. It counts for 60 s."}
        </small>
      </span>
    </button>
  );
}
