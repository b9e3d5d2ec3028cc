/** Number, customer and due time of an order, as they are shown with a job. */

import type { Job } from "../api/client";
import { hasDetails, isOverdue } from "../state/orderDetails";
import { dateTimeText } from "../state/times";
import css from "./orderDetails.module.css";

/** Number, customer and due time in one line; nothing if the job has none. */
export function OrderLine({ job, now = Date.now() / 1000 }: { job: Job; now?: number }) {
  if (!hasDetails(job)) return null;
  const overdue = isOverdue(job, now);
  return (
    <span className={css.line} data-testid="order-line">
      {job.external_id !== "" && <span className={css.number}>{job.external_id}</span>}
      {job.customer !== "" && <span>{job.customer}</span>}
      {job.due != null && (
        <time dateTime={job.due} className={css.due} data-overdue={overdue || undefined}>
          {overdue ? "overdue since" : "due"} {dateTimeText(job.due)}
        </time>
      )}
    </span>
  );
}

/** All details of the order of the open job. */
export function OrderCard({ job }: { job: Job }) {
  const metadata = Object.entries(job.metadata);
  if (!hasDetails(job) && job.notes === "" && metadata.length === 0) return null;
  return (
    <div className={css.card} data-testid="order-card">
      <OrderLine job={job} />
      {job.notes !== "" && <p className={css.notes}>{job.notes}</p>}
      {metadata.length > 0 && (
        <dl className={css.metadata}>
          {metadata.map(([key, value]) => (
            <div key={key}>
              <dt>{key}</dt>
              <dd>{String(value)}</dd>
            </div>
          ))}
        </dl>
      )}
    </div>
  );
}
