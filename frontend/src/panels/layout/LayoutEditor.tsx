/** A layout: the sheet with its drawings, the list of them, nesting, and the order of the sheet. */

import "../../messages/load";
import { ActionIcon, Button, NumberInput, Select, Title } from "@mantine/core";
import { IconArrowBackUp, IconArrowForwardUp } from "@tabler/icons-react";
import { useQuery } from "@tanstack/react-query";
import { type KeyboardEvent, useEffect, useMemo, useRef, useState } from "react";
import { type Layout, layoutService, type Nesting, type Placed } from "../../api/layouts";
import type { Box } from "../../geometry/records";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { queryClient, useOrders } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { collidingCopies } from "./collisions";
import css from "./layout.module.css";
import { NestPanel } from "./NestPanel";
import { PlacedList } from "./PlacedList";
import {
  ALIGNMENTS,
  type Alignment,
  alignShift,
  begin,
  change,
  type Draft,
  type History,
  mostCopies,
  normalTurn,
  record,
  redo,
  round,
  snapShift,
  undo,
} from "./placing";
import { SheetCanvas } from "./SheetCanvas";
import { boxOfCopy, boxOfPlaced, copiesOf } from "./shapes";
import { useShapes } from "./useShapes";

/** Gap between copies and margin of the sheet at first (mm). */
const GAP = 5;
const MARGIN = 10;

const draftOf = ({ sheet, placed }: Layout): Draft => ({
  sheet: { ...sheet, grain: sheet.grain ?? null, side_up: sheet.side_up ?? "outside" },
  // The page lays out the present revisions.
  placed: placed.map((one) => ({ ...(one as Placed), revision: null })),
});

export function LayoutEditor({ id }: { readonly id: string }) {
  const { data, error } = useQuery({
    queryKey: ["layout", id],
    queryFn: ({ signal }) => layoutService.get(id, signal),
    staleTime: Number.POSITIVE_INFINITY,
  });
  if (error !== null)
    return (
      <main className={css.page}>
        <p role="alert">{errorText(error)}</p>
        <a href="#/">{translate("layoutEditor.backToDrawings")}</a>
      </main>
    );
  return data === undefined ? null : <Editor key={id} layout={data} />;
}

