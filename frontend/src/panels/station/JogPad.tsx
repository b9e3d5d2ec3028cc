/** Arrows that move the axes while they are held, at most by a chosen distance. */

import { Stack, Text } from "@mantine/core";
import {
  IconArrowDown,
  IconArrowLeft,
  IconArrowRight,
  IconArrowUp,
  IconRotate,
  IconRotateClockwise,
} from "@tabler/icons-react";
import { type ReactNode, useEffect, useRef, useState } from "react";
import type { Job } from "../../api/jobs";
import type { Machine, Station } from "../../api/machines";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { queries, queryClient } from "../../state/queries";
import { HeldJog } from "../../state/station/heldJog";
import { beginJog, operate, renewJog } from "../../state/station/operations";
import {
  type Axis,
  jogDistance,
  jogFeed,
  reasonAgainst,
  travelOf,
  turnsTools,
} from "../../state/station/station";
import { Steps } from "./parts";
import css from "./station.module.css";

interface Props {
  readonly machine: Machine;
  readonly station: Station | undefined;
  readonly job: Job | undefined;
  readonly reached: boolean;
}

/** A hold without a limit of its own; the travel of the axis limits it. */
const FREE = 5000;
/** Longest moves of one hold: mm, or degrees for C. */
const LIMITS = [0.1, 1, 10, 100, FREE] as const;

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
      return travel === null
        ? []
        : [
            translate("jogPad.to", {
              axis,
              travel: travel[0],
              travel2: travel[1],
              axis2: unitOf(axis),
            }),
          ];
    })
    .join(" · ")
    .replaceAll("-", "\u2212");

export function JogPad(props: Props) {
  const [limit, setLimit] = useState<number>(10);
  const { machine, station, job, reached } = props;
  const reasons = ARROWS.map(({ axis }) => reasonAgainst("jog", station, machine, job, axis));
  const [first] = reasons;
  // One reason for all axes is stated once; Z may be free while the tool is down.
  const reason = reached ? (first ?? reasons.find((one) => one !== null) ?? null) : null;
  return (
    <Stack gap={14} data-testid="jog">
      <Steps
        title={translate("jogPad.longestMoveOfOneHold")}
        data={LIMITS.map((value) => ({
          value,
          label: value === FREE ? translate("jogPad.free") : formatNumber(value),
        }))}
        testId="jog-limit"
        value={limit}
        onChange={setLimit}
      />
      <div className={css.arrows}>
        {ARROWS.filter(({ axis }) => axis !== "C" || turnsTools(machine)).map((arrow) => (
          <JogButton
            key={arrow.place}
            {...props}
            arrow={arrow}
            limit={limit}
            reason={
              reached
                ? reasonAgainst("jog", station, machine, job, arrow.axis)
                : translate("jogPad.thereIsNoConnectionTo")
            }
          />
        ))}
        <span style={{ gridArea: "xy" }}>X Y</span>
        <span style={{ gridArea: "z" }}>Z</span>
        {turnsTools(machine) && <span style={{ gridArea: "c" }}>C</span>}
      </div>
      <Text fz={15} c="ink.2" data-testid="jog-note">
        {translate("jogPad.travel", {
          reason: reason ?? translate("jogPad.holdAnArrowToMove"),
          machine: travelText(machine),
        })}
      </Text>
    </Stack>
  );
}

interface ButtonProps extends Props {
  readonly arrow: Arrow;
  readonly limit: number;
  readonly reason: string | null;
}

function JogButton({ machine, station, arrow, limit, reason }: ButtonProps) {
  const { axis, sign, icon, place } = arrow;
  const label = `${axis}${signOf(sign)}`;
  const held = useRef<HeldJog | null>(null);
  const position = station?.position ?? null;
  const atLimit = reason === null && jogDistance(machine, position, axis, sign * limit) === 0;
  const why = atLimit ? translate("jogPad.isAtTheLimitOf", { axis }) : reason;

  const reported = () => queryClient.getQueryData(queries.station(machine.name).queryKey);
  const begin = () => {
    const wanted = jogDistance(machine, reported()?.position ?? null, axis, sign * limit);
    if (why !== null || wanted === 0) return;
    const feed = jogFeed(machine, axis);
    held.current = new HeldJog({
      begin: () =>
        beginJog(machine.name, translate("jogPad.move", { label }), {
          operation: "jog",
          axis,
          distance: wanted,
          feed,
        }),
      renew: (id) => renewJog(machine.name, id),
      stop: () =>
        operate(machine.name, translate("jogPad.stop", { axis }), { operation: "stop_jog" }),
    });
    void held.current.hold();
  };
  const end = () => {
    held.current?.release();
    held.current = null;
  };
  const stop = useRef(end);
  stop.current = end;

  // When the page loses the focus or is hidden, it receives no release: this counts as one.
  useEffect(() => {
    const release = () => stop.current();
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
      style={{ gridArea: place }}
      // The button stays enabled while its own move runs: a disabled one gets no release.
      aria-disabled={why !== null}
      aria-label={
        limit === FREE
          ? translate("jogPad.whileHeld", { label })
          : translate("jogPad.whileHeldAtMost", { label, limit, axis: unitOf(axis) })
      }
      title={why ?? undefined}
      onPointerDown={(event) => {
        if (event.button !== 0 || why !== null) return;
        event.currentTarget.setPointerCapture(event.pointerId);
        begin();
      }}
      onPointerUp={end}
      onPointerCancel={end}
      onLostPointerCapture={end}
      onContextMenu={(event) => event.preventDefault()}
      onKeyDown={({ key, repeat }) => {
        if (!repeat && (key === " " || key === "Enter")) begin();
      }}
      onKeyUp={end}
      onBlur={end}
      data-testid={`jog-${place}`}
    >
      {icon}
      {label}
    </button>
  );
}
