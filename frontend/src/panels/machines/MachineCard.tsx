/** One machine: its state, the sheet on its table, its queue and its tools. */

import { Anchor, Badge, Box, Button, Flex, Paper, Text, Title } from "@mantine/core";
import { IconArrowRight } from "@tabler/icons-react";
import type { Machine } from "../../api/machines";
import { translate } from "../../language/translate";
import { MACHINE_COLOURS, MACHINE_WORDS, useMachineWord } from "../../state/job/useMachineState";
import { useBoardTitle, useQueue } from "../../state/queries";
import { machineAddress, stationAddress } from "../../state/routes";
import { PairedDevices } from "../accounts/PairedDevices";
import { MachineQueue } from "../job/MachineQueue";
import { MachineTools } from "../job/MachineTools";
import { Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { TablePicture } from "./TablePicture";

export function MachineCard({ machine }: { machine: Machine }) {
  const word = useMachineWord(machine.name);
  const title = machine.title || machine.name;
  return (
    <Paper
      component="section"
      radius={12}
      bg="var(--panel)"
      style={{ overflow: "hidden" }}
      aria-label={title}
      data-testid={`machine-${machine.name}`}
    >
      <Flex align="center" wrap="wrap" gap={10} px={16} pt={14} pb={10}>
        <Title order={2} fz={17} flex="1 1 160px">
          <Anchor
            underline="hover"
            inherit
            c="inherit"
            href={machineAddress(machine.name)}
            data-testid="only-machine"
          >
            {title}
          </Anchor>
        </Title>
        {word !== "" && (
          <Badge size="lg" color={MACHINE_COLOURS[word]}>
            {MACHINE_WORDS[word]}
          </Badge>
        )}
        <Button
          component="a"
          href={stationAddress(machine.name)}
          variant="default"
          size="sm"
          rightSection={<IconArrowRight size={16} aria-hidden />}
          data-testid="open-station"
        >
          {translate("machineCard.openStation")}
        </Button>
      </Flex>
      <OnTable machine={machine.name} />
      <Box px={16} pb={12}>
        <TablePicture machine={machine} title={title} />
      </Box>
      <MachineQueue machine={machine.name} title={title} />
      <PairedDevices machine={machine.name} />
      <Section title={translate("machineCard.toolsAndConnection")} open={false} flush>
        <Note component="div" px={8} pb={6}>
          {translate("machinePanel.controllerLanguage", { title, language: machine.language })}
        </Note>
        <MachineTools machine={machine} />
      </Section>
    </Paper>
  );
}

/** The board on the table, while a job occupies the machine. */
function OnTable({ machine }: { machine: string }) {
  const { data: queue } = useQueue(machine);
  const job = queue?.entries.find(({ place }) => place === 0)?.job;
  const board = useBoardTitle(job?.board ?? "");
  return (
    <Box px={16} pb={12}>
      <Text fz={13} c="ink.2" data-testid="board-on-table">
        {job === undefined
          ? translate("machineCard.noSheetOnTheTable")
          : translate("machineCard.onTheTable", { board, name: job.drawing_name })}
      </Text>
    </Box>
  );
}