function Editor({ layout }: { readonly layout: Layout }) {
  const [history, setHistory] = useState<History>(() => begin(draftOf(layout)));
  const [stored, setStored] = useState<{ revision: number; draft: Draft }>(() => ({
    revision: layout.revision,
    draft: history.present,
  }));
  const [chosen, setChosen] = useState<ReadonlySet<number>>(
    new Set(layout.placed.length ? [0] : []),
  );
  const [fault, setFault] = useState("");
  const [gap, setGap] = useState(GAP);
  const [margin, setMargin] = useState(MARGIN);
  const dragged = useRef<Draft | null>(null);
  const beforeNesting = useRef<Draft | null>(null);

  const draft = history.present;
  const { sheet, placed } = draft;
  const ids = useMemo(() => [...new Set(placed.map(({ drawing }) => drawing))].sort(), [placed]);
  const { drawings, shapeOf, error } = useShapes(ids);
  const copies = useMemo(() => copiesOf(placed, shapeOf), [placed, shapeOf]);
  const colliding = useMemo(() => collidingCopies(copies, sheet), [copies, sheet]);
  const collidingPlaced = new Set([...colliding].map((index) => copies[index]?.placed ?? -1));
  const area = placed.reduce(
    (sum, { drawing, columns, rows }) => sum + (drawings.get(drawing)?.area ?? 0) * columns * rows,
    0,
  );
  const use = (100 * area) / (sheet.width * sheet.height);
  const nameOf = (drawing: string) => drawings.get(drawing)?.name ?? drawing;

  /** The sheet within its margins. */
  const window: Box = [margin, margin, sheet.width - margin, sheet.height - margin];
  const put = (next: Draft, joined = false) => setHistory((now) => record(now, next, joined));
  const edit = (fields: (one: Placed) => Partial<Placed>) => put(change(draft, chosen, fields));
  const choose = (index: number, more: boolean) =>
    setChosen((now) => {
      if (!more) return new Set([index]);
      const next = new Set(now);
      if (!next.delete(index)) next.add(index);
      return next;
    });
  const boxOf = (one: Placed): Box | null => {
    const shape = shapeOf(one);
    return shape === undefined ? null : boxOfPlaced(one, shape);
  };

  const drag = (x: number, y: number, reach: number) => {
    const isFirst = dragged.current === null;
    dragged.current ??= draft;
    const moved = change(dragged.current, chosen, (one) => ({ x: one.x + x, y: one.y + y }));
    const [first] = chosen;
    const box = first === undefined ? null : boxOf(moved.placed[first] as Placed);
    const others = copies.filter((copy) => !chosen.has(copy.placed)).map(boxOfCopy);
    const frames: Box[] = [[0, 0, sheet.width, sheet.height], window, ...others];
    const [toX, toY] = box === null ? [0, 0] : snapShift(box, frames, gap, reach);
    const snapped = change(moved, chosen, (one) => ({
      x: round(one.x + toX),
      y: round(one.y + toY),
    }));
    put(snapped, !isFirst);
  };
  const align = (alignment: Alignment) => {
    const boxes = [...chosen].map((index) => boxOf(placed[index] as Placed));
    const known = boxes.filter((box) => box !== null);
    // One drawing is aligned with the margins of the sheet, several with the first of them.
    const frame: Box = known.length === 1 ? window : (known[0] ?? window);
    edit((one) => {
      const box = boxOf(one);
      if (box === null) return {};
      const [x, y] = alignShift(box, frame, alignment);
      return { x: round(one.x + x), y: round(one.y + y) };
    });
  };
  const remove = (removed: ReadonlySet<number>) => {
    put({ ...draft, placed: placed.filter((_, index) => !removed.has(index)) });
    setChosen(new Set());
  };
  const add = (one: Placed) => {
    put({ ...draft, placed: [...placed, one] });
    setChosen(new Set([placed.length]));
  };
  const steps = (event: KeyboardEvent): boolean => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return false;
    setHistory(event.shiftKey ? redo : undo);
    return true;
  };
  const press = (event: KeyboardEvent) => {
    const step = event.shiftKey ? 10 : event.altKey ? 0.1 : 1;
    const moves: Record<string, readonly [number, number]> = {
      ArrowLeft: [-step, 0],
      ArrowRight: [step, 0],
      ArrowDown: [0, -step],
      ArrowUp: [0, step],
    };
    const move = moves[event.key];
    if (move !== undefined)
      edit((one) => ({ x: round(one.x + move[0]), y: round(one.y + move[1]) }));
    else if (event.key === "r")
      edit(({ turn }) => ({ turn: normalTurn(turn + (event.altKey ? -90 : 90)) }));
    else if (event.key === "m") edit(({ mirror }) => ({ mirror: !mirror }));
    else if (event.key === "Delete" || event.key === "Backspace") remove(chosen);
    else if (!steps(event)) return;
    event.preventDefault();
  };
  const fill = (index: number) => {
    const one = placed[index] as Placed;
    const shape = shapeOf(one);
    if (shape !== undefined)
      put(change(draft, new Set([index]), () => mostCopies(one, shape, sheet)));
  };
  const found = ({ sheets }: Nesting, ended: boolean) => {
    const [first, ...others] = sheets;
    if (first === undefined) return;
    const isFirst = beforeNesting.current === null;
    beforeNesting.current ??= draft;
    const nested = first.placed.map((one) => ({ ...(one as Placed), revision: null }));
    put({ ...draft, placed: nested }, !isFirst);
    if (!ended) return;
    beforeNesting.current = null;
    void attempt(async () => {
      for (const [index, { sheet: board, placed: on }] of others.entries())
        await layoutService.add(`${layout.name} ${index + 2}`, {
          sheet: { ...sheet, ...board },
          placed: on as Placed[],
        });
    });
  };
  const attempt = async (action: () => Promise<void>) => {
    setFault("");
    try {
      await action();
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    }
  };
  const save = async () => {
    if (draft === stored.draft) return;
    const next = await layoutService.replace(layout.id, stored.revision, draft);
    setStored({ revision: next.revision, draft });
    queryClient.setQueryData(["layout", layout.id], next);
    await queryClient.invalidateQueries({ queryKey: ["drawing", layout.id] });
    await queryClient.invalidateQueries({ queryKey: ["edges", layout.id] });
  };
  const order = () =>
    attempt(async () => {
      await save();
      showDrawing(layout.id, null, "process");
    });

  const unsaved = draft !== stored.draft;
  useEffect(() => {
    if (!unsaved) return;
    const warn = (event: BeforeUnloadEvent) => event.preventDefault();
    addEventListener("beforeunload", warn);
    return () => removeEventListener("beforeunload", warn);
  }, [unsaved]);
  const size = (name: "width" | "height", label: string) => (
    <NumberInput
      hideControls
      label={label}
      size="xs"
      min={1}
      max={10000}
      value={sheet[name]}
      onChange={(value) =>
        typeof value === "number" &&
        value > 0 &&
        put({ ...draft, sheet: { ...sheet, [name]: value } })
      }
      data-testid={`layout-${name}`}
    />
  );
  const shown = fault || (error === null ? "" : errorText(error));
  return (
    <main
      className={css.page}
      data-touch
      data-testid="layout-editor"
      onKeyDown={(event) => steps(event) && event.preventDefault()}
    >
      <header className={css.head}>
        <Title order={1} fz={16} className={css.title}>
          {layout.name}
        </Title>
        <span data-testid="layout-use">
          {translate("layoutEditor.boardUse", {
            use: formatNumber(use, { maximumFractionDigits: 1 }),
            count: copies.length,
          })}
        </span>
        <ActionIcon
          variant="default"
          size="lg"
          disabled={history.past.length === 0}
          aria-label={translate("layoutEditor.undo")}
          onClick={() => setHistory(undo)}
          data-testid="layout-undo"
        >
          <IconArrowBackUp size={18} />
        </ActionIcon>
        <ActionIcon
          variant="default"
          size="lg"
          disabled={history.future.length === 0}
          aria-label={translate("layoutEditor.redo")}
          onClick={() => setHistory(redo)}
          data-testid="layout-redo"
        >
          <IconArrowForwardUp size={18} />
        </ActionIcon>
        <Button
          variant="default"
          disabled={!unsaved || placed.length === 0}
          onClick={() => attempt(save)}
          data-testid="layout-save"
        >
          {translate("layoutEditor.save")}
        </Button>
        <Button
          disabled={placed.length === 0 || colliding.size > 0}
          onClick={order}
          data-testid="layout-order"
        >
          {translate("layoutEditor.orderThisSheet")}
        </Button>
      </header>
      <p className={css.fault} role="alert" data-testid="layout-fault">
        {shown}
      </p>
      <p className={css.hidden} role="status">
        {colliding.size > 0 && translate("layoutEditor.collisions", { count: colliding.size })}
      </p>
      <div className={css.columns}>
        <SheetCanvas
          sheet={sheet}
          margin={margin}
          copies={copies}
          colliding={colliding}
          chosen={chosen}
          onChoose={choose}
          onChooseNone={() => setChosen(new Set())}
          onDrag={drag}
          onDragEnd={() => {
            dragged.current = null;
          }}
          onKey={press}
        />
        <aside className={css.side} aria-label={translate("layoutEditor.sheetAndDrawings")}>
          <div className={css.three}>
            {size("width", translate("layoutEditor.widthMm"))}
            {size("height", translate("layoutEditor.heightMm"))}
            <Select
              label={translate("layoutEditor.grain")}
              size="xs"
              data={[
                { value: "", label: translate("layoutEditor.noGrain") },
                { value: "x", label: translate("layoutEditor.grainAlongX") },
                { value: "y", label: translate("layoutEditor.grainAlongY") },
              ]}
              value={sheet.grain ?? ""}
              allowDeselect={false}
              onChange={(value) =>
                put({
                  ...draft,
                  sheet: { ...sheet, grain: value === "x" || value === "y" ? value : null },
                })
              }
            />
          </div>
          <AddDrawing onAdd={(drawing) => add(atOrigin(drawing))} />
          <div className={css.align} role="toolbar" aria-label={translate("layoutEditor.align")}>
            {ALIGNMENTS.map((alignment) => (
              <Button
                key={alignment}
                size="compact-xs"
                variant="default"
                disabled={chosen.size === 0}
                onClick={() => align(alignment)}
                data-testid={`align-${alignment}`}
              >
                {ALIGNMENT_LABELS[alignment]}
              </Button>
            ))}
          </div>
          <PlacedList
            placed={placed}
            nameOf={({ drawing }) => nameOf(drawing)}
            chosen={chosen}
            colliding={collidingPlaced}
            onChoose={choose}
            onChange={(index, fields) => put(change(draft, new Set([index]), () => fields))}
            onFill={fill}
            onDuplicate={(index) => {
              const one = placed[index] as Placed;
              add({ ...one, x: round(one.x + 10), y: round(one.y + 10) });
            }}
            onRemove={(index) => remove(new Set([index]))}
          />
          <NestPanel
            draft={draft}
            gap={gap}
            margin={margin}
            onGap={setGap}
            onMargin={setMargin}
            nameOf={nameOf}
            onFound={found}
          />
        </aside>
      </div>
    </main>
  );
}

