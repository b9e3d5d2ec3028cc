/** Conditions on the rows of the table of work. */

import type { ProgressGroup } from "./orders";

export interface WorkFilter {
  readonly search: string;
  readonly progress: ProgressGroup;
  /** "" for all machines */
  readonly machine: string;
}

export const NO_FILTER: WorkFilter = { search: "", progress: "all", machine: "" };
