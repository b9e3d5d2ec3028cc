/** Marks of a printed sheet: the operator moves above each one, and takes its position. */

import { Flex, Group, Select, SimpleGrid, Stack, Text, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type Job, jobService, type MarkFit, type MeasuredMarks } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { formatFixed, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { upsertJob } from "../../state/cacheUpdates";
import { reportAction } from "../../state/station/operations";
import panels from "../shared/panels.module.css";
import { CameraPicture } from "./CameraPicture";
import { JogPad } from "./JogPad";
import { NotedButton, WideButton } from "./parts";

interface Props {
  readonly job: Job;
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly reached: boolean;
}

type Place = readonly [x: number, y: number];

/** Turn from which the order of the marks is doubted (degrees). */
const LARGE_TURN = 15;
/** Factor by which the picture enlarges errors. */
const ENLARGED = 50;

const text = (value: number, digits = 2): string => withMinusSign(formatFixed(value, digits));

export function MarksPanel({ job, machine, station, reached }: Props) {
  const marks = job.registration?.marks ?? [];
  const [taken, setTaken] = useState<readonly (Place | null)[]>(marks.map(() => null));
  const [aim, setAim] = useState("head");
  const [x, y] = station?.position ?? [];
  const positions = taken.flatMap((place) =>
    place === null ? [] : [[...place] as [number, number]],
  );
  const measured: MeasuredMarks = {
    positions,
    station: aim === "head" ? null : Number(aim),
    offset: [0, 0],
  };
  const whole = positions.length === marks.length;
  const { data: plan } = useQuery({
    queryKey: ["registration", job.id, job.program_sha256],
    queryFn: ({ signal }) => jobService.registration(job.id, signal),
  });
  const { data: fit } = useQuery({
    queryKey: ["fit-marks", job.id, measured],
    queryFn: () => jobService.fitMarks(job.id, measured),
    enabled: whole,
  });
  const shown = whole ? fit : plan;
  const send = (label: string, body: MeasuredMarks) =>
    reportAction(label, async () => upsertJob(await jobService.registerNow(job.id, body)));
  return (
    <Flex
      component="section"
      direction="column"
      gap={12}
      pt={14}
      className={panels.divided}
      aria-label={translate("marksPanel.title")}
      data-testid="marks"
    >
      <Title order={3} fz={18}>
        {translate("marksPanel.title")}
      </Title>
      <Text>{translate("marksPanel.note")}</Text>
      <Select
        size="lg"
        label={translate("marksPanel.aim")}
        data={[
          { value: "head", label: translate("marksPanel.head") },
          ...machine.stations.map(({ number, name }) => ({
            value: String(number),
            label: `${number} ${name}`,
          })),
        ]}
        value={aim}
        allowDeselect={false}
        onChange={(value) => setAim(value ?? "head")}
      />
      <CameraPicture />
      <JogPad machine={machine} station={station} job={job} reached={reached} />
      {x === undefined || y === undefined ? (
        <Text c="ink.2">{translate("marksPanel.noPosition")}</Text>
      ) : (
        <Text data-testid="marks-position">{`X ${text(x)} · Y ${text(y)}`}</Text>
      )}
      {marks.map(([u, v], at) => (
        <Group key={`${u} ${v}`} justify="space-between" wrap="nowrap" data-testid="station-mark">
          <Text miw={0}>{markText(at, taken[at] ?? null, shown)}</Text>
          <WideButton
            w="auto"
            miw={140}
            fullWidth={false}
            // Not while the machine moves: the reported position is then an earlier one.
            disabled={!reached || x === undefined || y === undefined || station?.state !== "idle"}
            onClick={() =>
              setTaken(taken.map((one, row) => (row === at ? [x as number, y as number] : one)))
            }
            data-testid={`take-mark-${at + 1}`}
          >
            {translate("marksPanel.take")}
          </WideButton>
        </Group>
      ))}
      {shown !== undefined && <Fit fit={shown} />}
      <SimpleGrid cols={2} spacing={12}>
        <NotedButton note={translate("marksPanel.compileNote")}>
          <WideButton
            disabled={!reached || !whole || fit === undefined || fit.refusal !== null}
            onClick={() => void send(translate("marksPanel.compile"), measured)}
            data-testid="marks-compile"
          >
            {translate("marksPanel.compile")}
          </WideButton>
        </NotedButton>
        {(job.registration?.measured ?? []).length > 0 && (
          <NotedButton note={translate("marksPanel.forgetNote")}>
            <WideButton
              disabled={!reached}
              onClick={() =>
                void send(translate("marksPanel.forget"), {
                  positions: [],
                  station: null,
                  offset: [0, 0],
                })
              }
              data-testid="marks-forget"
            >
              {translate("marksPanel.forget")}
            </WideButton>
          </NotedButton>
        )}
      </SimpleGrid>
    </Flex>
  );
}

/** A mark in words: where it was taken, or where it is expected, and its error. */
function markText(at: number, taken: Place | null, fit: MarkFit | undefined): string {
  const parts = [translate("marksPanel.mark", { number: at + 1 })];
  const mark = fit?.marks[at];
  if (taken !== null)
    parts.push(translate("marksPanel.taken", { x: text(taken[0]), y: text(taken[1]) }));
  else if (mark !== undefined)
    parts.push(
      translate("marksPanel.expected", {
        x: text(mark.expected[0], 1),
        y: text(mark.expected[1], 1),
      }),
    );
  if (mark?.error != null)
    parts.push(translate("marksPanel.error", { error: text(Math.hypot(...mark.error)) }));
  return parts.join(" · ");
}

function Fit({ fit }: { fit: MarkFit }) {
  const { shift, turn, scale, largest_error: error, refusal } = fit;
  return (
    <Stack gap={8}>
      {shift !== null && turn !== null && scale !== null && error !== null && (
        <>
          <Text fw={600} data-testid="marks-fit">
            {translate("marksPanel.fit", {
              x: text(shift[0]),
              y: text(shift[1]),
              turn: text(turn, 3),
              scale: formatFixed(scale, 5),
              error: text(error),
            })}
          </Text>
          {Math.abs(turn) > LARGE_TURN && (
            <p className={panels.callout} data-tone="amber">
              {translate("marksPanel.turned", { turn: text(turn, 0) })}
            </p>
          )}
        </>
      )}
      {refusal !== null && (
        <p className={panels.callout} data-tone="red" role="alert" data-testid="marks-refusal">
          {messageText(refusal)} {messageHint(refusal)}
        </p>
      )}
      <Picture fit={fit} />
    </Stack>
  );
}

/** Expected marks as circles, measured ones as crosses, errors as enlarged lines. */
function Picture({ fit }: { fit: MarkFit }) {
  const points = fit.marks.flatMap(({ expected, measured }) =>
    measured === null ? [expected] : [expected, measured],
  );
  const [xs, ys] = [points.map(([x]) => x), points.map(([, y]) => y)];
  const left = Math.min(...xs);
  const top = Math.max(...ys);
  const size = Math.max(Math.max(...xs) - left, top - Math.min(...ys), 1);
  const unit = size / 40;
  const box = [-2, -2]
    .map((side) => side * unit)
    .concat([size + 4 * unit, top - Math.min(...ys) + 4 * unit]);
  return (
    <svg
      viewBox={box.join(" ")}
      role="img"
      aria-label={translate("marksPanel.picture")}
      style={{ maxHeight: 220 }}
    >
      {fit.marks.map(({ expected, measured, error }, at) => {
        const [x, y] = [expected[0] - left, top - expected[1]];
        const [u, v] = measured === null ? [x, y] : [measured[0] - left, top - measured[1]];
        return (
          <g key={`${expected[0]} ${expected[1]}`} fill="none" strokeWidth={unit / 5}>
            <circle cx={x} cy={y} r={unit} stroke="var(--ink-2)" />
            {measured !== null && (
              <path
                d={`M${u - unit} ${v}h${2 * unit}M${u} ${v - unit}v${2 * unit}`}
                stroke="var(--good)"
              />
            )}
            {error !== null && (
              <path
                d={`M${u} ${v}l${-error[0] * ENLARGED} ${error[1] * ENLARGED}`}
                stroke="var(--bad)"
              />
            )}
            <text
              x={x + 1.4 * unit}
              y={y - unit}
              fontSize={2 * unit}
              fill="var(--ink-2)"
              stroke="none"
            >
              {at + 1}
            </text>
          </g>
        );
      })}
    </svg>
  );
}
