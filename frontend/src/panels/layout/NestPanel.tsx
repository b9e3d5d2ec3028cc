/** Nesting: numbers of copies, gap and time; the best arrangement so far; stop and keep. */

import { Button, Group, NumberInput, Progress, Switch } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { layoutService, type Nesting, type StockSheet } from "../../api/layouts";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText, messageText } from "../../messages/translateMessage";
import css from "./layout.module.css";
import type { Draft } from "./placing";
import { useStock } from "./StockPanel";

interface Props {
  readonly draft: Draft;
  readonly nameOf: (drawing: string) => string;
  /** Shows the first sheet of the best arrangement; `ended` with the last one. */
  readonly onFound: (nesting: Nesting, ended: boolean) => void;
}

const POLL = 500;
/** Most sheets of one size that a nesting takes out of the stock. */
const MOST = 100;

const leftOver = ({ width, height, count }: StockSheet) => ({
  ...{ width, height },
  count: Math.min(count ?? MOST, MOST),
});

/** Number of copies of each drawing on the sheet. */
function counted({ placed }: Draft): Map<string, number> {
  const counts = new Map<string, number>();
  for (const { drawing, columns, rows } of placed)
    counts.set(drawing, (counts.get(drawing) ?? 0) + columns * rows);
  return counts;
}

export function NestPanel({ draft, nameOf, onFound }: Props) {
  const { gap, margin, board, grain } = draft.sheet;
  const present = counted(draft);
  const [counts, setCounts] = useState<ReadonlyMap<string, number>>(new Map());
  const [seconds, setSeconds] = useState(10);
  const [running, setRunning] = useState<string | null>(null);
  const [fault, setFault] = useState("");
  const [last, setLast] = useState<Nesting | null>(null);
  const [fromStock, setFromStock] = useState(false);
  const [inHoles, setInHoles] = useState(true);
  const { data: stock } = useStock(board);
  // Sheets with another grain would turn the blanks against it.
  const usable = (stock ?? []).filter((one) => (one.grain ?? null) === grain);

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
        ...{ sheet: draft.sheet, margins, gap, parts, seconds, in_holes: inHoles },
        left_overs: fromStock ? usable.map(leftOver) : [],
      } as Parameters<typeof layoutService.beginNesting>[0]);
      setLast(begun);
      setRunning(begun.id);
    });
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
      {usable.length > 0 && (
        <Switch
          size="xs"
          label={translate("layoutEditor.fromStock")}
          checked={fromStock}
          onChange={(event) => setFromStock(event.currentTarget.checked)}
          data-testid="nest-from-stock"
        />
      )}
      <Switch
        size="xs"
        label={translate("layoutEditor.useHoles")}
        checked={inHoles}
        onChange={(event) => setInHoles(event.currentTarget.checked)}
        data-testid="nest-in-holes"
      />
      <NumberInput
        hideControls
        label={translate("layoutEditor.timeS")}
        size="xs"
        min={1}
        max={600}
        value={seconds}
        onChange={(value) => typeof value === "number" && setSeconds(value)}
      />
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
        {last !== null && last.in_holes > 0
          ? ` ${translate("layoutEditor.inHoles", { n: last.in_holes })}`
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
