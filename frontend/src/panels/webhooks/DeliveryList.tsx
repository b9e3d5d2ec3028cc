/** Deliveries of a webhook with their attempts; each can be sent again. */

import { Button, Code, SegmentedControl } from "@mantine/core";
import { IconChevronDown } from "@tabler/icons-react";
import { useQuery } from "@tanstack/react-query";
import { useId, useState } from "react";
import { type Delivery, type DeliveryState, webhookService } from "../../api/webhooks";
import { formatDateTime } from "../../language/numbers";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { errorText } from "../../messages/translateMessage";
import { queries, useDeliveries } from "../../state/queries";
import { dateTimeText } from "../../state/times";
import {
  answerText,
  DELIVERY_LABELS,
  deliveryText,
  durationText,
  EVENT_LABELS,
  statusText,
} from "../../state/webhooks/webhooks";
import { ShowMore } from "../shared/ShowMore";
import css from "./webhooks.module.css";

interface Props {
  readonly webhook: string;
  readonly active: boolean;
  readonly act: (action: () => Promise<unknown>) => Promise<boolean>;
}

const STATES = [
  { value: "", label: translate("deliveryList.all") },
  ...Object.entries(DELIVERY_LABELS).map(([value, label]) => ({ value, label })),
];

export function DeliveryList({ webhook, active, act }: Props) {
  const [state, setState] = useState("");
  const list = useDeliveries(webhook, (state || null) as DeliveryState | null);
  const rows = list.data ?? [];
  return (
    <section className={css.deliveries} aria-label={translate("deliveryList.deliveries")}>
      <div className={css.actions}>
        <SegmentedControl
          value={state}
          onChange={setState}
          data={STATES}
          aria-label={translate("deliveryList.stateOfTheDeliveries")}
        />
        <Button
          variant="default"
          disabled={!active}
          onClick={() => void act(() => webhookService.replayDeadLetters(webhook))}
          data-testid="replay-all"
        >
          {translate("deliveryList.sendAllFailedDeliveriesAgain")}
        </Button>
      </div>
      {list.error && <p className={css.fault}>{errorText(list.error)}</p>}
      {list.isSuccess && rows.length === 0 && (
        <p className={css.note}>
          {state === ""
            ? translate("deliveryList.nothingWasSentInThe")
            : translate("deliveryList.thereAreNoDeliveriesIn")}
        </p>
      )}
      <ul className={css.list}>
        {rows.map((delivery) => (
          <Row
            key={delivery.id}
            delivery={delivery}
            webhook={webhook}
            active={active}
            replay={() => void act(() => webhookService.replayDelivery(webhook, delivery.id))}
          />
        ))}
      </ul>
      {list.hasNextPage && (
        <ShowMore busy={list.isFetchingNextPage} act={() => void list.fetchNextPage()} />
      )}
    </section>
  );
}

interface RowProps {
  readonly delivery: Delivery;
  readonly webhook: string;
  readonly active: boolean;
  readonly replay: () => void;
}

function Row({ delivery, webhook, active, replay }: RowProps) {
  const [open, setOpen] = useState(false);
  const body = useId();
  const { event_type: type, state } = delivery;
  const label: string = type in EVENT_LABELS ? EVENT_LABELS[type as keyof typeof EVENT_LABELS] : "";
  return (
    <li className={css.delivery} data-testid="delivery" data-state={state}>
      <button
        type="button"
        className={css.summary}
        aria-expanded={open}
        aria-controls={body}
        onClick={() => setOpen(!open)}
      >
        <time dateTime={delivery.created}>{dateTimeText(delivery.created)}</time>
        <span className={css.type}>{label || translate("deliveryList.test")}</span>
        <span className={css.result}>{deliveryText(delivery)}</span>
        <IconChevronDown size={15} className={css.chevron} data-open={open} aria-hidden />
      </button>
      {open && (
        <div id={body} className={css.body}>
          {delivery.attempts.length === 0 ? (
            <p className={css.note}>{translate("deliveryList.noAttemptIsCompleteYet")}</p>
          ) : (
            <ol className={css.attempts}>
              {delivery.attempts.map((attempt) => (
                <li key={attempt.at} data-testid="attempt">
                  <time dateTime={attempt.at}>{formatDateTime(new Date(attempt.at))}</time>
                  <span>{statusText(attempt)}</span>
                  <span>{durationText(attempt.seconds)}</span>
                  <span className={css.answer}>
                    {answerText(attempt) || translate("deliveryList.emptyResponse")}
                  </span>
                </li>
              ))}
            </ol>
          )}
          <Payload webhook={webhook} delivery={delivery.id} />
          <div className={css.actions}>
            <Button
              size="sm"
              variant="default"
              disabled={!active}
              onClick={replay}
              data-testid="replay"
            >
              {translate("deliveryList.sendAgain")}
            </Button>
            <small>
              {translateRich("deliveryList.webhookId", {
                id: delivery.id,
                code: (children) => <code>{children}</code>,
              })}
            </small>
          </div>
        </div>
      )}
    </li>
  );
}

/** The text that is sent. */
function Payload({ webhook, delivery }: { webhook: string; delivery: string }) {
  const { data } = useQuery({ ...queries.delivery(webhook, delivery), refetchInterval: false });
  if (data === undefined) return null;
  return (
    <Code block className={css.payload ?? ""} data-testid="payload">
      {JSON.stringify(JSON.parse(data.payload), null, 2)}
    </Code>
  );
}
