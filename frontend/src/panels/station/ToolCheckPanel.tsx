/** Check of the tools of a waiting job, one by one: move above a point, look, correct or confirm. */

import { Box, Flex, SimpleGrid, Stack, Text, Title } from "@mantine/core";
import { useState } from "react";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { formatFixed, formatNumber, withMinusSign } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { useDrawing } from "../../state/queries";
import type { Check } from "../../state/station/checks";
import { type HandsClear, handsReason } from "../../state/station/handsClear";
import { operate, reportAction } from "../../state/station/operations";
import { AXES, type Axis, reasonAgainst, runAboveBoard } from "../../state/station/station";
import {
  isShifted,
  NO_SHIFT,
  placesOf,
  type Shift,
  saveCorrection,
  shifted,
} from "../../state/station/toolCheck";
import { Refusal } from "../accounts/Permitted";
import panels from "../shared/panels.module.css";
import { NotedButton, Steps, WideButton } from "./parts";
import { dimensionText, kindText } from "./toolText";

interface Props {
  readonly job: Job;
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly checks: readonly Check[];
  readonly ticked: ReadonlySet<string>;
  readonly reached: boolean;
  readonly hands: HandsClear;
  onTick(keys: readonly string[]): void;
}

type Mounted = Machine["stations"][number];

/** Steps of a correction: mm, or degrees for C. */
const STEPS = [0.05, 0.2, 1] as const;

const text = (value: number): string => withMinusSign(formatFixed(value, 2));
const unitOf = (axis: Axis): string => (axis === "C" ? "°" : "\u202fmm");

export function ToolCheckPanel(props: Props) {
  const { machine, checks } = props;
  const tools = checks.filter((check) => check.station !== null);
  const [opened, setOpened] = useState<number | null>(null);
  const mounted = machine.stations.find(({ number }) => number === opened);
  return (
    <Flex
      component="section"
      direction="column"
      gap={12}
      pt={14}
      className={panels.divided}
      aria-label={translate("toolCheckPanel.toolCheck")}
      data-testid="tool-check"
    >
      <Title order={3} fz={18}>
        {translate("toolCheckPanel.checkAToolAboveThe")}
      </Title>
      <SimpleGrid cols={2} spacing={12}>
        {tools.map(({ key, station }) => (
          <WideButton
            key={key}
            aria-expanded={opened === station}
            onClick={() => setOpened(opened === station ? null : station)}
            data-testid={`check-tool-${station}`}
          >
            {station} {machine.stations.find(({ number }) => number === station)?.name}
          </WideButton>
        ))}
      </SimpleGrid>
      {mounted !== undefined && (
        <OneTool
          {...props}
          key={mounted.number}
          mounted={mounted}
          check={tools.find(({ station }) => station === mounted.number)}
        />
      )}
    </Flex>
  );
}

interface OneProps extends Props {
  readonly mounted: Mounted;
  readonly check: Check | undefined;
}

function OneTool(props: OneProps) {
  const { machine, station, job, reached, hands, mounted, check, ticked, onTick } = props;
  const { data: drawing } = useDrawing();
  const [place, setPlace] = useState("corner");
  const [shift, setShift] = useState<Shift>(NO_SHIFT);
  const places = placesOf(machine, drawing);
  const [first] = places;
  const chosen = places.find(({ key }) => key === place) ?? first;
  const reason =
    reasonAgainst("tool_check", station, machine, job) ?? handsReason("tool_check", hands);
  const move = () => {
    if (chosen === undefined) return;
    const [x, y] = chosen.point;
    void operate(
      machine.name,
      translate("toolCheckPanel.moveAboveThePoint", { name: mounted.name }),
      {
        operation: "tool_check",
        station: mounted.number,
        point: [x, y],
        shift: [...shift],
      },
    );
  };
  return (
    <Stack gap={14} data-testid="tool-check-step">
      <ToolFacts mounted={mounted} detail={check?.detail ?? ""} />
      <Steps
        title={translate("toolCheckPanel.pointOnTheTable")}
        data={places.map(({ key, title }) => ({ value: key, label: title }))}
        testId="place"
        value={chosen?.key}
        onChange={setPlace}
      />
      {reason !== null && (
        <Text fz={15} c="ink.2">
          {reason}
        </Text>
      )}
      <SimpleGrid cols={2} spacing={12}>
        <NotedButton note={translate("toolCheckPanel.thenLowersTheToolAlmost")}>
          <WideButton
            disabled={!reached || reason !== null}
            onClick={move}
            data-testid="tool-check-move"
          >
            {isShifted(shift)
              ? translate("toolCheckPanel.tryTheCorrection")
              : translate("toolCheckPanel.moveAboveThePoint2")}
          </WideButton>
        </NotedButton>
        <NotedButton note={translate("toolCheckPanel.straightUpAllOutputsGo")}>
          <WideButton
            disabled={!reached || reasonAgainst("lift", station, machine, job) !== null}
            onClick={() =>
              void operate(machine.name, translate("toolCheckPanel.lift"), { operation: "lift" })
            }
            data-testid="tool-check-lift"
          >
            {translate("toolCheckPanel.lift")}
          </WideButton>
        </NotedButton>
      </SimpleGrid>
      <LastCheck station={station} number={mounted.number} />
      <Correction
        {...props}
        shift={shift}
        onShift={setShift}
        right={check !== undefined && ticked.has(check.key)}
        onRight={() => check !== undefined && onTick([check.key])}
      />
    </Stack>
  );
}

