/** The tools of machines: the length that each has worked, its life, and its changes. */

import { Box, Button, Flex, NumberInput, Paper, Text, Title } from "@mantine/core";
import { IconRefresh } from "@tabler/icons-react";
import { type CSSProperties, useState } from "react";
import type { ToolUse } from "../../api/machines";
import { formatDate } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { recordToolChange, setToolLife } from "../../state/actions";
import { formatMetres } from "../../state/format";
import { useMachines, useTools } from "../../state/queries";
import { Refusal } from "../accounts/Permitted";
import { ConfirmDialog } from "../shared/ConfirmDialog";
import { StationNumber } from "../shared/parts";
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
    <Paper component="section" radius={12} p={16} mb={14} data-testid={`tools-of-${machine}`}>
      <Title order={2} fz={15} mb={10}>
        {title}
      </Title>
      <ul>
        {(tools ?? []).map((tool) => (
          <Tool key={tool.station} machine={machine} tool={tool} refusal={refusal} />
        ))}
      </ul>
      <Refusal reason={refusal} />
    </Paper>
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
    <Flex
      component="li"
      className={css.row}
      align="center"
      wrap="wrap"
      gap="6px 14px"
      data-warning={warning}
      data-testid="tool"
    >
      <StationNumber size={26} fz={13}>
        {station}
      </StationNumber>
      <Text span flex="1 1 180px" c="ink.0" fw={550}>
        {name}
        <Text span display="block" fz={11.5} fw={400} c="ink.3">
          {tool.changed === null
            ? translate("toolsView.noChangeRecorded")
            : translate("toolsView.changed", {
                changed: formatDate(new Date(tool.changed)),
                changedBy: tool.changed_by,
              })}
        </Text>
      </Text>
      <Box
        flex="2 1 240px"
        className={css.bar}
        style={{ "--share": `${Math.min(100, share * 100)}%` } as CSSProperties}
      >
        {tool.life > 0
          ? `${translate("toolsView.of", { used: formatMetres(used), life: formatMetres(tool.life) })} · ${Math.round(share * 100)} %`
          : formatMetres(used)}
      </Box>
      <NumberInput
        aria-label={translate("toolsView.lifeOfInMetres0", { name })}
        w={170}
        hideControls
        min={0}
        max={1e7}
        decimalScale={1}
        thousandSeparator=" "
        suffix=" m"
        leftSection={translate("toolsView.life")}
        leftSectionWidth={72}
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
        <Text flex="1 0 100%" fz={12.5} c="var(--warn-ink)" role="status">
          {messageText(message)} {messageHint(message)}
        </Text>
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
    </Flex>
  );
}
