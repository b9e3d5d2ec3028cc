/** Ended jobs, statistics of the machines, and the life of their tools. */

import { type HistoryView, showDrawing, showHistory } from "../../state/routes";
import "../../messages/load";
import { Flex, SegmentedControl, Select, SimpleGrid, Text, TextInput, Title } from "@mantine/core";
import { IconSearch } from "@tabler/icons-react";
import { useState } from "react";
import type { EndedState, HistoryFilter, Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formatDuration } from "../../state/format";
import { figureText, LISTED_FACTS } from "../../state/job/figures";
import {
  useBoards,
  useBoardTitle,
  useHistory,
  useMachines,
  useMachineTitles,
} from "../../state/queries";
import { dateTimeText } from "../../state/times";
import { StateBadge } from "../job/StateBadge";
import { OrderLine } from "../order/OrderDetails";
import { DrawingPicture } from "../shared/DrawingPicture";
import panels from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { ShowMore } from "../shared/ShowMore";
import css from "./history.module.css";
import { StatisticsView } from "./StatisticsView";
import { ToolsView } from "./ToolsView";

const VIEWS = [
  { value: "jobs", label: translate("historyPage.endedJobs") },
  { value: "statistics", label: translate("historyPage.statistics") },
  { value: "tools", label: translate("historyPage.tools") },
] as const satisfies readonly { value: HistoryView; label: string }[];

const STATES: readonly { value: EndedState; label: string }[] = [
  { value: "done", label: translate("historyPage.finished") },
  { value: "cancelled", label: translate("historyPage.cancelled") },
  { value: "scrapped", label: translate("historyPage.boardScrapped") },
  { value: "interrupted", label: translate("historyPage.interrupted") },
  { value: "continued", label: translate("historyPage.continuedByAnotherJob") },
  { value: "refused", label: translate("historyPage.refused") },
];

const TEXT_FILTERS = [
  { field: "drawing", label: translate("historyPage.drawingName"), testid: "history-drawing" },
  { field: "external_id", label: translate("historyPage.orderNumber"), testid: "history-order" },
  { field: "customer", label: translate("historyPage.customer"), testid: "history-customer" },
] as const;

/** Periods that end now, by their length in days. */
const PERIODS = [
  { value: "", label: translate("historyPage.allTimes") },
  { value: "1", label: translate("historyPage.last24Hours") },
  { value: "7", label: translate("historyPage.last7Days") },
  { value: "31", label: translate("historyPage.last31Days") },
  { value: "366", label: translate("historyPage.lastYear") },
];

interface Props {
  readonly view: HistoryView;
}

