/** Rows of the list of edges: selected by click and by keys, scrolled to what the canvas selects. */

import { useVirtualizer } from "@tanstack/react-virtual";
import { type KeyboardEvent, type MouseEvent, useEffect, useMemo, useRef, useState } from "react";
import { type Edges, lineTypeOf } from "../../geometry/records";
import { translate } from "../../language/translate";
import {
  edgeState,
  LIST_COLUMNS,
  type ListColumn,
  type ListSort,
  rangeOf,
} from "../../state/drawing/edgeList";
import { movedPlace } from "../../state/drawing/listKeys";
import { LINE_STYLES } from "../../state/drawing/palette";
import { layerOf } from "../../state/drawing/rows";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useUiStore } from "../../state/store";
import { Swatch } from "../shared/Swatch";
import css from "./edgeList.module.css";
import { STATE_TITLES } from "./edgeStateTitles";

/** Height of a row (pixels), as in the style sheet. */
const HEIGHT = 32;

const TITLES: Readonly<Record<ListColumn, string>> = {
  row: translate("edgeList.number"),
  type: translate("selectMenu.lineType"),
  layer: translate("edgeList.layer"),
  length: translate("edgeList.length"),
  state: translate("edgeList.state"),
};

interface Props {
  readonly edges: Edges;
  /** Rows of the edges, in the order of the list. */
  readonly listed: readonly number[];
  readonly sort: ListSort;
  onSort(sort: ListSort): void;
}

export function EdgeTable({ edges, listed, sort, onSort }: Props) {
  const grid = useRef<HTMLDivElement>(null);
  const selection = useUiStore((ui) => ui.selection);
  const places = useMemo(() => new Map(listed.map((row, place) => [row, place])), [listed]);
  /** Edge at which the keyboard is, and edge at which a range begins. */
  const [active, setActive] = useState<number | null>(null);
  const [anchor, setAnchor] = useState<number | null>(null);
  const rows = useVirtualizer({
    count: listed.length,
    getScrollElement: () => grid.current,
    estimateSize: () => HEIGHT,
    overscan: 8,
    // The head is above the rows, and stays in view.
    scrollMargin: HEIGHT,
    scrollPaddingStart: HEIGHT,
  });
  const place = active === null ? -1 : (places.get(active) ?? -1);
  useFollowedSelection(selection, places, (row, at) => {
    setActive(row);
    setAnchor(row);
    rows.scrollToIndex(at, { align: "auto" });
  });

  /** Select the edge at a place: alone and zoomed to, with those since the anchor, or toggled. */
  const choose = (at: number, how: "alone" | "range" | "toggle") => {
    const row = listed[at];
    if (row === undefined) return;
    const { selectEdges, zoomToEdges } = useUiStore.getState();
    setActive(row);
    if (how === "range") {
      const from = anchor === null ? at : (places.get(anchor) ?? at);
      selectEdges(rangeOf(listed, from, at));
    } else {
      setAnchor(row);
      if (how === "toggle") selectEdges([row], "toggle");
      else zoomToEdges([row]);
    }
    rows.scrollToIndex(at, { align: "auto" });
  };

  const pressed = (event: KeyboardEvent) => {
    const command = event.ctrlKey || event.metaKey;
    if (command && event.key.toLowerCase() === "a") {
      useUiStore.getState().selectEdges(listed);
    } else if (event.key === " ") choose(place, "toggle");
    else if (event.key === "Enter") choose(place, "alone");
    else if (event.key === "Escape") useUiStore.getState().selectEdges([]);
    else {
      const page = Math.max(1, Math.floor((grid.current?.clientHeight ?? 0) / HEIGHT) - 2);
      const to = movedPlace(event.key, place, listed.length, page);
      if (to === null || command) return;
      choose(to, event.shiftKey ? "range" : "alone");
    }
    event.preventDefault();
  };

  const clicked = (event: MouseEvent, at: number) =>
    choose(at, event.shiftKey ? "range" : event.ctrlKey || event.metaKey ? "toggle" : "alone");

  const shown = rows.getVirtualItems();
  const above = (shown[0]?.start ?? HEIGHT) - HEIGHT;
  const below = rows.getTotalSize() - ((shown.at(-1)?.end ?? HEIGHT) - HEIGHT);
  return (
    <div ref={grid} className={css.grid}>
      <table
        // biome-ignore lint/a11y/noNoninteractiveElementToInteractiveRole: its rows are selected
        role="grid"
        className={css.table}
        aria-label={translate("edgeList.edgeList")}
        aria-rowcount={listed.length + 1}
        aria-multiselectable
        aria-activedescendant={place < 0 ? undefined : rowId(place)}
        tabIndex={0}
        onKeyDown={(event) => {
          // The heads are buttons with keys of their own.
          if (event.target === event.currentTarget) pressed(event);
        }}
        data-testid="edge-rows"
      >
        <Head sort={sort} onSort={onSort} />
        <tbody>
          <Space height={above} />
          {shown.map(({ index }) => {
            const row = listed[index] ?? 0;
            return (
              <Row
                key={row}
                edges={edges}
                row={row}
                place={index}
                selected={selection.has(row)}
                active={row === active}
                onClick={(event) => clicked(event, index)}
              />
            );
          })}
          <Space height={below} />
        </tbody>
      </table>
    </div>
  );
}

