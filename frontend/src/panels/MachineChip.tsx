/** In the top bar: is the table there, and is the line to the service up? */

import { Tooltip } from "@mantine/core";
import { useMachines } from "../state/queries";
import { usePage } from "../state/store";
import css from "./panels.module.css";

export function MachineChip() {
  const line = usePage((page) => page.line);
  const chosen = usePage((page) => page.machine);
  const { data: machines, isError } = useMachines();
  const machine = machines?.find(({ name }) => name === chosen) ?? machines?.[0];
  const lost = line === "broken" || isError;
  const there = !lost && machine?.gateway === "connected";
  const says = lost
    ? "knifetip does not answer; trying again"
    : machine === undefined
      ? "Asking for the machines"
      : there
        ? `The gateway of ${machine.name} is connected`
        : `No gateway has called for ${machine.name}: jobs will wait in the queue`;
  return (
    <Tooltip label={says}>
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
          ` · ${there ? (machine.job === null ? "idle" : "busy") : "absent"}`}
      </span>
    </Tooltip>
  );
}
