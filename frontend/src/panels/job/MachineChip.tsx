/** Connection state of the machine and of the server, in the top bar. */

import { Badge, Box, Tooltip } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { translate } from "../../language/translate";
import { machineWord, proposedMachine } from "../../state/job/machines";
import { queries, useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";

const WORDS = {
  offline: translate("machineChip.offline"),
  free: translate("machineChip.free"),
  waiting: translate("machineChip.waiting"),
  interrupted: translate("machineChip.interrupted"),
  busy: translate("machineChip.busy"),
} as const;

export function MachineChip() {
  const connection = useUiStore((ui) => ui.connection);
  const chosen = useUiStore((ui) => ui.machine);
  const { data: machines, isError } = useMachines();
  const wanted = chosen ?? proposedMachine(machines ?? []);
  const machine = machines?.find(({ name }) => name === wanted) ?? machines?.[0];
  const name = machine?.name ?? "";
  const { data: queue } = useQuery({ ...queries.queue(name), enabled: name !== "" });
  const occupant = queue?.entries.find(({ place }) => place === 0)?.job;
  const lost = connection === "broken" || isError;
  const there = !lost && machine?.gateway === "connected";
  const word = machine === undefined ? "" : machineWord(machine, occupant);
  const label = lost
    ? translate("machineChip.theKnifetipServerDoesNot")
    : machine === undefined
      ? translate("machineChip.loadingTheListOfMachines")
      : there
        ? translate("machineChip.isConnected", { title: machine.title || machine.name })
        : translate("machineChip.isNotConnectedSoIts", { title: machine.title || machine.name });
  return (
    <Tooltip label={label}>
      <Badge
        component="span"
        miw={0}
        color={lost ? "red" : word === "interrupted" ? "yellow" : there ? "green" : "gray"}
        leftSection={
          <Box component="span" visibleFrom="xs" className={css.dot} bg="currentcolor" />
        }
        data-testid="machine-status"
        role="status"
      >
        {lost ? (
          translate("machineChip.serverNotReachable")
        ) : (
          <>
            {/* A phone has no room for the name of the machine: its state remains. */}
            <Box component="span" visibleFrom="xs" mr={6}>
              {machine?.title || machine?.name || "…"}
            </Box>
            {word === "" ? "" : WORDS[word]}
          </>
        )}
      </Badge>
    </Tooltip>
  );
}
