/** Connection state of the machine and of the server, in the top bar. */

import { Tooltip } from "@mantine/core";
import { useMachines } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./panels.module.css";

export function MachineChip() {
  const connection = useUiStore((ui) => ui.connection);
  const chosen = useUiStore((ui) => ui.machine);
  const { data: machines, isError } = useMachines();
  const machine = machines?.find(({ name }) => name === chosen) ?? machines?.[0];
  const lost = connection === "broken" || isError;
  const there = !lost && machine?.gateway === "connected";
  const label = lost
    ? "The knifetip server does not answer; trying again"
    : machine === undefined
      ? "Loading machines"
      : there
        ? `${machine.name} is connected`
        : `${machine.name} is not connected: jobs wait in the queue`;
  return (
    <Tooltip label={label}>
      <span
        className={css.badge}
        data-tone={lost ? "red" : there ? "green" : "grey"}
        data-testid="machine-status"
        role="status"
      >
        <span className={css.dot} style={{ width: 7, height: 7, background: "var(--tone)" }} />
        {lost ? "No connection" : (machine?.name ?? "…")}
        {!lost &&
          machine !== undefined &&
          ` · ${there ? (machine.job === null ? "idle" : "busy") : "offline"}`}
      </span>
    </Tooltip>
  );
}
