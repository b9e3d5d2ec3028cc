/** The queue of one machine in the order in which its jobs run; rows are dragged by their grips. */

import {
  ActionIcon,
  Badge,
  Box,
  Flex,
  Group,
  Menu,
  NumberInput,
  Progress,
  Text,
} from "@mantine/core";
import {
  IconArrowDown,
  IconArrowUp,
  IconCheck,
  IconDots,
  IconPlayerPause,
  IconPlayerPlay,
} from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import type { Machine, QueueEntry } from "../../api/machines";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { changeJob, moveJob, transferJob } from "../../state/actions";
import { formatDuration } from "../../state/format";
import { isOnTable, waitsAtMachine } from "../../state/job/jobs";
import {
  neighboursAt,
  PRIORITIES,
  priorityTitle,
  startText,
  waitingIds,
} from "../../state/job/queue";
import { useBoardTitle, useMachines, useQueue } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { OrderLine } from "../order/OrderDetails";
import { DrawingPicture } from "../shared/DrawingPicture";
import panels from "../shared/panels.module.css";
import { Figure, Note } from "../shared/parts";
import { Section } from "../shared/Section";
import { Grip, SortableRows, useSortableRow } from "../shared/Sortable";
import css from "./job.module.css";
import { StateBadge } from "./StateBadge";
import { WaitsAtMachine } from "./WaitsAtMachine";

export function MachineQueue({ machine, title }: { machine: string; title: string }) {
  const { data: queue } = useQueue(machine);
  const reason = useRefusal("POST /api/v1/jobs/{id}/move");
  const entries = queue?.entries ?? [];
  const ids = waitingIds(entries);

  const moveTo = (id: string, index: number) => {
    const neighbours = neighboursAt(ids, id, index);
    if (neighbours !== null) void moveJob(id, machine, neighbours);
  };
  const nameOf = (id: string) => entries.find(({ job }) => job.id === id)?.job.drawing_name ?? "";

  return (
    <Section
      title={translate("machineQueue.queueOf", { title })}
      flush
      aside={
        <Figure>
          {ids.length > 0 ? translate("machineQueue.waiting", { ids: ids.length }) : ""}
        </Figure>
      }
    >
      {entries.length > 0 && reason !== null && (
        <Note mx={8} mb={8} data-testid="role-reason">
          {reason}
        </Note>
      )}
      {entries.length === 0 && (
        <Note mx={8} mb={8}>
          {translate("machineQueue.noJobWaitsForThis")}
        </Note>
      )}
      <SortableRows
        ids={ids}
        howTo={translate("machineQueue.howToMove")}
        nameOf={nameOf}
        onMove={(from, to) => moveTo(ids[from] ?? "", to)}
      >
        <Flex
          component="ol"
          direction="column"
          gap={4}
          data-touch
          data-testid={`queue-of-${machine}`}
        >
          {entries.map((entry) => (
            <Entry
              key={entry.job.id}
              entry={entry}
              last={entry.place === ids.length}
              fixed={entry.place === 0 || reason !== null}
              moveTo={(index) => moveTo(entry.job.id, index)}
            />
          ))}
        </Flex>
      </SortableRows>
    </Section>
  );
}

interface EntryProps {
  entry: QueueEntry;
  last: boolean;
  /** The job cannot be moved. */
  fixed: boolean;
  moveTo: (index: number) => void;
}

function Entry({ entry, last, fixed, moveTo }: EntryProps) {
  const { job, place } = entry;
  const { row, grip } = useSortableRow({ id: job.id, disabled: fixed });
  return (
    <li {...row} className={css.entry} data-place={place} data-hold={job.on_hold}>
      <Flex align="center">
        {!fixed && (
          <Grip
            grip={grip}
            label={translate("machineQueue.drag", { name: job.drawing_name, place })}
            testId="drag-job"
          />
        )}
        <Row entry={entry} />
      </Flex>
      {!fixed && (
        <Actions
          entry={entry}
          last={last}
          move={(step) => moveTo(place - 1 + step)}
          toTop={() => moveTo(0)}
        />
      )}
      {waitsAtMachine(job) && (
        <Box px={8} pb={8}>
          <WaitsAtMachine job={job} />
        </Box>
      )}
    </li>
  );
}

