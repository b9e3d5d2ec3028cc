/** Options of an earlier order, to use them again. */

import type { Job } from "../../api/jobs";
import type { Choices } from "../store";
import { DEFAULT_CORNERS } from "./corners";
import { EDGE_OPTION_NAMES, type EdgeChoice } from "./edgeOptions";
import { DEFAULT_OPTIONS, OPTION_NAMES, type Options, optionsOf } from "./options";

/** What an earlier order decides. */
export type LastTime = Pick<Choices, "corners" | "lift" | "options">;

/**
 * The options of an order for a drawing. Those of single edges and corners stay with the drawing for
 * which they were chosen; those of line types go along.
 */
export function asLastTime(job: Job, drawing: string): LastTime {
  const corners = job.corners ?? DEFAULT_CORNERS;
  if (job.drawing === drawing) return { corners, lift: job.lift, options: optionsOf(job) };
  const plain = OPTION_NAMES.map((name) => [name, job[name]] as const);
  const ofTypes = EDGE_OPTION_NAMES.map((name) => {
    const choices: readonly EdgeChoice[] = job[name];
    return [name, choices.filter(({ line_type: type }) => type != null)] as const;
  });
  const options = { ...DEFAULT_OPTIONS, ...Object.fromEntries([...plain, ...ofTypes]) } as Options;
  return { corners: { ...corners, at: [] }, lift: job.lift, options };
}

/** Whether two sets of options are the same. */
export const isSame = (one: LastTime, other: LastTime): boolean =>
  JSON.stringify([one.corners, one.lift, sorted(one.options)]) ===
  JSON.stringify([other.corners, other.lift, sorted(other.options)]);

const sorted = (options: Options): unknown[] =>
  Object.entries(options).sort(([a], [b]) => (a < b ? -1 : 1));
