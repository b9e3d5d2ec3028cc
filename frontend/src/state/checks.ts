/** What a person checks at the table, one by one, before a job or its next copy starts. */

import type { Board, Drawing, Job, Machine } from "../api/client";
import { formatSize } from "./format";
import { sheetText } from "./sheet";

export interface Check {
  readonly key: string;
  readonly title: string;
  readonly detail: string;
}

/** A change of this text makes all ticks void: they were made for something else. */
export const checksKey = ({ id, copies_done, waiting_for }: Job): string =>
  `${id} ${copies_done} ${waiting_for}`;

function placeText(machine: Machine, drawing: Drawing): string {
  const [x, y] = machine.origin;
  const [left, bottom, right, top] = drawing.bounds;
  return (
    `Lower left corner of the drawing at X ${x}, Y ${y} mm; ` +
    `it needs ${formatSize(right - left, top - bottom)}`
  );
}

export function checksOf(
  job: Job,
  board: Board | undefined,
  machine: Machine,
  drawing: Drawing | undefined,
): readonly Check[] {
  const next = job.waiting_for === "sheet";
  const place = drawing === undefined ? "" : placeText(machine, drawing);
  const sheet = job.sheet === null ? "" : `Sheet ${sheetText(job.sheet)}. `;
  const checks: Check[] = [
    {
      key: "board",
      title: board?.title || job.board,
      detail: next ? "A new sheet of this board is on the table" : "This board is on the table",
    },
    { key: "place", title: "Sheet is in its place and held", detail: `${sheet}${place}` },
  ];
  // The tools were checked before the first sheet.
  if (!next) {
    for (const { station, name } of job.tools)
      checks.push({ key: `tool ${station}`, title: name, detail: `In station ${station}` });
  }
  checks.push({
    key: "clear",
    title: "Table is clear",
    detail: next
      ? "The finished sheet is removed; no hands or things are in the way"
      : "No hands or things are in the way of the head",
  });
  return checks;
}
