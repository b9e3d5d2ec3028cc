/** The lines of the program, in step with the slider and the tool in both directions. */

import { NumberInput } from "@mantine/core";
import { useQueries } from "@tanstack/react-query";
import { useVirtualizer } from "@tanstack/react-virtual";
import { type KeyboardEvent, useEffect, useId, useRef, useState } from "react";
import type { Job } from "../../api/jobs";
import { linesAt, timeOfLine } from "../../geometry/programLines";
import { type Timeline, totalSeconds } from "../../geometry/timeline";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { isOnTable } from "../../state/job/jobs";
import { queries } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Note } from "../shared/parts";
import css from "./check.module.css";

/** Height of a line, for a mouse and for a finger (pixels). */
const LINE = 24;
const LINE_TOUCH = 36;
/** Lines of one request, and lines of one key press of Page up and Page down. */
const PART = 400;
const PAGE = 10;

interface Props {
  readonly job: Job;
  readonly timeline: Timeline;
}

export function ProgramLines({ job, timeline }: Props) {
  const { current, first, last, go } = useCurrentLine(job, timeline);
  const list = useRef<HTMLDivElement>(null);
  const id = useId();
  const running = isOnTable(job);
  const [height] = useState(() =>
    window.matchMedia("(pointer:coarse)").matches ? LINE_TOUCH : LINE,
  );
  const virtual = useVirtualizer({
    count: job.lines,
    getScrollElement: () => list.current,
    estimateSize: () => height,
    overscan: 10,
  });
  const shown = virtual.getVirtualItems();
  const { textOf, error } = useLines(job, shown.at(0)?.index ?? 0, shown.at(-1)?.index ?? 0);
  useEffect(() => {
    if (current > 0) virtual.scrollToIndex(current - 1, { align: "auto" });
  }, [virtual, current]);
  const isShown = shown.some(({ index }) => index + 1 === current);
  return (
    <>
      <NumberInput
        size="xs"
        mb={8}
        label={translate("programLines.goToLine", { lines: job.lines })}
        value={current > 0 ? current : ""}
        min={1}
        max={job.lines}
        allowDecimal={false}
        allowNegative={false}
        disabled={running}
        onChange={(line) => {
          if (typeof line === "number" && line >= 1 && line <= job.lines) go(line);
        }}
        data-testid="program-go-to"
      />
      <div
        ref={list}
        className={css.lines}
        role="listbox"
        tabIndex={0}
        aria-label={translate("programLines.linesOfTheProgram")}
        aria-disabled={running}
        aria-activedescendant={isShown ? `${id}-${current}` : undefined}
        onKeyDown={(event) => {
          const line = lineOfKey(event, current, job.lines);
          if (line === null || running) return;
          event.preventDefault();
          event.stopPropagation();
          go(line);
        }}
        data-testid="program-lines"
        data-line={current}
      >
        <div className={css.sheet} role="presentation" style={{ height: virtual.getTotalSize() }}>
          {shown.map(({ index, start, size }) => (
            // biome-ignore lint/a11y/useKeyWithClickEvents: the list has the keys
            // biome-ignore lint/a11y/useFocusableInteractive: the list has the focus
            <div
              key={index}
              id={`${id}-${index + 1}`}
              className={css.line}
              role="option"
              aria-selected={index + 1 === current}
              aria-setsize={job.lines}
              aria-posinset={index + 1}
              data-in-move={index + 1 >= first && index + 1 <= last}
              style={{ height: size, transform: `translateY(${start}px)` }}
              onClick={() => {
                if (!running) go(index + 1);
              }}
            >
              <span className={css.number}>{index + 1}</span>
              <span>{textOf(index) ?? "…"}</span>
            </div>
          ))}
        </div>
      </div>
      <Note mt={6}>
        {error === null ? translate("programLines.eachLineShowsItsPlace") : errorText(error)}
      </Note>
    </>
  );
}

/** The line of the program for a key of the list; null for other keys. */
function lineOfKey({ key }: KeyboardEvent, current: number, lines: number): number | null {
  const steps: Readonly<Record<string, number>> = {
    ArrowUp: current - 1,
    ArrowDown: current + 1,
    PageUp: current - PAGE,
    PageDown: current + PAGE,
    Home: 1,
    End: lines,
  };
  const line = steps[key];
  return line === undefined ? null : Math.min(lines, Math.max(1, line));
}

/** The line of the program at the time of the slider, and a function that moves both to a line. */
function useCurrentLine(job: Job, timeline: Timeline) {
  const previewTime = useUiStore((ui) => ui.previewTime);
  const set = useUiStore((ui) => ui.set);
  // Lines that move nothing have the time of the next move: the chosen line stays until it changes.
  const [chosen, setChosen] = useState<{ line: number; time: number } | null>(null);
  const go = (line: number) => {
    const time = timeOfLine(timeline, line);
    setChosen({ line, time });
    set({ previewTime: time });
  };
  if (isOnTable(job)) return { current: job.line, first: job.line, last: job.line, go };
  const time = previewTime ?? (job.state === "done" ? totalSeconds(timeline) : null);
  const at = time === null ? null : linesAt(timeline, time);
  if (chosen !== null && chosen.time === previewTime) {
    const isInMove = at !== null && chosen.line >= at.first && chosen.line <= at.last;
    const { first, last } = isInMove ? at : { first: chosen.line, last: chosen.line };
    return { current: chosen.line, first, last, go };
  }
  return { ...(at ?? { current: 0, first: 0, last: 0 }), go };
}

/** Texts of the lines between two indices, fetched in parts. */
function useLines(job: Job, from: number, to: number) {
  const begin = Math.floor(from / PART);
  const parts = Math.floor(to / PART) - begin + 1;
  const answers = useQueries({
    queries: Array.from({ length: parts }, (_, at) =>
      queries.programLines(job.id, (begin + at) * PART + 1, PART),
    ),
  });
  return {
    textOf: (index: number): string | undefined =>
      answers[Math.floor(index / PART) - begin]?.data?.[index % PART],
    error: answers.find(({ error }) => error !== null)?.error ?? null,
  };
}
