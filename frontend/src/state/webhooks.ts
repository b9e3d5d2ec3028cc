/** Texts about webhooks and their deliveries. */

import type { Delivery, DeliveryState, Webhook, WebhookEvent } from "../api/webhooks";
import { queries, queryClient } from "./queries";
import { dateTimeText } from "./times";

type Attempt = Delivery["attempts"][number];

/** Every type of event to which an endpoint can subscribe. */
export const EVENT_LABELS: Readonly<Record<WebhookEvent, string>> = {
  "job.received": "Job received",
  "job.compiling": "Job compiling",
  "job.ready": "Job ready",
  "job.queued": "Job queued",
  "job.running": "Job running",
  "job.held": "Job held",
  "job.done": "Job finished",
  "job.refused": "Job refused",
  "job.interrupted": "Job interrupted",
  "job.scrapped": "Board scrapped",
  "job.continued": "Job continued by another job",
  "job.cancelled": "Job cancelled",
  "job.updated": "Other change of a job",
  "drawing.read": "Drawing uploaded",
  "drawing.changed": "Drawing changed",
  "drawing.deleted": "Drawing deleted",
};

export const DELIVERY_LABELS: Readonly<Record<DeliveryState, string>> = {
  pending: "Waiting",
  delivered: "Delivered",
  dead: "Failed",
};

/** Names of events of an endpoint in one line. */
export const eventsText = (types: readonly WebhookEvent[]): string =>
  types.length === 0 ? "All events" : types.map((type) => EVENT_LABELS[type]).join(", ");

export const durationText = (seconds: number): string =>
  seconds < 1 ? `${Math.round(seconds * 1000)} ms` : `${seconds.toFixed(1)} s`;

export const statusText = ({ status }: Attempt): string =>
  status === 0 ? "No answer" : `Status ${status}`;

/** The beginning of the answer, or the reason why there was none. */
export const answerText = ({ answer, fault }: Attempt): string => answer || fault;

/** Result of the last attempt of a delivery, and what follows; undefined: not loaded yet. */
export function deliveryText(delivery: Delivery | undefined): string {
  const attempt = delivery?.attempts.at(-1);
  if (delivery === undefined || attempt === undefined) return "Not sent yet";
  const { state, next_attempt: next } = delivery;
  const result = `${statusText(attempt)} after ${durationText(attempt.seconds)}`;
  if (state === "delivered") return `Delivered: ${result}`;
  if (state === "dead" || next === null) return `Failed: ${result}`;
  return `${result}; next attempt ${dateTimeText(next)}`;
}

/** State of an endpoint in one line. */
export function healthText(webhook: Webhook): string {
  const { active, failures, last_delivery: last, paused_until: paused } = webhook;
  if (!active) return "Switched off";
  if (paused !== null)
    return `Paused until ${dateTimeText(paused)} after ${failures} failed attempts`;
  if (failures > 0)
    return failures === 1 ? "The last attempt failed" : `${failures} failed attempts`;
  return last === null ? "Nothing sent yet" : "Working";
}

/** Fetch the endpoints and all deliveries again. */
export async function refreshWebhooks(): Promise<void> {
  await Promise.all(
    [queries.webhooks().queryKey, ["deliveries"], ["delivery"]].map((queryKey) =>
      queryClient.invalidateQueries({ queryKey }),
    ),
  );
}