function ToolFacts({ mounted, detail }: { mounted: Mounted; detail: string }) {
  const { datum } = mounted;
  const offset = AXES.map((axis) => {
    const value = datum[axis.toLowerCase()] ?? 0;
    return `${axis} ${text(value)}${unitOf(axis)}`;
  });
  return (
    <dl className={panels.facts} data-testid="tool-facts">
      <dt>{translate("toolCheckPanel.tool")}</dt>
      <dd>
        {kindText(mounted.tool.kind)}: {dimensionText(mounted.tool)}
      </dd>
      <dt>{translate("toolCheckPanel.wear")}</dt>
      <dd>{detail}</dd>
      <dt>{translate("toolCheckPanel.offset")}</dt>
      <dd>{offset.join(" · ")}</dd>
    </dl>
  );
}

/** What the last check of the tool has left out, or why it has failed. */
function LastCheck({ station, number }: { station: Station | undefined; number: number }) {
  const activity = station?.activity ?? null;
  if (activity === null || activity.kind !== "tool_check" || activity.station !== number) {
    return null;
  }
  if (runAboveBoard(station) !== null || activity.message === null) return null;
  return (
    <p className={panels.callout} data-tone={activity.state === "failed" ? "red" : "amber"}>
      {messageText(activity.message)}
    </p>
  );
}

interface CorrectionProps extends OneProps {
  readonly shift: Shift;
  readonly right: boolean;
  onShift(shift: Shift): void;
  onRight(): void;
}

function Correction(props: CorrectionProps) {
  const { machine, mounted, reached, shift, right, onShift, onRight } = props;
  const [step, setStep] = useState<number>(0.2);
  const refusal = useRefusal("PUT /api/v1/machines/{name}");
  const save = () =>
    reportAction(translate("toolCheckPanel.saveTheOffsetOf", { name: mounted.name }), async () => {
      await saveCorrection(machine, mounted.number, shift);
      onShift(NO_SHIFT);
    });
  return (
    <>
      <Steps
        title={translate("toolCheckPanel.isTheTipNotAbove")}
        data={STEPS.map((value) => ({ value, label: formatNumber(value) }))}
        testId="correction"
        value={step}
        onChange={setStep}
      />
      <SimpleGrid cols={{ base: 1, xs: 2 }} spacing={10}>
        {AXES.map((axis, at) => (
          <Flex key={axis} align="center" gap={6} ta="center">
            <WideButton
              w={52}
              p={0}
              aria-label={translate("toolCheckPanel.less", { axis })}
              onClick={() => onShift(shifted(shift, axis, -step))}
              data-testid={`shift-${axis}-less`}
            >
              {"\u2212"}
            </WideButton>
            <Box component="output" flex={1} data-testid={`shift-${axis}`}>
              {axis} {text(shift[at] ?? 0)}
              {unitOf(axis)}
            </Box>
            <WideButton
              w={52}
              p={0}
              aria-label={translate("toolCheckPanel.more", { axis })}
              onClick={() => onShift(shifted(shift, axis, step))}
              data-testid={`shift-${axis}-more`}
            >
              +
            </WideButton>
          </Flex>
        ))}
      </SimpleGrid>
      <SimpleGrid cols={2} spacing={12}>
        <WideButton
          disabled={!reached || !isShifted(shift) || refusal !== null}
          title={refusal ?? undefined}
          onClick={() => void save()}
          data-testid="tool-check-save"
        >
          {translate("toolCheckPanel.saveTheOffset")}
        </WideButton>
        <WideButton
          aria-pressed={right}
          disabled={isShifted(shift)}
          onClick={onRight}
          data-testid="tool-check-right"
        >
          {right
            ? translate("toolCheckPanel.toolIsRight")
            : translate("toolCheckPanel.toolIsRight2")}
        </WideButton>
      </SimpleGrid>
      <Refusal reason={refusal} />
    </>
  );
}
