/** Number, customer and due time of an order, as they are shown with a job. */

import { Box, Flex, Paper, Text } from "@mantine/core";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { changedEdgeOptions, changedOptions } from "../../state/order/options";
import { hasDetails, isOverdue } from "../../state/order/orderDetails";
import { dateTimeText } from "../../state/times";
import css from "../shared/panels.module.css";
import { choiceLine, optionTitle } from "./edgeOptionTexts";
import { optionLabel, valueLabel } from "./optionTexts";

const OVERDUE = { c: "var(--bad-ink)", fw: 600 };

/** Number, customer and due time in one line; nothing if the job has none. */
export function OrderLine({ job, now = Date.now() / 1000 }: { job: Job; now?: number }) {
  if (!hasDetails(job)) return null;
  const overdue = isOverdue(job, now);
  return (
    <Flex
      component="span"
      wrap="wrap"
      gap="0 8px"
      c="ink.1"
      fw={400}
      style={{ whiteSpace: "normal", overflowWrap: "anywhere" }}
      data-testid="order-line"
    >
      {job.external_id !== "" && (
        <Text span c="ink.0" fw={600}>
          {job.external_id}
        </Text>
      )}
      {job.customer !== "" && <span>{job.customer}</span>}
      {job.due != null && (
        <Text
          component="time"
          dateTime={job.due}
          {...(overdue ? OVERDUE : {})}
          data-overdue={overdue || undefined}
        >
          {overdue
            ? translate("orderDetails.overdueSince", { due: dateTimeText(job.due) })
            : translate("orderDetails.due", { due: dateTimeText(job.due) })}
        </Text>
      )}
    </Flex>
  );
}

/** All details of the order of the open job. */
export function OrderCard({ job }: { job: Job }) {
  const metadata = Object.entries(job.metadata);
  const changed = changedOptions(job);
  const ofEdges = changedEdgeOptions(job);
  const [inOrder, bridges] = [job.work_order.length, job.bridges.length];
  const listed = metadata.length + changed.length + ofEdges.length + inOrder + bridges;
  if (!hasDetails(job) && job.notes === "" && listed === 0) return null;
  return (
    <Paper px={10} py={8} data-testid="order-card">
      <OrderLine job={job} />
      {job.notes !== "" && (
        <Text style={{ overflowWrap: "anywhere", whiteSpace: "pre-line" }}>{job.notes}</Text>
      )}
      {listed > 0 && (
        <dl className={css.facts}>
          {changed.map((name) => (
            <Box key={name} display="contents" data-testid={`changed-${name}`}>
              <dt>{optionLabel(name)}</dt>
              <dd>{valueLabel(name, job[name])}</dd>
            </Box>
          ))}
          {ofEdges.map((name) => (
            <Box key={name} display="contents" data-testid={`changed-${name}`}>
              <dt>{optionTitle(name)}</dt>
              <dd>
                {job[name].map((choice) => (
                  <div key={JSON.stringify(choice)}>{choiceLine(name, choice)}</div>
                ))}
              </dd>
            </Box>
          ))}
          {inOrder > 0 && (
            <Box display="contents" data-testid="changed-work_order">
              <dt>{translate("processStep.workOrder")}</dt>
              <dd>{translate("workOrder.tracksInOrder", { n: inOrder })}</dd>
            </Box>
          )}
          {bridges > 0 && (
            <Box display="contents" data-testid="changed-bridges">
              <dt>{translate("bridges.bridges")}</dt>
              <dd>{translate("bridges.placed", { n: bridges })}</dd>
            </Box>
          )}
          {metadata.map(([key, value]) => (
            <Box key={key} display="contents">
              <dt>{key}</dt>
              <dd>{String(value)}</dd>
            </Box>
          ))}
        </dl>
      )}
    </Paper>
  );
}
