/** Chooses where another job continues a sheet: in a picture of the tracks, or in their list. */

import {
  Box,
  Button,
  Checkbox,
  Flex,
  Group,
  NumberInput,
  SegmentedControl,
  Stack,
  Text,
} from "@mantine/core";
import { IconPlayerTrackNext } from "@tabler/icons-react";
import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from "react";
import type { Job, Track } from "../../api/jobs";
import type { Toolpath } from "../../geometry/records";
import { translate } from "../../language/translate";
import { continueJob } from "../../state/actions";
import {
  chosenTracks,
  madeTracks,
  openTracks,
  proposedTrack,
  type RestMode,
  restChoice,
  type Statement,
  statedChoice,
  trackNumbers,
  trackOfLine,
  trackOutlines,
  unconfirmedTracks,
  workBox,
} from "../../state/job/rest";
import { useToolpathOf, useTracks } from "../../state/queries";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Figure, Note } from "../shared/parts";
import css from "./job.module.css";
import { RemainingCopies } from "./RemainingCopies";

const MODES: readonly { value: RestMode; label: string }[] = [
  { value: "from", label: translate("restPanel.continueFromHere") },
  { value: "tool", label: translate("restPanel.onlyThisTool") },
  { value: "whole", label: translate("restPanel.oneMoreCopy") },
];

const STATES: Readonly<Record<Track["state"], string>> = {
  cut: translate("restPanel.cut"),
  begun: translate("restPanel.begun"),
  uncut: translate("restPanel.notCut"),
  unknown: translate("restPanel.notKnown"),
};

/** The tracks of a job's program; the user chooses those that a new job makes, and orders it. */
export function RestPanel({ job }: { job: Job }) {
  const { data: tracks, error } = useTracks(job);
  const { data: toolpath } = useToolpathOf(job.id);
  const busy = useUiStore((ui) => ui.busy);
  const [mode, setMode] = useState<RestMode>("from");
  const [picked, setPicked] = useState<number | null>(null);
  const [made, setMade] = useState(false);
  const [uncut, setUncut] = useState(false);
  const [stated, setStated] = useState<Statement>({});
  if (error !== null)
    return (
      <Note component="div" fz={13} c="ink.2">
        {error.message}
      </Note>
    );
  if (tracks === undefined || tracks.length === 0) return null;
  const asks = mode !== "whole" && tracks.some(({ state }) => state === "unknown");
  if (asks) {
    return (
      <Stack gap={10} data-testid="rest">
        <RemainingCopies job={job} />
        <StatementForm
          job={job}
          tracks={tracks}
          toolpath={toolpath}
          stated={stated}
          busy={busy}
          onState={(number, made) => setStated({ ...stated, [number]: made })}
          onWhole={() => setMode("whole")}
        />
      </Stack>
    );
  }
  const first = picked ?? proposedTrack(tracks);
  const chosen = chosenTracks(tracks, mode, first);
  const unconfirmed = mode === "whole" ? [] : unconfirmedTracks(tracks, mode, first);
  const again = mode === "whole" ? [] : chosen.filter(({ state }) => state === "cut");
  const pick = (number: number) => {
    setPicked(number);
    setMade(false);
    setUncut(false);
    if (mode === "whole") setMode("from");
  };
  return (
    <Stack gap={10} data-testid="rest">
      <RemainingCopies job={job} />
      {toolpath !== undefined && (
        <TrackPicture tracks={tracks} toolpath={toolpath} chosen={chosen} onPick={pick} />
      )}
      <Legend />
      <TrackList tracks={tracks} chosen={chosen} first={first} job={job} onPick={pick} />
      <NumberInput
        label={translate("restPanel.orBeginAtAProgram")}
        description={translate("restPanel.theNewJobBeginsWith")}
        placeholder={translate("restPanel.line")}
        size="lg"
        hideControls
        min={1}
        max={job.lines}
        allowDecimal={false}
        onChange={(line) => {
          const number = typeof line === "number" ? trackOfLine(tracks, line) : null;
          if (number !== null) pick(number);
        }}
        data-testid="rest-line"
      />
      <SegmentedControl
        fullWidth
        size="sm"
        classNames={{ label: css.mode ?? "" }}
        data={[...MODES]}
        value={mode}
        onChange={(value) => {
          setMode(value as RestMode);
          setMade(false);
          setUncut(false);
        }}
        data-testid="rest-mode"
      />
      <Note component="div" fz={13} c="ink.2" role="status" data-testid="rest-summary">
        {summaryOf(tracks, chosen, mode)}
      </Note>
      {unconfirmed.length > 0 && (
        <Checkbox
          checked={made}
          onChange={(event) => setMade(event.currentTarget.checked)}
          label={translate("restPanel.iHaveCheckedOnThe", {
            count: unconfirmed.length,
            tracks: trackNumbers(unconfirmed),
          })}
          data-testid="rest-made"
        />
      )}
      {again.length > 0 && (
        <Checkbox
          checked={uncut}
          onChange={(event) => setUncut(event.currentTarget.checked)}
          label={translate("restPanel.iHaveCheckedOnThe2", {
            count: again.length,
            tracks: trackNumbers(again),
          })}
          data-testid="rest-uncut"
        />
      )}
      <Button
        size="md"
        leftSection={<IconPlayerTrackNext size={16} aria-hidden />}
        disabled={busy || (unconfirmed.length > 0 && !made)}
        onClick={() => void continueJob(job.id, restChoice(tracks, mode, first, made, uncut))}
        data-testid="rest-order"
      >
        {mode === "whole"
          ? translate("restPanel.queueOneMoreCopy")
          : translate("restPanel.continueThisSheetTracksLeft", { chosen: chosen.length })}
      </Button>
    </Stack>
  );
}

