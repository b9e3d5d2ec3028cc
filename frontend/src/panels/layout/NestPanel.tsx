/** Nesting: numbers of copies, gap and time; the best arrangement so far; stop and keep. */

import { Button, Group, NumberInput, Progress } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { layoutService, type Nesting } from "../../api/layouts";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText, messageText } from "../../messages/translateMessage";
import css from "./layout.module.css";
import type { Draft } from "./placing";

interface Props {
  readonly draft: Draft;
  /** Least distance between two blanks, and margin at each edge of the sheet (mm). */
  readonly gap: number;
  readonly margin: number;
  readonly onGap: (gap: number) => void;
  readonly onMargin: (margin: number) => void;
  readonly nameOf: (drawing: string) => string;
  /** Shows the first sheet of the best arrangement; `ended` with the last one. */
  readonly onFound: (nesting: Nesting, ended: boolean) => void;
}

const POLL = 500;

/** Number of copies of each drawing on the sheet. */
function counted({ placed }: Draft): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { drawing, columns, rows } of placed)
    counts.set(drawing, (counts.get(drawing) ?? 0) + columns * rows);
  return counts;
}

export function NestPanel({ draft, gap, margin, onGap, onMargin, nameOf, onFound }: Props) {
  const present = counted(draft);
  const [counts, setCounts] = useState<ReadonlyMap<string, number>>(new Map());
  const [seconds, setSeconds] = useState(10);
  const [running, setRunning] = useState<string | null>(null);
  const [fault, setFault] = useState("");
  const [last, setLast] = useState<Nesting | null>(null);

  const show = (nesting: Nesting) => {
    const ended = nesting.state !== "running";
    setLast(nesting);
    if (nesting.sheets.length > 0) onFound(nesting, ended);
    if (ended) {
      setRunning(null);
      if (nesting.message !== null) setFault(messageText(nesting.message));
    }
    return nesting;
  };
  useQuery({
    queryKey: ["nesting", running],
    queryFn: async ({ signal }) => show(await layoutService.nesting(running ?? "", signal)),
    enabled: running !== null,
    refetchInterval: POLL,
    gcTime: 0,
    staleTime: 0,
  });
  const attempt = async (action: () => Promise<unknown>) => {
    setFault("");
    try {
      await action();
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    }
  };
  const nest = () =>
    attempt(async () => {
      const parts = [...present].map(([drawing, count]) => ({
        drawing,
        quantity: counts.get(drawing) ?? count,
      }));
      const margins = { left: margin, right: margin, below: margin, above: margin };
      const begun = await layoutService.beginNesting({
        ...{ sheet: draft.sheet, margins, gap, parts, seconds },
      } as Parameters<typeof layoutService.beginNesting>[0]);
      setLast(begun);
      setRunning(begun.id);
    });
  const number = (label: string, value: number, set: (value: number) => void, least: number) => (
    <NumberInput
      hideControls
      label={label}
      size="xs"
      min={least}
      max={least === 1 ? 600 : 1000}
      value={value}
      onChange={(next) => typeof next === "number" && set(next)}
    />
  );
  return (
    <div className={css.nest} data-testid="nest-panel">
      {[...present].map(([drawing, count]) => (
        <NumberInput
          hideControls
          key={drawing}
          label={translate("layoutEditor.copiesOf", { name: nameOf(drawing) })}
          size="xs"
          min={1}
          max={2000}
          allowDecimal={false}
          value={counts.get(drawing) ?? count}
          onChange={(value) =>
            typeof value === "number" && setCounts(new Map(counts).set(drawing, value))
          }
          data-testid="nest-count"
        />
      ))}
      <div className={css.three}>
        {number(translate("layoutEditor.gapMm"), gap, onGap, 0)}
        {number(translate("layoutEditor.marginMm"), margin, onMargin, 0)}
        {number(translate("layoutEditor.timeS"), seconds, setSeconds, 1)}
      </div>
      {running === null ? (
        <Button size="sm" disabled={present.size === 0} onClick={nest} data-testid="nest">
          {translate("layoutEditor.nest")}
        </Button>
      ) : (
        <Group gap={8} wrap="nowrap">
          <Progress value={100} animated flex={1} aria-label={translate("layoutEditor.nesting")} />
          <Button
            size="xs"
            variant="default"
            onClick={() => attempt(async () => show(await layoutService.stopNesting(running)))}
            data-testid="nest-stop"
          >
            {translate("layoutEditor.stopAndKeep")}
          </Button>
        </Group>
      )}
      <p className={css.found} role="status" data-testid="nest-found">
        {last !== null && last.sheets.length > 0
          ? translate("layoutEditor.bestSoFar", {
              use: formatNumber(last.use, { maximumFractionDigits: 1 }),
              rectangles: formatNumber(last.rectangles_use, { maximumFractionDigits: 1 }),
              sheets: last.sheets.length,
            })
          : ""}
      </p>
      {fault !== "" && (
        <p className={css.fault} role="alert">
          {fault}
        </p>
      )}
    </div>
  );
}
