/** Arrows that move the axes: a tap makes one step, holding an arrow moves until it is released. */

import {
  IconArrowDown,
  IconArrowLeft,
  IconArrowRight,
  IconArrowUp,
  IconRotate,
  IconRotateClockwise,
} from "@tabler/icons-react";
import { type ReactNode, useEffect, useRef, useState } from "react";
import type { Job, Machine, Station } from "../api/client";
import { HeldJog } from "../state/heldJog";
import { operate } from "../state/operations";
import { queries, queryClient } from "../state/queries";
import { type Axis, jogDistance, jogFeed, reasonAgainst, travelOf } from "../state/station";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly job: Job | undefined;
  readonly reached: boolean;
}

/** Steps of a tap: mm, or degrees for C. */
const STEPS = [0.1, 1, 10, 100] as const;
/** Time (ms) from which a press is a hold. */
const HOLD_AFTER = 350;
/** Duration (s) of one short move while an arrow is held. */
const SHORT_MOVE = 1;

interface Arrow {
  readonly axis: Axis;
  readonly sign: 1 | -1;
  readonly icon: ReactNode;
  readonly place: string;
}

const ARROWS: readonly Arrow[] = [
  { axis: "Y", sign: 1, icon: <IconArrowUp aria-hidden />, place: "y1" },
  { axis: "X", sign: -1, icon: <IconArrowLeft aria-hidden />, place: "x0" },
  { axis: "X", sign: 1, icon: <IconArrowRight aria-hidden />, place: "x1" },
  { axis: "Y", sign: -1, icon: <IconArrowDown aria-hidden />, place: "y0" },
  { axis: "Z", sign: 1, icon: <IconArrowUp aria-hidden />, place: "z1" },
  { axis: "Z", sign: -1, icon: <IconArrowDown aria-hidden />, place: "z0" },
  { axis: "C", sign: 1, icon: <IconRotate aria-hidden />, place: "c1" },
  { axis: "C", sign: -1, icon: <IconRotateClockwise aria-hidden />, place: "c0" },
];

const unitOf = (axis: Axis): string => (axis === "C" ? "°" : "\u202fmm");
const signOf = (sign: 1 | -1): string => (sign > 0 ? "+" : "\u2212");

/** Text of the travel of all axes. */
const travelText = (machine: Machine): string =>
  (["X", "Y", "Z", "C"] as const)
    .flatMap((axis) => {
      const travel = travelOf(machine, axis);
      return travel === null ? [] : [`${axis} ${travel[0]} to ${travel[1]}${unitOf(axis)}`];
    })
    .join(" · ")
    .replaceAll("-", "\u2212");

export function JogPad(props: Props) {
  const [step, setStep] = useState<number>(10);
  const { machine, station, job, reached } = props;
  const reasons = ARROWS.map(({ axis }) => reasonAgainst("jog", station, machine, job, axis));
  const [first] = reasons;
  // One reason for all axes is stated once; Z may be free while the tool is down.
  const reason = reached ? (first ?? reasons.find((one) => one !== null) ?? null) : null;
  return (
    <div className={css.jogPad} data-testid="jog">
      <fieldset className={css.steps}>
        <legend>Step of a tap</legend>
        {STEPS.map((one) => (
          <label key={one} className={css.step}>
            <input type="radio" name="step" checked={step === one} onChange={() => setStep(one)} />
            <span className={css.stepText}>{one}</span>
          </label>
        ))}
      </fieldset>
      <div className={css.arrows}>
        {ARROWS.map((arrow, at) => (
          <JogButton
            key={arrow.place}
            {...props}
            arrow={arrow}
            step={step}
            reason={reached ? (reasons[at] ?? null) : "There is no connection to the server."}
          />
        ))}
        <span className={css.axisName} data-place="xy">
          X Y
        </span>
        <span className={css.axisName} data-place="z">
          Z
        </span>
        <span className={css.axisName} data-place="c">
          C
        </span>
      </div>
      <p className={css.small} data-testid="jog-note">
        {reason ?? "Tap for one step; hold to move until you release."} Travel:{" "}
        {travelText(machine)}
      </p>
    </div>
  );
}

interface ButtonProps extends Props {
  readonly arrow: Arrow;
  readonly step: number;
  readonly reason: string | null;
}

function JogButton({ machine, station, arrow, step, reason }: ButtonProps) {
  const { axis, sign, icon, place } = arrow;
  const label = `${axis}${signOf(sign)}`;
  const held = useRef<HeldJog | null>(null);
  const timer = useRef<ReturnType<typeof setTimeout> | undefined>(undefined);
  const position = station?.position ?? null;
  const atLimit = reason === null && jogDistance(machine, position, axis, sign * step) === 0;
  const why = atLimit ? `${axis} is at the limit of its travel.` : reason;

  const reported = () => queryClient.getQueryData(queries.station(machine.name).queryKey);
  const move = (wanted: number) => {
    const distance = jogDistance(machine, reported()?.position ?? null, axis, sign * wanted);
    if (distance === 0) return null;
    const feed = jogFeed(machine, axis);
    const text = `${axis} ${signOf(sign)}${Math.abs(distance).toFixed(1)}${unitOf(axis)}`;
    return operate(machine.name, text, { operation: "jog", axis, distance, feed });
  };
  const begin = () => {
    timer.current = setTimeout(() => {
      timer.current = undefined;
      held.current = new HeldJog({
        move: () => move((jogFeed(machine, axis) / 60) * SHORT_MOVE),
        stop: () => operate(machine.name, `Stop ${axis}`, { operation: "stop_jog" }),
        isAtRest: () => reported()?.state === "idle",
      });
      void held.current.hold();
    }, HOLD_AFTER);
  };
  /** End a press; `tap` makes one step if it was short. */
  const end = (tap: boolean) => {
    const short = timer.current !== undefined;
    clearTimeout(timer.current);
    timer.current = undefined;
    if (short && tap) void move(step);
    held.current?.release();
    held.current = null;
  };
  const stop = useRef(end);
  stop.current = end;

  // When the page loses the focus or is hidden, it receives no release: this counts as one.
  useEffect(() => {
    const release = () => stop.current(false);
    window.addEventListener("blur", release);
    document.addEventListener("visibilitychange", release);
    return () => {
      release();
      window.removeEventListener("blur", release);
      document.removeEventListener("visibilitychange", release);
    };
  }, []);

  return (
    <button
      type="button"
      className={css.arrow}
      data-place={place}
      // The button stays enabled while its own move runs: a disabled one gets no release.
      aria-disabled={why !== null}
      aria-label={`${label} by ${step}${unitOf(axis)}`}
      title={why ?? undefined}
      onPointerDown={(event) => {
        if (event.button !== 0 || why !== null) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        begin();
      }}
      onPointerUp={() => end(true)}
      onPointerCancel={() => end(false)}
      onLostPointerCapture={() => end(false)}
      onContextMenu={(event) => event.preventDefault()}
      onClick={({ detail }) => {
        // Pressed with the keyboard or a screen reader.
        if (detail === 0 && why === null) void move(step);
      }}
      data-testid={`jog-${place}`}
    >
      {icon}
      {label}
    </button>
  );
}