export function HistoryPage({ view }: Props) {
  const [machine, setMachine] = useState("");
  const { data: machines } = useMachines();
  return (
    <main className={panels.page} data-touch data-testid="history">
      <header className={panels.head}>
        <Title order={1} fz={22}>
          {translate("historyPage.history")}
        </Title>
        <SegmentedControl
          value={view}
          onChange={(value) => showHistory(value as HistoryView)}
          data={[...VIEWS]}
          aria-label={translate("historyPage.whatToShow")}
        />
        <Select
          w={200}
          aria-label={translate("historyPage.machine")}
          placeholder={translate("historyPage.allMachines")}
          clearable
          value={machine || null}
          onChange={(value) => setMachine(value ?? "")}
          data={(machines ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        />
      </header>
      {view === "jobs" && <EndedJobs machine={machine} />}
      {view === "statistics" && <StatisticsView machine={machine} />}
      {view === "tools" && <ToolsView machine={machine} />}
    </main>
  );
}

function EndedJobs({ machine }: { machine: string }) {
  const { data: boards } = useBoards();
  const [filter, setFilter] = useState<Omit<HistoryFilter, "machine">>({});
  const [days, setDays] = useState("");
  const change = (part: Partial<HistoryFilter>) => setFilter({ ...filter, ...part });
  const list = useHistory({ ...filter, machine });
  const jobs = list.data ?? [];
  return (
    <>
      <SimpleGrid cols={{ base: 2, sm: 3, md: 6 }} spacing={8} mb={12}>
        {TEXT_FILTERS.map(({ field, label, testid }) => (
          <TextInput
            key={field}
            aria-label={label}
            placeholder={label}
            leftSection={field === "drawing" && <IconSearch size={15} aria-hidden />}
            leftSectionWidth={30}
            value={filter[field] ?? ""}
            onChange={(event) => change({ [field]: event.currentTarget.value })}
            data-testid={testid}
          />
        ))}
        <Select
          aria-label={translate("historyPage.board")}
          placeholder={translate("historyPage.allBoards")}
          clearable
          value={filter.board || null}
          onChange={(value) => change({ board: value ?? "" })}
          data={(boards ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        />
        <Select
          aria-label={translate("historyPage.state")}
          placeholder={translate("historyPage.allStates")}
          clearable
          value={filter.state ?? null}
          onChange={(value) => change({ state: (value as EndedState | null) ?? undefined })}
          data={[...STATES]}
        />
        <Select
          aria-label={translate("historyPage.period")}
          value={days}
          allowDeselect={false}
          onChange={(value) => {
            setDays(value ?? "");
            // Rounded, so that the same period is the same request.
            const since = Math.floor(Date.now() / 3.6e6) * 3600 - Number(value) * 86_400;
            change({ since: value ? since : undefined });
          }}
          data={PERIODS}
        />
      </SimpleGrid>
      {list.error && (
        <Note py={32} fz={14} ta="center">
          {errorText(list.error)}
        </Note>
      )}
      {list.isSuccess && jobs.length === 0 && (
        <Note py={32} fz={14} ta="center">
          {translate("historyPage.noJobMeetsTheseConditions")}
        </Note>
      )}
      <Flex component="ul" direction="column" gap={6}>
        {jobs.map((job) => (
          <EndedJob key={job.id} job={job} />
        ))}
      </Flex>
      {list.hasNextPage && (
        <ShowMore busy={list.isFetchingNextPage} act={() => void list.fetchNextPage()} />
      )}
    </>
  );
}

function EndedJob({ job }: { job: Job }) {
  const board = useBoardTitle(job.board);
  const machine = useMachineTitles()(job.machine);
  return (
    <li>
      <button
        type="button"
        className={css.job}
        onClick={() => showDrawing(job.drawing, job.id, "check")}
        data-testid="history-row"
      >
        <DrawingPicture
          className={css.picture}
          src={`/api/v1/drawings/${encodeURIComponent(job.drawing)}/picture`}
        />
        <Text span flex="2 1 200px" c="ink.0" fw={600}>
          {job.drawing_name}
          <OrderLine job={job} />
        </Text>
        <Text span flex="1 1 160px">
          {board}
          <br />
          {machine}
        </Text>
        <Text span flex="0 1 120px">
          {job.copies_done === job.copies
            ? translate("historyPage.copies", { copies: job.copies })
            : translate("historyPage.ofCopies", {
                copiesDone: job.copies_done,
                copies: job.copies,
              })}
          <br />
          {formatDuration(job.seconds * job.copies)}
          {LISTED_FACTS.map(({ name, unit }) =>
            job[name] === 0 ? null : (
              <Text key={name} span display="block" data-testid={`listed-${name}`}>
                {`${translate(`fact.${name}`)}: ${figureText(job[name], unit)}`}
              </Text>
            ),
          )}
        </Text>
        <Flex component="span" direction="column" align="flex-end" gap={4} flex="1 0 150px">
          <StateBadge job={job} />
          <span>
            {job.started != null && (
              <>
                <time dateTime={job.started}>{dateTimeText(job.started)}</time>
                {" – "}
              </>
            )}
            <time dateTime={job.ended ?? ""}>
              {job.ended == null ? "" : dateTimeText(job.ended)}
            </time>
          </span>
        </Flex>
      </button>
    </li>
  );
}