interface StatementProps {
  readonly job: Job;
  readonly tracks: readonly Track[];
  readonly toolpath: Toolpath | undefined;
  readonly stated: Statement;
  readonly busy: boolean;
  readonly onState: (number: number, made: boolean) => void;
  readonly onWhole: () => void;
}

/** Nobody has seen where the machine stopped: the person states which tracks are made. */
function StatementForm({ job, tracks, toolpath, stated, busy, onState, onWhole }: StatementProps) {
  const tools = new Map(job.tools.map(({ station, name }) => [station, name]));
  const open = openTracks(tracks, stated);
  const made = madeTracks(tracks, stated);
  const rest = tracks.filter(({ number }) => !made.includes(number));
  const unknown = tracks.filter(({ state }) => state === "unknown");
  return (
    <>
      <Note fz={13} c="ink.2" data-testid="rest-statement">
        {translate("restPanel.itIsNotKnownHow", { unknown: unknown.length })}
      </Note>
      {toolpath !== undefined && (
        <TrackPicture
          tracks={tracks}
          toolpath={toolpath}
          chosen={rest.filter(({ number }) => !open.includes(number))}
          onPick={(number) => {
            if (tracks[number - 1]?.state === "unknown") onState(number, stated[number] !== true);
          }}
        />
      )}
      <Legend />
      <ol className={css.list} data-testid="rest-answers">
        {unknown.map((track) => (
          <Flex component="li" key={track.number} align="center" gap={6} mih={44} pl={10}>
            <Box component="span" flex={1}>
              {track.number}{" "}
              {tools.get(track.station) ??
                translate("restPanel.station", { station: track.station })}
            </Box>
            {[true, false].map((answer) => (
              <Button
                key={String(answer)}
                variant={stated[track.number] === answer ? "filled" : "default"}
                mih={44}
                aria-pressed={stated[track.number] === answer}
                onClick={() => onState(track.number, answer)}
                data-testid={answer ? "rest-is-made" : "rest-is-not-made"}
              >
                {answer ? translate("restPanel.made") : translate("restPanel.notMade")}
              </Button>
            ))}
          </Flex>
        ))}
      </ol>
      <Note component="div" fz={13} c="ink.2" role="status" data-testid="rest-summary">
        {open.length > 0
          ? translate("restPanel.tracksNotAnsweredYet", { open: open.length })
          : rest.length === 0
            ? translate("restPanel.allTracksAreMadeMark")
            : translate("restPanel.leaveTheSheetInIts", {
                chosen: rest.length,
                all: tracks.length,
                tracks: trackNumbers(rest),
              })}
      </Note>
      <Button
        size="md"
        leftSection={<IconPlayerTrackNext size={16} aria-hidden />}
        disabled={busy || open.length > 0 || rest.length === 0}
        onClick={() => void continueJob(job.id, statedChoice(made))}
        data-testid="rest-order"
      >
        {translate("restPanel.continueThisSheetTracksLeft", { chosen: rest.length })}
      </Button>
      <Button size="sm" variant="default" onClick={onWhole} data-testid="rest-whole">
        {translate("restPanel.makeOneMoreCopyOn")}
      </Button>
    </>
  );
}

function summaryOf(tracks: readonly Track[], chosen: readonly Track[], mode: RestMode): string {
  if (mode === "whole") {
    return translate("restPanel.clearTheTableANew");
  }
  const again = chosen.filter(({ state }) => state === "cut");
  const begun = chosen.filter(({ state }) => state === "begun");
  const parts = [
    translate("restPanel.leaveTheSheetInIts", {
      chosen: chosen.length,
      all: tracks.length,
      tracks: trackNumbers(chosen),
    }),
  ];
  if (begun.length > 0) parts.push(translate("restPanel.theTrackThatWasBegun"));
  if (again.length > 0) {
    parts.push(
      translate("restPanel.tracksReportedAsCutWill", {
        count: again.length,
        tracks: trackNumbers(again),
      }),
    );
  }
  return parts.join(" ");
}

