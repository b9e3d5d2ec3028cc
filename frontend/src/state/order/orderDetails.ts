/** Details of an order: number in another system, customer, due time, notes and metadata. */

import type { Job, OrderDetails } from "../../api/jobs";
import { secondsOf } from "../times";

export const NO_DETAILS: OrderDetails = {
  external_id: "",
  customer: "",
  due: null,
  notes: "",
  metadata: {},
};

/** The details of a job or a drawing. */
export const detailsOf = ({ external_id, customer, due, notes, metadata }: OrderDetails) => ({
  external_id,
  customer,
  due: due ?? null,
  notes,
  metadata,
});

const OPEN_STATES: readonly Job["state"][] = [
  "received",
  "compiling",
  "ready",
  "queued",
  "running",
  "held",
  "interrupted",
];

/** Whether a job is not done although it was due; `now` in seconds since 1970. */
export const isOverdue = (job: Pick<Job, "due" | "state">, now: number): boolean =>
  job.due != null && OPEN_STATES.includes(job.state) && secondsOf(job.due) < now;

export const hasDetails = (job: OrderDetails): boolean =>
  job.external_id !== "" || job.customer !== "" || job.due != null;
