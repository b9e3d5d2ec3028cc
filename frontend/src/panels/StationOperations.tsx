/** Operations of the person at the machine between two jobs. */

import { useState } from "react";
import type { Job, Machine, OperationRequest, Station } from "../api/client";
import { type HandsClear, handsReason } from "../state/handsClear";
import { operate } from "../state/operations";
import { type OperationName, outputsOf, reasonAgainst, spindlesOf } from "../state/station";
import { AskOnce } from "./AskOnce";
import { HandsClearButton } from "./HandsClearButton";
import { JogPad } from "./JogPad";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly job: Job | undefined;
  readonly reached: boolean;
  readonly hands: HandsClear;
}

interface Way {
  readonly operation: Extract<OperationName, "home" | "park" | "zero" | "unlock">;
  readonly title: string;
  readonly note: string;
  readonly request: OperationRequest;
  /** Question that comes first; null for none. */
  readonly question: { title: string; text: string; yes: string; no: string } | null;
}

const WAYS: readonly Way[] = [
  {
    operation: "home",
    title: "Home",
    note: "Finds the zero of all axes. The machine moves.",
    request: { operation: "home" },
    question: null,
  },
  {
    operation: "park",
    title: "Park",
    note: "Lifts the tool and moves the head out of the way.",
    request: { operation: "park" },
    question: null,
  },
  {
    operation: "zero",
    title: "Set X Y zero here",
    note: "Programs then begin at this place of the table.",
    request: { operation: "zero", axes: "XY" },
    question: {
      title: "Set the zero of X and Y here?",
      text: "From now on all programs start from this point. To undo this, home the machine.",
      yes: "Set zero here",
      no: "Keep the zero",
    },
  },
  {
    operation: "unlock",
    title: "Unlock",
    note: "Clears an alarm without homing. The position may be wrong.",
    request: { operation: "unlock" },
    question: null,
  },
];

/** The reason why all operations are disabled, to be shown once; null if they differ. */
function commonReason({ machine, station, job, reached }: Props): string | null {
  if (!reached)
    return "There is no connection to the server, so the machine cannot be operated from this page.";
  const reasons = WAYS.map(({ operation }) => reasonAgainst(operation, station, machine, job));
  const [first] = reasons;
  return first !== null && reasons.every((one) => one === first) ? (first ?? null) : null;
}

export function StationOperations(props: Props) {
  const { machine, station, job, reached, hands } = props;
  const [asking, setAsking] = useState<Way | null>(null);
  const common = commonReason(props);
  const reasonOf = ({ operation }: Way) =>
    reasonAgainst(operation, station, machine, job) ?? handsReason(operation, hands);
  const ask = ({ title, request }: Way) => void operate(machine.name, title, request);
  return (
    <section className={css.operations} aria-label="Move the machine" data-testid="operations">
      {common !== null && (
        <p className={css.message} data-tone="amber" data-testid="operations-reason">
          {common}
        </p>
      )}
      <JogPad {...props} />
      <HandsClearButton hands={hands} reached={reached} />
      <div className={css.waysOrQuestion}>
        {asking?.question != null && (
          <AskOnce
            {...asking.question}
            disabled={!reached || reasonOf(asking) !== null}
            onNo={() => setAsking(null)}
            onYes={() => {
              setAsking(null);
              ask(asking);
            }}
          />
        )}
        <div className={css.wayGrid} inert={asking !== null}>
          {WAYS.map((way) => {
            const reason = reasonOf(way);
            return (
              <div key={way.operation} className={css.way}>
                <button
                  type="button"
                  className={css.button}
                  disabled={!reached || reason !== null}
                  onClick={() => (way.question === null ? ask(way) : setAsking(way))}
                  data-testid={`operation-${way.operation}`}
                >
                  {way.title}
                </button>
                <small>{common === null && reason !== null ? reason : way.note}</small>
              </div>
            );
          })}
        </div>
      </div>
      <Outputs {...props} />
    </section>
  );
}

function Outputs({ machine, station, job, reached, hands }: Props) {
  const outputs = outputsOf(machine);
  const spindles = spindlesOf(machine);
  if (outputs.length + spindles.length === 0) return null;
  const reason = reasonAgainst("switch", station, machine, job);
  // What is on can always be switched off.
  const toSwitchOn = reason ?? handsReason("switch", hands);
  const because = (on: boolean) => (on ? reason : toSwitchOn);
  return (
    <fieldset className={css.outputs} data-testid="outputs">
      <legend>Outputs by hand, only at rest and with the tool lifted</legend>
      {outputs.map(({ number, name }) => (
        <OutputSwitch
          key={number}
          name={name}
          note={`Output ${number}`}
          on={station?.outputs.includes(number) === true}
          known={station?.outputs_known === true}
          enabled={reached}
          reason={because(station?.outputs.includes(number) === true)}
          onSwitch={(on, title) =>
            void operate(machine.name, title, { operation: "switch", output: number, on })
          }
          testId={`output-${number}`}
        />
      ))}
      {spindles.map(({ number, name }) => (
        <OutputSwitch
          key={`spindle ${number}`}
          name={`${name}: ${motorOf(machine, number)}`}
          note={spindleText(machine, number)}
          on={station?.spindle === number}
          known={station?.outputs_known === true}
          enabled={reached}
          reason={because(station?.spindle === number)}
          onSwitch={(on, title) =>
            void operate(machine.name, title, { operation: "spindle", station: number, on })
          }
          testId={`spindle-${number}`}
        />
      ))}
    </fieldset>
  );
}

interface SwitchProps {
  readonly name: string;
  /** Text below the name. */
  readonly note: string;
  readonly on: boolean;
  /** Whether it is off if it is not known to be on. */
  readonly known: boolean;
  readonly enabled: boolean;
  /** Reason why it cannot be switched now; null if it can. */
  readonly reason: string | null;
  /** Switches it; `title` names the action in the outcome. */
  readonly onSwitch: (on: boolean, title: string) => void;
  readonly testId: string;
}

/** One output or spindle with its present state. */
function OutputSwitch({ name, note, on, known, enabled, reason, onSwitch, testId }: SwitchProps) {
  return (
    <button
      type="button"
      role="switch"
      aria-checked={on || known ? on : "mixed"}
      className={css.output}
      disabled={!enabled || reason !== null}
      title={reason ?? undefined}
      onClick={() => onSwitch(!on, `${name} ${on ? "off" : "on"}`)}
      data-testid={testId}
    >
      <span>
        {name}
        <small>{note}</small>
      </span>
      <b>{on ? "On" : known ? "Off" : "Not known"}</b>
    </button>
  );
}

const motorOf = ({ stations }: Machine, number: number): string =>
  stations.find((one) => one.number === number)?.tool.kind === "knife" ? "oscillation" : "spindle";

function spindleText({ stations }: Machine, number: number): string {
  const found = stations.find((one) => one.number === number);
  if (found === undefined) return "";
  const speed = found.spindle_speed > 1 ? ` at ${found.spindle_speed.toLocaleString("en")}` : "";
  return `${found.spindle}${speed}${found.spindle === "M4" ? ", counter-clockwise" : ""}`;
}
