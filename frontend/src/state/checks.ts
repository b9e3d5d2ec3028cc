/** What a person checks at the table, one by one, before a job or its next copy starts. */

import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import type { Board, Confirmation, Drawing, Job } from "../api/client";
import { formatSize } from "./format";
import { needsOperator } from "./jobs";
import { queries, useBoards, useDrawing, useJob } from "./queries";
import { sheetText } from "./sheet";
import { useWornTools } from "./wornTools";

export interface Check {
  readonly key: string;
  readonly title: string;
  readonly detail: string;
  /** Number of the station if a tool is checked; null otherwise. */
  readonly station: number | null;
  /** The tool is worn. */
  readonly warns: boolean;
}

type Tool = Confirmation["tools"][number];

/** A change of this text makes all ticks void: they were made for something else. */
export const checksKey = ({ id, copies_done, waiting_for }: Job): string =>
  `${id} ${copies_done} ${waiting_for}`;

const check = (key: string, title: string, detail: string): Check => ({
  key,
  title,
  detail,
  station: null,
  warns: false,
});

function placeText({ placement, sheet }: Confirmation, drawing: Drawing | undefined): string {
  const [x, y] = placement;
  const parts = [`Lower left corner of the drawing at X ${x}, Y ${y} mm`];
  if (drawing !== undefined) {
    const [left, bottom, right, top] = drawing.bounds;
    parts.push(`it needs ${formatSize(right - left, top - bottom)}`);
  }
  if (sheet !== null) parts.unshift(`Sheet ${sheetText(sheet)}`);
  return parts.join("; ");
}

export const formatMetres = (length: number): string =>
  length.toLocaleString("en", { maximumFractionDigits: length < 10 ? 1 : 0 });

function wearText({ used, life, warning }: Tool): string {
  if (used === null) return "";
  const worn = `has worked ${formatMetres(used)}${life === null ? "" : ` of ${formatMetres(life)}`} m`;
  if (warning === "over") return `${worn}: its life is used up, change it`;
  return warning === "near" ? `${worn}: change it soon` : worn;
}

const toolCheck = (tool: Tool): Check => ({
  key: `tool ${tool.station}`,
  title: tool.name,
  detail: [`In station ${tool.station}`, wearText(tool)].filter((part) => part !== "").join("; "),
  station: tool.station,
  warns: tool.warning !== "",
});

/** The checks before a copy starts; between two copies only what has changed since. */
export function checksOf(
  asked: Confirmation,
  board: Board | undefined,
  drawing: Drawing | undefined,
): readonly Check[] {
  const next = asked.copy > 1 && !asked.first_of_batch;
  const tools = next ? asked.tools.filter(({ warning }) => warning !== "") : asked.tools;
  return [
    check(
      "board",
      board?.title || asked.board,
      asked.rest_of_sheet
        ? "The begun sheet is on the table"
        : next
          ? "A new sheet of this board is on the table"
          : "This board is on the table",
    ),
    asked.rest_of_sheet
      ? check("place", "The sheet was not moved", "The job continues what was begun on it")
      : check("place", "Sheet is in its place and held", placeText(asked, drawing)),
    ...tools.map(toolCheck),
    ...(asked.unfinished_sheet === ""
      ? []
      : [
          check(
            "unfinished",
            "Unfinished sheet is removed",
            `Job ${asked.unfinished_sheet} was stopped, and its sheet may still lie on the table`,
          ),
        ]),
    check(
      "clear",
      "Table is clear",
      next
        ? "The finished sheet is removed; no hands or things are in the way"
        : "No hands or things are in the way of the head",
    ),
  ];
}

const NO_KEYS: ReadonlySet<string> = new Set();

/**
 * The checks of the open job, which of them the person has ticked (null: not known yet), and the
 * decision about worn tools.
 */
export function useChecks() {
  const { data: job } = useJob();
  const { data: drawing } = useDrawing();
  const { data: boards } = useBoards();
  const [ticks, setTicks] = useState({ of: "", keys: NO_KEYS });
  const of = job === undefined ? "" : checksKey(job);
  const { data: asked } = useQuery({
    ...queries.confirmation(job?.id ?? "", of),
    enabled: job !== undefined && needsOperator(job),
  });
  const board = boards?.find(({ name }) => name === asked?.board);
  const checks = asked === undefined ? null : checksOf(asked, board, drawing);
  const ticked = ticks.of === of ? ticks.keys : NO_KEYS;
  const tick = (key: string) => {
    const keys = new Set(ticked);
    if (!keys.delete(key)) keys.add(key);
    setTicks({ of, keys });
  };
  return { checks, ticked, tick, wornTools: useWornTools(asked, of) };
}

/** Stations whose tools are among the checks; null if none is. */
export function checkedStations(checks: readonly Check[]): number[] | null {
  const found = checks.flatMap(({ station }) => (station === null ? [] : [station]));
  return found.length === 0 ? null : found;
}