function Row({ entry }: { entry: QueueEntry }) {
  const { job, place } = entry;
  const board = useBoardTitle(job.board);
  return (
    <button
      type="button"
      className={panels.pick}
      style={{ flexWrap: "wrap" }}
      onClick={() => showDrawing(job.drawing, job.id, "check")}
      data-testid="queue-row"
    >
      <Text span w={20} ta="center" c="ink.2" fw={650}>
        {place > 0 ? place : "▶"}
      </Text>
      <DrawingPicture className={css.picture} src={entry.picture} />
      <span className={css.text}>
        <Text span fw={550}>
          {job.drawing_name}
        </Text>
        <small>{`${board} · ${job.copies_done > 0 ? translate("machineQueue.copiesDone", { copies: job.copies, copiesDone: job.copies_done }) : translate("machineQueue.copies", { copies: job.copies })}`}</small>
        <small>
          {[entry.seconds > 0 ? formatDuration(entry.seconds) : "", startText(entry)]
            .filter((text) => text !== "")
            .join(" · ")}
        </small>
        <small data-testid="queue-id">{job.id}</small>
        <OrderLine job={job} />
        {place === 0 && <StateBadge job={job} />}
      </span>
      {place > 0 && job.priority !== 0 && (
        <Badge
          component="span"
          color={{ Urgent: "red", High: "yellow" }[priorityTitle(job.priority)] ?? "gray"}
        >
          {priorityTitle(job.priority)}
        </Badge>
      )}
      {isOnTable(job) && (
        <Progress
          flex="1 0 100%"
          value={job.progress * 100}
          size={3}
          color={job.state === "held" ? "yellow" : "blue"}
          aria-label={translate("machineQueue.progressOf", { drawingName: job.drawing_name })}
        />
      )}
    </button>
  );
}

interface ActionsProps {
  entry: QueueEntry;
  last: boolean;
  /** Move the job by some places: -1 is one place earlier. */
  move: (step: number) => void;
  toTop: () => void;
}

function Actions({ entry: { job, place }, last, move, toTop }: ActionsProps) {
  const { data: machines } = useMachines();
  // What is being typed, also when it is empty; null: nothing is typed.
  const [copies, setCopies] = useState<number | string | null>(null);
  const name = job.drawing_name;
  return (
    <Group gap={2} px={6} pb={4} justify="flex-end" wrap="nowrap">
      <Icon
        label={translate("machineQueue.moveUp", { name })}
        off={place === 1}
        act={() => move(-1)}
        testId="move-up"
      >
        <IconArrowUp size={17} />
      </Icon>
      <Icon
        label={translate("machineQueue.moveDown", { name })}
        off={last}
        act={() => move(1)}
        testId="move-down"
      >
        <IconArrowDown size={17} />
      </Icon>
      <Icon
        label={
          job.on_hold
            ? translate("machineQueue.endTheHoldOf", { name })
            : translate("machineQueue.holdInTheQueue", { name })
        }
        act={() => void changeJob(job.id, { on_hold: !job.on_hold })}
        testId="queue-hold"
      >
        {job.on_hold ? <IconPlayerPlay size={17} /> : <IconPlayerPause size={17} />}
      </Icon>
      <NumberInput
        flex={1}
        miw={64}
        maw={92}
        mx="auto"
        aria-label={translate("machineQueue.copiesOf", { name })}
        size="xs"
        min={job.copies_done + 1}
        max={1000}
        allowDecimal={false}
        suffix="×"
        value={copies ?? job.copies}
        onChange={setCopies}
        onBlur={() => {
          if (typeof copies === "number" && copies !== job.copies)
            void changeJob(job.id, { copies });
          setCopies(null);
        }}
        onKeyDown={(event) => event.key === "Enter" && event.currentTarget.blur()}
        data-testid="queue-copies"
      />
      <Menu position="bottom-end" shadow="md" withinPortal>
        <Menu.Target>
          <ActionIcon
            size={34}
            variant="subtle"
            color="gray"
            aria-label={translate("machineQueue.priorityAndMachineOf", { name })}
            data-testid="queue-more"
          >
            <IconDots size={17} />
          </ActionIcon>
        </Menu.Target>
        <Menu.Dropdown>
          <Menu.Item disabled={place === 1} onClick={toTop}>
            {translate("machineQueue.moveToTheTop")}
          </Menu.Item>
          <Menu.Label>{translate("machineQueue.priority")}</Menu.Label>
          {PRIORITIES.map(({ value, title }) => (
            <Menu.Item
              key={value}
              rightSection={priorityTitle(job.priority) === title && <IconCheck size={14} />}
              onClick={() => void changeJob(job.id, { priority: value })}
            >
              {title}
            </Menu.Item>
          ))}
          <Menu.Label>{translate("machineQueue.moveToMachine")}</Menu.Label>
          {(machines ?? [])
            .filter((machine) => machine.name !== job.machine)
            .map((machine: Machine) => (
              <Menu.Item key={machine.name} onClick={() => void transferJob(job.id, machine.name)}>
                {machine.title || machine.name}
              </Menu.Item>
            ))}
        </Menu.Dropdown>
      </Menu>
    </Group>
  );
}

interface IconProps {
  label: string;
  act: () => void;
  off?: boolean;
  testId: string;
  children: ReactNode;
}

function Icon({ label, act, off = false, testId, children }: IconProps) {
  return (
    <ActionIcon
      size={34}
      variant="subtle"
      color="gray"
      aria-label={label}
      title={label}
      disabled={off}
      onClick={act}
      data-testid={testId}
    >
      {children}
    </ActionIcon>
  );
}
