/** The queue of a machine: places of jobs, priorities, and texts of times. */

import type { Job, Neighbours } from "../../api/jobs";
import type { QueueEntry } from "../../api/machines";
import { translate } from "../../language/translate";
import { formatDuration } from "../format";

/** Priorities offered by name; the server accepts all numbers from -100 to 100. */
export const PRIORITIES: readonly { readonly value: number; readonly title: string }[] = [
  { value: 20, title: translate("queue.urgent") },
  { value: 10, title: translate("queue.high") },
  { value: 0, title: translate("queue.normal") },
  { value: -10, title: translate("queue.low") },
];

/** Name of a priority: that of the nearest offered one that is not higher. */
export const priorityTitle = (priority: number): string =>
  (PRIORITIES.find(({ value }) => priority >= value) ?? { title: translate("queue.low") }).title;

/** The entries that can be reordered: no machine has taken their jobs. */
export const waitingIds = (entries: readonly QueueEntry[]): readonly string[] =>
  entries.filter(({ place }) => place > 0).map(({ job }) => job.id);

/**
 * Neighbours of a job at another place.
 *
 * `index` is the number of other jobs before the place; null if the job is there already.
 */
export function neighboursAt(ids: readonly string[], id: string, index: number): Neighbours | null {
  const others = ids.filter((other) => other !== id);
  if (index < 0 || index > others.length || ids.indexOf(id) === index) return null;
  return { previous: others[index - 1] ?? "", next: others[index] ?? "" };
}

/** When a job starts, as a text; empty for the job that occupies the machine. */
export function startText({ place, starts_in, job }: QueueEntry): string {
  if (place === 0) return "";
  if (job.on_hold) return translate("queue.onHold");
  if (starts_in === null) return translate("queue.startUnknown");
  return starts_in < 1
    ? translate("queue.next")
    : translate("queue.in", { startsIn: formatDuration(starts_in) });
}

/** The job was changed by an action, not only by the progress of the machine. */
export const hasChanged = (before: Job | undefined, after: Job): boolean =>
  before === undefined ||
  before.updated !== after.updated ||
  before.state !== after.state ||
  before.waiting_for !== after.waiting_for;
