/** The tools of machines: the length that each has worked, its life, and its changes. */

import { Button, NumberInput } from "@mantine/core";
import { IconRefresh } from "@tabler/icons-react";
import { useState } from "react";
import type { ToolUse } from "../../api/client";
import { formatDate } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { recordToolChange, setToolLife } from "../../state/actions";
import { formatMetres } from "../../state/format";
import { useMachines, useTools } from "../../state/queries";
import { Refusal } from "../accounts/Permitted";
import { ConfirmDialog } from "../shared/ConfirmDialog";
import css from "./history.module.css";

export function ToolsView({ machine }: { machine: string }) {
  const { data: machines } = useMachines();
  const shown = (machines ?? []).filter(({ name }) => machine === "" || name === machine);
  return shown.map(({ name, title }) => (
    <MachineTools key={name} machine={name} title={title || name} />
  ));
}

function MachineTools({ machine, title }: { machine: string; title: string }) {
  const { data: tools } = useTools(machine);
  const refusal = useRefusal("POST /api/v1/machines/{name}/tools/{station}/changed");
  return (
    <section className={css.card} data-testid={`tools-of-${machine}`}>
      <h2>{title}</h2>
      <ul className={css.tools}>
        {(tools ?? []).map((tool) => (
          <Tool key={tool.station} machine={machine} tool={tool} refusal={refusal} />
        ))}
      </ul>
      <Refusal reason={refusal} />
    </section>
  );
}

interface ToolProps {
  readonly machine: string;
  readonly tool: ToolUse;
  /** Why the person may change nothing; null: may. */
  readonly refusal: string | null;
}

function Tool({ machine, tool, refusal }: ToolProps) {
  const [asked, setAsked] = useState(false);
  // What is being typed, also when it is empty; null: nothing is typed.
  const [life, setLife] = useState<number | string | null>(null);
  const { station, name, used, share, warning, message } = tool;
  return (
    <li className={css.tool} data-warning={warning} data-testid="tool">
      <span className={css.station}>{station}</span>
      <span className={css.toolName}>
        {name}
        <small>
          {tool.changed === null
            ? translate("toolsView.noChangeRecorded")
            : translate("toolsView.changed", {
                changed: formatDate(new Date(tool.changed)),
                changedBy: tool.changed_by,
              })}
        </small>
      </span>
      <span className={css.wear}>
        <span className={css.track}>
          <span className={css.fill} style={{ width: `${Math.min(100, share * 100)}%` }} />
          <span className={css.onBar}>
            {tool.life > 0
              ? `${translate("toolsView.of", { used: formatMetres(used), life: formatMetres(tool.life) })} · ${Math.round(share * 100)} %`
              : formatMetres(used)}
          </span>
        </span>
      </span>
      <NumberInput
        aria-label={translate("toolsView.lifeOfInMetres0", { name })}
        className={css.life ?? ""}
        min={0}
        max={1e7}
        decimalScale={1}
        thousandSeparator=" "
        suffix=" m"
        leftSection={translate("toolsView.life")}
        leftSectionWidth={44}
        disabled={refusal !== null}
        title={refusal ?? undefined}
        value={life ?? tool.life}
        onChange={setLife}
        onBlur={() => {
          if (typeof life === "number" && life !== tool.life)
            void setToolLife(machine, station, life);
          setLife(null);
        }}
        onKeyDown={(event) => event.key === "Enter" && event.currentTarget.blur()}
        data-testid="tool-life"
      />
      <Button
        variant={warning === "" ? "default" : "filled"}
        leftSection={<IconRefresh size={16} aria-hidden />}
        disabled={refusal !== null}
        title={refusal ?? undefined}
        onClick={() => setAsked(true)}
        data-testid="tool-changed"
      >
        {translate("toolsView.toolChanged")}
      </Button>
      {message !== null && (
        <p className={css.warning} role="status">
          {messageText(message)} {messageHint(message)}
        </p>
      )}
      <ConfirmDialog
        confirmation={
          asked
            ? {
                title: translate("toolsView.isThereANewTool", { station }),
                text: translate("toolsView.theRecordedLengthOfBecomes", { name }),
                yes: translate("toolsView.toolWasChanged"),
                no: translate("toolsView.notChanged"),
              }
            : null
        }
        onYes={() => {
          setAsked(false);
          void recordToolChange(machine, station);
        }}
        onNo={() => setAsked(false)}
      />
    </li>
  );
}