interface PictureProps {
  readonly tracks: readonly Track[];
  readonly toolpath: Toolpath;
  /** Tracks that the new job makes. */
  readonly chosen: readonly Track[];
  readonly onPick: (number: number) => void;
}

/** Picture of the tracks on the sheet, in different strokes for cut, begun and uncut. */
export function TrackPicture({ tracks, toolpath, chosen, onPick }: PictureProps) {
  const outlines = useMemo(() => trackOutlines(toolpath, tracks), [toolpath, tracks]);
  const box = useMemo(() => workBox(tracks, toolpath), [toolpath, tracks]);
  const marked = new Set(chosen);
  const margin = 0.04 * Math.max(box.width, box.height);
  const view = [
    box.x - margin,
    -(box.y + box.height) - margin,
    box.width + 2 * margin,
    box.height + 2 * margin,
  ];
  return (
    <svg
      className={css.tracks}
      viewBox={view.join(" ")}
      aria-label={translate("restPanel.tracksOfTheProgramOn")}
      data-testid="rest-picture"
    >
      <g transform="scale(1 -1)">
        {tracks.map((track, index) => (
          <path
            key={track.number}
            d={outlines[index]}
            className={css.track}
            data-state={track.state}
            data-chosen={marked.has(track)}
          />
        ))}
        {tracks.map((track, index) => (
          // biome-ignore lint/a11y/noStaticElementInteractions: the list below is the keyboard's way
          <path
            key={track.number}
            d={outlines[index]}
            className={css.target}
            onClick={() => onPick(track.number)}
            data-track={track.number}
          >
            <title>
              {translate("restPanel.trackStation", {
                number: track.number,
                station: track.station,
                state: STATES[track.state],
              })}
            </title>
          </path>
        ))}
      </g>
    </svg>
  );
}

function Legend() {
  return (
    <Group gap="4px 14px" fz={12} c="ink.2" aria-hidden>
      {(["cut", "begun", "uncut", "unknown"] as const).map((state) => (
        <Group key={state} gap={6}>
          <svg width="26" height="8" viewBox="0 0 26 8" aria-hidden="true">
            <path d="M1 4H25" className={css.track} data-state={state} />
          </svg>
          {STATES[state]}
        </Group>
      ))}
      <Group gap={6}>
        <svg width="26" height="8" viewBox="0 0 26 8" aria-hidden="true">
          <path d="M1 4H25" className={css.track} data-chosen="true" />
        </svg>
        {translate("restPanel.willBeMade")}
      </Group>
    </Group>
  );
}

interface ListProps {
  readonly tracks: readonly Track[];
  readonly chosen: readonly Track[];
  readonly first: number;
  readonly job: Job;
  readonly onPick: (number: number) => void;
}

/** List of the tracks; the chosen one is where the new job begins. */
function TrackList({ tracks, chosen, first, job, onPick }: ListProps) {
  const list = useRef<HTMLOListElement>(null);
  // The list alone is scrolled: the picture must stay where it was clicked.
  useEffect(() => {
    const row = list.current?.children[first - 1];
    if (!(row instanceof HTMLElement) || list.current === null) return;
    const { offsetTop, offsetHeight } = row;
    const { scrollTop, clientHeight } = list.current;
    if (offsetTop < scrollTop || offsetTop + offsetHeight > scrollTop + clientHeight) {
      list.current.scrollTop = offsetTop - (clientHeight - offsetHeight) / 2;
    }
  }, [first]);
  const marked = new Set(chosen);
  const tools = new Map(job.tools.map(({ station, name }) => [station, name]));
  const move = (event: KeyboardEvent, number: number) => {
    const step = { ArrowDown: 1, ArrowUp: -1 }[event.key];
    if (step === undefined || tracks[number - 1 + step] === undefined) return;
    event.preventDefault();
    onPick(number + step);
    const item = event.currentTarget.parentElement;
    const next = step > 0 ? item?.nextElementSibling : item?.previousElementSibling;
    next?.querySelector("button")?.focus();
  };
  return (
    <ol ref={list} className={css.list} data-testid="rest-list">
      {tracks.map((track) => (
        <li key={track.number}>
          <button
            type="button"
            className={`${panels.pick} ${css.trackRow}`}
            aria-pressed={track.number === first}
            data-chosen={marked.has(track)}
            onClick={() => onPick(track.number)}
            onKeyDown={(event) => move(event, track.number)}
            data-testid="rest-track"
          >
            <span>{track.number}</span>
            <span>
              {tools.get(track.station) ??
                translate("restPanel.station", { station: track.station })}
            </span>
            <Figure>
              {translate("restPanel.lines", {
                firstLine: track.first_line,
                lastLine: track.last_line,
              })}
            </Figure>
            <Text span c={track.state === "begun" ? "var(--warn-ink)" : "inherit"}>
              {STATES[track.state]}
            </Text>
          </button>
        </li>
      ))}
    </ol>
  );
}
