/** Operations of the person at the machine between two jobs. */

import { Box, Flex, SimpleGrid, Text } from "@mantine/core";
import { useState } from "react";
import type { Job } from "../../api/jobs";
import type { Machine, OperationRequest, Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate } from "../../state/station/operations";
import {
  type OperationName,
  outputsOf,
  reasonAgainst,
  spindlesOf,
} from "../../state/station/station";
import panels from "../shared/panels.module.css";
import { AskOnce } from "./AskOnce";
import { HandsClearButton } from "./HandsClearButton";
import { JogPad } from "./JogPad";
import { ControlGroup, NotedButton, WideButton } from "./parts";
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
    title: translate("stationOperations.home"),
    note: translate("stationOperations.findsTheZeroOfAll"),
    request: { operation: "home" },
    question: null,
  },
  {
    operation: "park",
    title: translate("stationOperations.park"),
    note: translate("stationOperations.liftsTheToolAndMoves"),
    request: { operation: "park" },
    question: null,
  },
  {
    operation: "zero",
    title: translate("stationOperations.setXYZeroHere"),
    note: translate("stationOperations.programsThenBeginAtThis"),
    request: { operation: "zero", axes: "XY" },
    question: {
      title: translate("stationOperations.setTheZeroOfX"),
      text: translate("stationOperations.fromNowOnAllPrograms"),
      yes: translate("stationOperations.setZeroHere"),
      no: translate("stationOperations.keepTheZero"),
    },
  },
  {
    operation: "unlock",
    title: translate("stationOperations.unlock"),
    note: translate("stationOperations.clearsAnAlarmWithoutHoming"),
    request: { operation: "unlock" },
    question: null,
  },
];

/** The reason why all operations are disabled, to be shown once; null if they differ. */
function commonReason({ machine, station, job, reached }: Props): string | null {
  if (!reached) return translate("stationOperations.thereIsNoConnectionTo");
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
    <Flex
      component="section"
      direction="column"
      gap={14}
      aria-label={translate("stationOperations.moveTheMachine")}
      data-testid="operations"
    >
      {common !== null && (
        <p className={panels.callout} data-tone="amber" data-testid="operations-reason">
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
        <SimpleGrid cols={2} spacing={12} inert={asking !== null}>
          {WAYS.map((way) => {
            const reason = reasonOf(way);
            return (
              <NotedButton
                key={way.operation}
                note={common === null && reason !== null ? reason : way.note}
              >
                <WideButton
                  disabled={!reached || reason !== null}
                  onClick={() => (way.question === null ? ask(way) : setAsking(way))}
                  data-testid={`operation-${way.operation}`}
                >
                  {way.title}
                </WideButton>
              </NotedButton>
            );
          })}
        </SimpleGrid>
      </div>
      <Outputs {...props} />
    </Flex>
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
    <ControlGroup data-testid="outputs" legend={translate("stationOperations.outputsByHandOnlyAt")}>
      <SimpleGrid cols={2} spacing={8}>
        {outputs.map(({ number, name }) => (
          <OutputSwitch
            key={number}
            name={name}
            note={translate("stationOperations.output", { number })}
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
      </SimpleGrid>
    </ControlGroup>
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
    <WideButton
      role="switch"
      aria-checked={on || known ? on : "mixed"}
      justify="space-between"
      variant={on ? "light" : "default"}
      color="yellow"
      px={12}
      rightSection={
        on
          ? translate("stationOperations.on")
          : known
            ? translate("stationOperations.off")
            : translate("stationOperations.notKnown")
      }
      disabled={!enabled || reason !== null}
      title={reason ?? undefined}
      onClick={() =>
        onSwitch(
          !on,
          on
            ? translate("stationOperations.switchOff", { name })
            : translate("stationOperations.switchOn", { name }),
        )
      }
      data-testid={testId}
    >
      <Box component="span" ta="left">
        {name}
        <Text component="small" display="block" fw={400}>
          {note}
        </Text>
      </Box>
    </WideButton>
  );
}

const motorOf = ({ stations }: Machine, number: number): string =>
  stations.find((one) => one.number === number)?.tool.kind === "knife"
    ? translate("stationOperations.oscillation")
    : translate("stationOperations.spindle");

function spindleText({ stations }: Machine, number: number): string {
  const found = stations.find((one) => one.number === number);
  if (found === undefined) return "";
  const { spindle, spindle_speed: speed } = found;
  if (spindle === "M4")
    return speed > 1
      ? translate("stationOperations.spindleAtCounterClockwise", { spindle, speed })
      : translate("stationOperations.spindleCounterClockwise", { spindle });
  return speed > 1 ? translate("stationOperations.spindleAt", { spindle, speed }) : spindle;
}