const ALIGNMENT_LABELS: Readonly<Record<Alignment, string>> = {
  left: translate("layoutEditor.left"),
  right: translate("layoutEditor.right"),
  below: translate("layoutEditor.below"),
  above: translate("layoutEditor.above"),
  centreX: translate("layoutEditor.centreX"),
  centreY: translate("layoutEditor.centreY"),
};

/** One copy of a drawing at the lower left corner of the sheet. */
export const atOrigin = (drawing: string): Placed => ({
  ...{ drawing, revision: null, x: 0, y: 0, turn: 0, mirror: false },
  ...{ columns: 1, rows: 1, gap_x: 5, gap_y: 5 },
});

const NEWEST = { sort: "newest" } as const;

/** The drawings of the server, of which one is placed on the sheet. */
function AddDrawing({ onAdd }: { readonly onAdd: (drawing: string) => void }) {
  const { data: rows } = useOrders(NEWEST);
  return (
    <Select
      label={translate("layoutEditor.addADrawing")}
      size="xs"
      searchable
      data={(rows ?? [])
        .filter(({ drawing }) => drawing.unit !== null && !drawing.is_layout)
        .map(({ drawing }) => ({ value: drawing.id, label: drawing.name }))}
      value={null}
      onChange={(id) => id !== null && onAdd(id)}
      data-testid="layout-add"
    />
  );
}
