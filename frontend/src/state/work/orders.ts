/** Rows of the table of work: the next action of each, and drawings of the same file together. */

import type { Job, JobState, OrderRow } from "../../api/jobs";
import { translate } from "../../language/translate";
import { isOutdated } from "../drawing/steps";
import { awaitsEnd, isCompiling, isOnTable, needsOperator } from "../job/jobs";
import { drawingPath, stationAddress } from "../routes";

export interface NextAction {
  readonly title: string;
  /** Where it is done. */
  readonly href: string;
  /** The person is needed now. */
  readonly urgent: boolean;
}

/** Groups of states by which the table is filtered. */
export const PROGRESS = {
  all: [],
  prepare: ["none", "received", "compiling", "refused"],
  ready: ["ready"],
  machine: ["queued", "running", "held", "interrupted"],
  ended: ["done", "scrapped", "continued", "cancelled"],
} as const satisfies Readonly<Record<string, readonly (JobState | "none")[]>>;
export type ProgressGroup = keyof typeof PROGRESS;

/** What a person does next with a drawing. */
export function nextAction({ drawing, job }: OrderRow): NextAction {
  const at = (step: "lines" | "sheet" | "check") =>
    `#${drawingPath({ drawing: drawing.id, step, job: job?.id ?? null })}`;
  if (drawing.questions > 0 && (job === null || job.state === "refused"))
    return {
      title: translate("orders.answerQuestions", { questions: drawing.questions }),
      href: at("lines"),
      urgent: true,
    };
  if (job === null) return { title: translate("orders.prepare"), href: at("sheet"), urgent: false };
  if (isCompiling(job))
    return { title: translate("orders.beingPrepared"), href: at("check"), urgent: false };
  if (!isAtMachine(job) && job.state !== "queued" && isOutdated(job, drawing))
    return {
      title: translate("orders.prepareAgain"),
      href: `#${drawingPath({ drawing: drawing.id, step: "sheet", job: null })}`,
      urgent: false,
    };
  if (job.state === "ready")
    return { title: translate("orders.send"), href: at("check"), urgent: true };
  if (job.state === "refused")
    return { title: translate("orders.lookAtTheRefusal"), href: at("check"), urgent: true };
  if (isAtMachine(job))
    return {
      title: translate("orders.atTheMachine"),
      href: stationAddress(job.machine),
      urgent: needsOperator(job) || awaitsEnd(job) || job.state === "interrupted",
    };
  if (job.state === "queued" || job.waiting_for !== "")
    return { title: translate("orders.inTheQueue"), href: "#/machines", urgent: false };
  return { title: translate("orders.prepareAgain"), href: at("check"), urgent: false };
}

const isAtMachine = (job: Job): boolean =>
  isOnTable(job) || job.state === "interrupted" || needsOperator(job);

/** A row with further drawings of the same file. */
export interface RowGroup {
  readonly first: OrderRow;
  readonly others: readonly OrderRow[];
}

/** Rows by the file of their drawings, in the order of the list. A row that is listed twice is one. */
export function groupByFile(rows: readonly OrderRow[]): readonly RowGroup[] {
  const groups = new Map<string, OrderRow[]>();
  const seen = new Set<string>();
  for (const row of rows) {
    if (seen.has(row.drawing.id)) continue;
    seen.add(row.drawing.id);
    const group = groups.get(row.file);
    if (group === undefined) groups.set(row.file, [row]);
    else group.push(row);
  }
  return [...groups.values()].flatMap(([first, ...others]) =>
    first === undefined ? [] : [{ first, others }],
  );
}