/** In place of the rows that are out of view. */
function Space({ height }: { height: number }) {
  if (height <= 0) return null;
  return (
    // biome-ignore lint/a11y/noAriaHiddenOnFocusable: a row without contents has no focus
    <tr aria-hidden="true" style={{ height }}>
      <td colSpan={LIST_COLUMNS.length} />
    </tr>
  );
}

const rowId = (place: number): string => `edge-row-${place}`;

/** Call `follow` with the first listed edge whenever the selection is changed elsewhere. */
function useFollowedSelection(
  selection: ReadonlySet<number>,
  places: ReadonlyMap<number, number>,
  follow: (row: number, place: number) => void,
): void {
  // biome-ignore lint/correctness/useExhaustiveDependencies: only a new selection is followed
  useEffect(() => {
    // What was chosen in the list contains the active edge, which is in view already.
    const within = document.activeElement?.closest("[data-testid=edge-rows]") != null;
    if (within) return;
    for (const row of selection) {
      const place = places.get(row);
      if (place === undefined) continue;
      follow(row, place);
      return;
    }
  }, [selection]);
}

interface HeadProps {
  readonly sort: ListSort;
  onSort(sort: ListSort): void;
}

function Head({ sort, onSort }: HeadProps) {
  return (
    <thead>
      <tr aria-rowindex={1}>
        {LIST_COLUMNS.map((column) => {
          const sorted = sort.column === column;
          const down = sorted && sort.down;
          return (
            <th
              key={column}
              scope="col"
              data-column={column}
              aria-sort={sorted ? (down ? "descending" : "ascending") : "none"}
            >
              <button
                type="button"
                className={css.sort}
                title={translate("edgeList.sortBy", { column: TITLES[column] })}
                onClick={() => onSort({ column, down: sorted && !down })}
                data-testid={`sort-${column}`}
              >
                {TITLES[column]}
                {sorted && <span aria-hidden>{down ? "▾" : "▴"}</span>}
              </button>
            </th>
          );
        })}
      </tr>
    </thead>
  );
}

interface RowProps {
  readonly edges: Edges;
  readonly row: number;
  readonly place: number;
  readonly selected: boolean;
  readonly active: boolean;
  onClick(event: MouseEvent): void;
}

function Row({ edges, row, place, selected, active, onClick }: RowProps) {
  const length = useFormatLength();
  const type = lineTypeOf(edges.lineType[row]);
  const layer = layerOf(edges, row);
  const state = edgeState(edges, row);
  return (
    <tr
      id={rowId(place)}
      className={css.row}
      aria-rowindex={place + 2}
      aria-selected={selected}
      data-active={active}
      data-row={row}
      onClick={onClick}
    >
      <td data-column="row">{row}</td>
      <td title={LINE_STYLES[type].title}>
        <span className={css.type}>
          <Swatch type={type} />
          <span className={css.cut}>{LINE_STYLES[type].title}</span>
        </span>
      </td>
      <td title={layer}>{layer}</td>
      <td data-column="length">{length(edges.length[row] ?? 0)}</td>
      {/* Most edges are as drawn: the others stand out. */}
      <td title={STATE_TITLES[state]}>{state === "kept" ? "" : STATE_TITLES[state]}</td>
    </tr>
  );
}
