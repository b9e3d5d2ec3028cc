/** The machine for which jobs are made: its state in a sentence, a word and a colour. */

import { useQuery } from "@tanstack/react-query";
import { translate } from "../../language/translate";
import { queries, useMachines } from "../queries";
import { useUiStore } from "../store";
import { machineWord, proposedMachine } from "./machines";

export const MACHINE_WORDS = {
  offline: translate("machineChip.offline"),
  free: translate("machineChip.free"),
  waiting: translate("machineChip.waiting"),
  interrupted: translate("machineChip.interrupted"),
  busy: translate("machineChip.busy"),
} as const;

export const MACHINE_COLOURS = {
  offline: "gray",
  free: "green",
  waiting: "yellow",
  interrupted: "yellow",
  busy: "blue",
} as const;

/** State of a machine in one word; "" while it is not known. */
export function useMachineWord(name: string): keyof typeof MACHINE_WORDS | "" {
  const { data: machines } = useMachines();
  const machine = machines?.find((one) => one.name === name);
  const { data: queue } = useQuery({ ...queries.queue(name), enabled: name !== "" });
  const occupant = queue?.entries.find(({ place }) => place === 0)?.job;
  return machine === undefined ? "" : machineWord(machine, occupant);
}

export function useMachineState(): { text: string; colour: string; word: string } {
  const connection = useUiStore((ui) => ui.connection);
  const chosen = useUiStore((ui) => ui.machine);
  const { data: machines, isError } = useMachines();
  const wanted = chosen ?? proposedMachine(machines ?? []);
  const machine = machines?.find(({ name }) => name === wanted) ?? machines?.[0];
  const word = useMachineWord(machine?.name ?? "");
  if (connection === "broken" || isError)
    return { text: translate("machineChip.theKnifetipServerDoesNot"), colour: "red", word: "lost" };
  if (machine === undefined || word === "")
    return { text: translate("machineChip.loadingTheListOfMachines"), colour: "gray", word: "" };
  const text = `${machine.title || machine.name}: ${MACHINE_WORDS[word]}`;
  return { text, colour: MACHINE_COLOURS[word], word };
}
