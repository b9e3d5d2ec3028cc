/** A layout: the sheet with its drawings, the list of them, nesting, and the order of the sheet. */

import "../../messages/load";
import { useQuery } from "@tanstack/react-query";
import { type KeyboardEvent, useMemo, useRef, useState } from "react";
import { type Layout, layoutService, type Nesting, type Placed } from "../../api/layouts";
import type { Box } from "../../geometry/records";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";
import { AddDrawing } from "./AddDrawing";
import { AlignBar } from "./AlignBar";
import { collidingCopies } from "./collisions";
import { LayoutHead } from "./LayoutHead";
import css from "./layout.module.css";
import { NestPanel } from "./NestPanel";
import { PlacedList } from "./PlacedList";
import {
  type Alignment,
  alignShift,
  atOrigin,
  change,
  type Draft,
  mostCopies,
  normalTurn,
  round,
  snapShift,
} from "./placing";
import { remnantOf } from "./remnant";
import { SheetCanvas } from "./SheetCanvas";
import { SheetForm } from "./SheetForm";
import { StockPanel } from "./StockPanel";
import { boxOfCopy, boxOfPlaced, copiesOf } from "./shapes";
import { useDraft } from "./useDraft";
import { useShapes } from "./useShapes";

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
  const edited = useDraft(layout);
  const { draft, put } = edited;
  const { sheet, placed } = draft;
  const { gap, margin } = sheet;
  const [chosen, setChosen] = useState<ReadonlySet<number>>(
    new Set(layout.placed.length ? [0] : []),
  );
  const [fault, setFault] = useState("");
  const dragged = useRef<Draft | null>(null);
  const beforeNesting = useRef<Draft | null>(null);

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
  const undoOrRedo = (event: KeyboardEvent) => {
    if (!(event.ctrlKey || event.metaKey) || event.key.toLowerCase() !== "z") return;
    if (event.shiftKey) edited.redo();
    else edited.undo();
    event.preventDefault();
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
    else return;
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
  const attempt = async (action: () => Promise<unknown>) => {
    setFault("");
    try {
      await action();
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    }
  };
  const order = () =>
    attempt(async () => {
      await edited.save();
      showDrawing(layout.id, null, "process");
      if (sheet.board !== "") useUiStore.getState().set({ board: sheet.board });
    });
  const shown = fault || (error === null ? "" : errorText(error));
  return (
    <main className={css.page} data-touch data-testid="layout-editor" onKeyDown={undoOrRedo}>
      <LayoutHead
        name={layout.name}
        edited={edited}
        use={use}
        copies={copies.length}
        canOrder={placed.length > 0 && colliding.size === 0}
        onSave={() => attempt(edited.save)}
        onOrder={order}
      />
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
          <SheetForm
            sheet={sheet}
            onChange={(fields) => put({ ...draft, sheet: { ...sheet, ...fields } })}
          />
          <StockPanel
            name={layout.name}
            sheet={sheet}
            remnant={remnantOf(copies, sheet, gap)}
            onChoose={(fields) => put({ ...draft, sheet: { ...sheet, ...fields } })}
            attempt={attempt}
          />
          <AddDrawing onAdd={(drawing) => add(atOrigin(drawing))} />
          <AlignBar disabled={chosen.size === 0} onAlign={align} />
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
          <NestPanel draft={draft} nameOf={nameOf} onFound={found} />
        </aside>
      </div>
    </main>
  );
}
