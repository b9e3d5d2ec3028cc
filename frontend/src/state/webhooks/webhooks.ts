/** Texts about webhooks and their deliveries. */

import type { Delivery, DeliveryState, Webhook, WebhookEvent } from "../../api/webhooks";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { queries, queryClient } from "../queries";
import { dateTimeText } from "../times";

type Attempt = Delivery["attempts"][number];

/** Every type of event to which an endpoint can subscribe. */
export const EVENT_LABELS: Readonly<Record<WebhookEvent, string>> = {
  "job.received": translate("webhookTexts.jobReceived"),
  "job.compiling": translate("webhookTexts.jobCompiling"),
  "job.ready": translate("webhookTexts.jobReady"),
  "job.queued": translate("webhookTexts.jobQueued"),
  "job.running": translate("webhookTexts.jobRunning"),
  "job.held": translate("webhookTexts.jobHeld"),
  "job.done": translate("webhookTexts.jobFinished"),
  "job.refused": translate("webhookTexts.jobRefused"),
  "job.interrupted": translate("webhookTexts.jobInterrupted"),
  "job.scrapped": translate("webhookTexts.boardScrapped"),
  "job.continued": translate("webhookTexts.jobContinuedByAnotherJob"),
  "job.cancelled": translate("webhookTexts.jobCancelled"),
  "job.updated": translate("webhookTexts.otherChangeOfAJob"),
  "drawing.read": translate("webhookTexts.drawingUploaded"),
  "drawing.changed": translate("webhookTexts.drawingChanged"),
  "drawing.deleted": translate("webhookTexts.drawingDeleted"),
};

export const DELIVERY_LABELS: Readonly<Record<DeliveryState, string>> = {
  pending: translate("webhookTexts.waiting"),
  delivered: translate("webhookTexts.delivered"),
  dead: translate("webhookTexts.failed"),
};

/** Names of events of an endpoint in one line. */
export const eventsText = (types: readonly WebhookEvent[]): string =>
  types.length === 0
    ? translate("webhookTexts.allEvents")
    : types.map((type) => EVENT_LABELS[type]).join(", ");

export const durationText = (seconds: number): string =>
  seconds < 1
    ? translate("webhookTexts.ms", { seconds: Math.round(seconds * 1000) })
    : translate("webhookTexts.s", { seconds: formatFixed(seconds, 1) });

export const statusText = ({ status }: Attempt): string =>
  status === 0 ? translate("webhookTexts.noAnswer") : translate("webhookTexts.status", { status });

/** The beginning of the answer, or the reason why there was none. */
export const answerText = ({ answer, fault }: Attempt): string => answer || fault;

/** Result of the last attempt of a delivery, and what follows; undefined: not loaded yet. */
export function deliveryText(delivery: Delivery | undefined): string {
  const attempt = delivery?.attempts.at(-1);
  if (delivery === undefined || attempt === undefined) return translate("webhookTexts.notSentYet");
  const { state, next_attempt: next } = delivery;
  const result = translate("webhookTexts.after", {
    attempt: statusText(attempt),
    seconds: durationText(attempt.seconds),
  });
  if (state === "delivered") return translate("webhookTexts.delivered2", { result });
  if (state === "dead" || next === null) return translate("webhookTexts.failed2", { result });
  return translate("webhookTexts.nextAttempt", { result, next: dateTimeText(next) });
}

/** State of an endpoint in one line. */
export function healthText(webhook: Webhook): string {
  const { active, failures, last_delivery: last, paused_until: paused } = webhook;
  if (!active) return translate("webhookTexts.switchedOff");
  if (paused !== null)
    return translate("webhookTexts.pausedUntilAfterFailedAttempts", {
      paused: dateTimeText(paused),
      failures,
    });
  if (failures > 0)
    return failures === 1
      ? translate("webhookTexts.theLastAttemptFailed")
      : translate("webhookTexts.failedAttempts", { failures });
  return last === null
    ? translate("webhookTexts.nothingSentYet")
    : translate("webhookTexts.working");
}

/** Fetch the endpoints and all deliveries again. */
export async function refreshWebhooks(): Promise<void> {
  await Promise.all(
    [queries.webhooks().queryKey, ["deliveries"], ["delivery"]].map((queryKey) =>
      queryClient.invalidateQueries({ queryKey }),
    ),
  );
}
