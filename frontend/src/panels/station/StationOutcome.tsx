/** Outcome of the last action of the person. */

import { Text } from "@mantine/core";
import { useEffect } from "react";
import { useOutcomes } from "../../state/station/operations";
import { OUTCOME_TITLES, OUTCOME_TONES } from "../../state/station/station";
import css from "./station.module.css";

/** `state` of job and machine: the outcome of an older action leaves when it changes. */
export function StationOutcome({ state }: { readonly state: string }) {
  const last = useOutcomes((outcomes) => outcomes.last);
  const leave = useOutcomes((outcomes) => outcomes.leave);
  useEffect(() => {
    if (state !== "") leave();
  }, [state, leave]);
  return (
    <div className={css.outcomeArea} role="status" aria-live="polite">
      {last !== null && (
        <div
          className={css.outcome}
          data-tone={OUTCOME_TONES[last.state]}
          data-state={last.state}
          data-testid="outcome"
        >
          <Text fz={19} fw={700}>
            {last.label}: {OUTCOME_TITLES[last.state]}
          </Text>
          {last.text !== "" && <span>{last.text}</span>}
          {last.hint !== "" && <span>{last.hint}</span>}
        </div>
      )}
    </div>
  );
}
