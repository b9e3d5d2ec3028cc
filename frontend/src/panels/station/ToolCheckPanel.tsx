/** Check of the tools of a waiting job, one by one: move above a point, look, correct or confirm. */

import { useState } from "react";
import type { Job, Machine, Station } from "../../api/client";
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
import css from "./station.module.css";
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
    <section
      className={css.dryRun}
      aria-label={translate("toolCheckPanel.toolCheck")}
      data-testid="tool-check"
    >
      <h3>{translate("toolCheckPanel.checkAToolAboveThe")}</h3>
      <div className={css.wayGrid}>
        {tools.map(({ key, station }) => (
          <button
            key={key}
            type="button"
            className={css.button}
            aria-expanded={opened === station}
            onClick={() => setOpened(opened === station ? null : station)}
            data-testid={`check-tool-${station}`}
          >
            {station} {machine.stations.find(({ number }) => number === station)?.name}
          </button>
        ))}
      </div>
      {mounted !== undefined && (
        <OneTool
          {...props}
          key={mounted.number}
          mounted={mounted}
          check={tools.find(({ station }) => station === mounted.number)}
        />
      )}
    </section>
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
    <div className={css.ways} data-testid="tool-check-step">
      <ToolFacts mounted={mounted} detail={check?.detail ?? ""} />
      <fieldset className={css.steps} data-columns="3">
        <legend>{translate("toolCheckPanel.pointOnTheTable")}</legend>
        {places.map(({ key, title }) => (
          <label key={key} className={css.step}>
            <input
              type="radio"
              name="place"
              checked={chosen?.key === key}
              onChange={() => setPlace(key)}
            />
            <span className={`${css.stepText} ${css.stepName}`} data-testid={`place-${key}`}>
              {title}
            </span>
          </label>
        ))}
      </fieldset>
      {reason !== null && <p className={css.small}>{reason}</p>}
      <div className={css.wayGrid}>
        <div className={css.way}>
          <button
            type="button"
            className={css.button}
            disabled={!reached || reason !== null}
            onClick={move}
            data-testid="tool-check-move"
          >
            {isShifted(shift)
              ? translate("toolCheckPanel.tryTheCorrection")
              : translate("toolCheckPanel.moveAboveThePoint2")}
          </button>
          <small>{translate("toolCheckPanel.thenLowersTheToolAlmost")}</small>
        </div>
        <div className={css.way}>
          <button
            type="button"
            className={css.button}
            disabled={!reached || reasonAgainst("lift", station, machine, job) !== null}
            onClick={() =>
              void operate(machine.name, translate("toolCheckPanel.lift"), { operation: "lift" })
            }
            data-testid="tool-check-lift"
          >
            {translate("toolCheckPanel.lift")}
          </button>
          <small>{translate("toolCheckPanel.straightUpAllOutputsGo")}</small>
        </div>
      </div>
      <LastCheck station={station} number={mounted.number} />
      <Correction
        {...props}
        shift={shift}
        onShift={setShift}
        right={check !== undefined && ticked.has(check.key)}
        onRight={() => check !== undefined && onTick([check.key])}
      />
    </div>
  );
}

function ToolFacts({ mounted, detail }: { mounted: Mounted; detail: string }) {
  const { datum } = mounted;
  const offset = AXES.map((axis) => {
    const value = datum[axis.toLowerCase()] ?? 0;
    return `${axis} ${text(value)}${unitOf(axis)}`;
  });
  return (
    <dl className={css.toolFacts} data-testid="tool-facts">
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
    <p className={css.message} data-tone={activity.state === "failed" ? "red" : "amber"}>
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
      <fieldset className={css.steps} data-columns="3">
        <legend>{translate("toolCheckPanel.isTheTipNotAbove")}</legend>
        {STEPS.map((one) => (
          <label key={one} className={css.step}>
            <input
              type="radio"
              name="correction"
              checked={step === one}
              onChange={() => setStep(one)}
            />
            <span className={css.stepText}>{formatNumber(one)}</span>
          </label>
        ))}
      </fieldset>
      <div className={css.shifts}>
        {AXES.map((axis, at) => (
          <div key={axis} className={css.shift}>
            <button
              type="button"
              className={css.button}
              aria-label={translate("toolCheckPanel.less", { axis })}
              onClick={() => onShift(shifted(shift, axis, -step))}
              data-testid={`shift-${axis}-less`}
            >
              {"\u2212"}
            </button>
            <output data-testid={`shift-${axis}`}>
              {axis} {text(shift[at] ?? 0)}
              {unitOf(axis)}
            </output>
            <button
              type="button"
              className={css.button}
              aria-label={translate("toolCheckPanel.more", { axis })}
              onClick={() => onShift(shifted(shift, axis, step))}
              data-testid={`shift-${axis}-more`}
            >
              +
            </button>
          </div>
        ))}
      </div>
      <div className={css.wayGrid}>
        <button
          type="button"
          className={css.button}
          disabled={!reached || !isShifted(shift) || refusal !== null}
          title={refusal ?? undefined}
          onClick={() => void save()}
          data-testid="tool-check-save"
        >
          {translate("toolCheckPanel.saveTheOffset")}
        </button>
        <button
          type="button"
          className={css.button}
          aria-pressed={right}
          disabled={isShifted(shift)}
          onClick={onRight}
          data-testid="tool-check-right"
        >
          {right
            ? translate("toolCheckPanel.toolIsRight")
            : translate("toolCheckPanel.toolIsRight2")}
        </button>
      </div>
      <Refusal reason={refusal} />
    </>
  );
}
