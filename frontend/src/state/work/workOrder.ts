/** The order of the table of work: the column by which it is sorted, and in which direction. */

import type { OrdersFilter } from "../../api/jobs";

export type WorkColumn = Exclude<NonNullable<OrdersFilter["sort"]>, "newest">;

export interface WorkOrder {
  /** "newest": last uploaded first, as long as no column is chosen */
  readonly sort: WorkColumn | "newest";
  readonly reverse: boolean;
}

export const NEWEST: WorkOrder = { sort: "newest", reverse: false };

/** The order after a click on a column: ascending, then descending, then the newest first. */
export const nextOrder = ({ sort, reverse }: WorkOrder, column: WorkColumn): WorkOrder =>
  sort !== column ? { sort: column, reverse: false } : reverse ? NEWEST : { sort, reverse: true };

/** Value of `aria-sort` of a column. */
export const ariaSort = (order: WorkOrder, column: WorkColumn) =>
  order.sort !== column ? "none" : order.reverse ? "descending" : "ascending";
