/** Ended jobs, statistics of the machines, and the life of their tools. */

import { Button, SegmentedControl, Select, TextInput } from "@mantine/core";
import { IconSearch } from "@tabler/icons-react";
import { useState } from "react";
import type { EndedState, HistoryFilter, Job } from "../api/client";
import { errorText } from "../messages/render";
import { formatDuration, pluralize } from "../state/format";
import { useBoards, useBoardTitle, useHistory, useMachines } from "../state/queries";
import { useUiStore } from "../state/store";
import { dateTimeText } from "../state/times";
import { DrawingPicture } from "./DrawingPicture";
import css from "./history.module.css";
import { OrderLine } from "./OrderDetails";
import { ShowMore } from "./ShowMore";
import { StateBadge } from "./StateBadge";
import { StatisticsView } from "./StatisticsView";
import { ToolsView } from "./ToolsView";

const VIEWS = [
  { value: "jobs", label: "Ended jobs" },
  { value: "statistics", label: "Statistics" },
  { value: "tools", label: "Tools" },
] as const;
type View = (typeof VIEWS)[number]["value"];

const STATES: readonly { value: EndedState; label: string }[] = [
  { value: "done", label: "Finished" },
  { value: "cancelled", label: "Cancelled" },
  { value: "scrapped", label: "Board scrapped" },
  { value: "interrupted", label: "Interrupted" },
  { value: "continued", label: "Continued by another job" },
  { value: "refused", label: "Refused" },
];

const TEXT_FILTERS = [
  { field: "drawing", label: "Drawing name", testid: "history-drawing" },
  { field: "external_id", label: "Order number", testid: "history-order" },
  { field: "customer", label: "Customer", testid: "history-customer" },
] as const;

/** Periods that end now, by their length in days. */
const PERIODS = [
  { value: "", label: "All times" },
  { value: "1", label: "Last 24 hours" },
  { value: "7", label: "Last 7 days" },
  { value: "31", label: "Last 31 days" },
  { value: "366", label: "Last year" },
];

export function HistoryPage() {
  const [view, setView] = useState<View>("jobs");
  const [machine, setMachine] = useState("");
  const { data: machines } = useMachines();
  const set = useUiStore((ui) => ui.set);
  return (
    <div className={css.page} data-testid="history">
      <header className={css.head}>
        <h1>History</h1>
        <SegmentedControl
          value={view}
          onChange={(value) => setView(value as View)}
          data={[...VIEWS]}
          aria-label="What to show"
        />
        <Select
          className={css.machine ?? ""}
          aria-label="Machine"
          placeholder="All machines"
          clearable
          value={machine || null}
          onChange={(value) => setMachine(value ?? "")}
          data={(machines ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        />
        <Button
          variant="default"
          onClick={() => set({ history: false })}
          data-testid="close-history"
        >
          Back to the drawing
        </Button>
      </header>
      {view === "jobs" && <EndedJobs machine={machine} />}
      {view === "statistics" && <StatisticsView machine={machine} />}
      {view === "tools" && <ToolsView machine={machine} />}
    </div>
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
      <div className={css.filters}>
        {TEXT_FILTERS.map(({ field, label, testid }) => (
          <TextInput
            key={field}
            aria-label={label}
            placeholder={label}
            leftSection={field === "drawing" && <IconSearch size={15} aria-hidden />}
            value={filter[field] ?? ""}
            onChange={(event) => change({ [field]: event.currentTarget.value })}
            data-testid={testid}
          />
        ))}
        <Select
          aria-label="Board"
          placeholder="All boards"
          clearable
          value={filter.board || null}
          onChange={(value) => change({ board: value ?? "" })}
          data={(boards ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        />
        <Select
          aria-label="State"
          placeholder="All states"
          clearable
          value={filter.state ?? null}
          onChange={(value) => change({ state: (value as EndedState | null) ?? undefined })}
          data={[...STATES]}
        />
        <Select
          aria-label="Period"
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
      </div>
      {list.error && <p className={css.note}>{errorText(list.error)}</p>}
      {list.isSuccess && jobs.length === 0 && (
        <p className={css.note}>No job meets these conditions.</p>
      )}
      <ul className={css.jobs}>
        {jobs.map((job) => (
          <EndedJob key={job.id} job={job} />
        ))}
      </ul>
      {list.hasNextPage && (
        <ShowMore busy={list.isFetchingNextPage} act={() => void list.fetchNextPage()} />
      )}
    </>
  );
}

function EndedJob({ job }: { job: Job }) {
  const open = useUiStore((ui) => ui.open);
  const board = useBoardTitle(job.board);
  const { data: machines } = useMachines();
  return (
    <li>
      <button
        type="button"
        className={css.job}
        onClick={() => open(job.drawing, job.id)}
        data-testid="history-row"
      >
        <DrawingPicture
          className={css.picture}
          src={`/api/v1/drawings/${encodeURIComponent(job.drawing)}/picture`}
        />
        <span className={css.name}>
          {job.drawing_name}
          <OrderLine job={job} />
        </span>
        <span>{board}</span>
        <span>{machines?.find(({ name }) => name === job.machine)?.title || job.machine}</span>
        <span className={css.figure}>
          {job.copies_done === job.copies
            ? pluralize(job.copies, "copy", "copies")
            : `${job.copies_done} of ${pluralize(job.copies, "copy", "copies")}`}
        </span>
        <span className={css.figure}>{formatDuration(job.seconds * job.copies)}</span>
        <time className={css.figure} dateTime={job.ended ?? ""}>
          {job.ended == null ? "" : dateTimeText(job.ended)}
        </time>
        <StateBadge job={job} />
      </button>
    </li>
  );
}
