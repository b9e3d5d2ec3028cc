/** Outcome of the last action of the person. */

import { useOutcomes } from "../state/operations";
import { OUTCOME_TITLES, OUTCOME_TONES } from "../state/station";
import css from "./station.module.css";

export function StationOutcome() {
  const last = useOutcomes((outcomes) => outcomes.last);
  return (
    <div className={css.outcomeArea} role="status" aria-live="polite">
      {last !== null && (
        <div
          className={css.outcome}
          data-tone={OUTCOME_TONES[last.state]}
          data-state={last.state}
          data-testid="outcome"
        >
          <b>
            {last.label}: {OUTCOME_TITLES[last.state]}
          </b>
          {last.text !== "" && <span>{last.text}</span>}
          {last.hint !== "" && <span>{last.hint}</span>}
        </div>
      )}
    </div>
  );
}
