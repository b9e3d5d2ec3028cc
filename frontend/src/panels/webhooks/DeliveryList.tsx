/** Deliveries of a webhook with their attempts; each can be sent again. */

import { Button, Code, Flex, Group, SegmentedControl, Stack, Text } from "@mantine/core";
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
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { ShowMore } from "../shared/ShowMore";

interface Props {
  readonly webhook: string;
  readonly active: boolean;
  readonly act: (action: () => Promise<unknown>) => Promise<boolean>;
}

const STATES = [
  { value: "", label: translate("deliveryList.all") },
  ...Object.entries(DELIVERY_LABELS).map(([value, label]) => ({ value, label })),
];

const COLOURS: Readonly<Partial<Record<DeliveryState, string>>> = {
  dead: "var(--bad-ink)",
  pending: "var(--warn-ink)",
};

export function DeliveryList({ webhook, active, act }: Props) {
  const [state, setState] = useState("");
  const list = useDeliveries(webhook, (state || null) as DeliveryState | null);
  const rows = list.data ?? [];
  return (
    <Flex
      component="section"
      direction="column"
      gap={10}
      pt={12}
      className={css.divided}
      aria-label={translate("deliveryList.deliveries")}
    >
      <Group gap={8}>
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
      </Group>
      {list.error && <Text c="var(--bad-ink)">{errorText(list.error)}</Text>}
      {list.isSuccess && rows.length === 0 && (
        <Note py={10}>
          {state === ""
            ? translate("deliveryList.nothingWasSentInThe")
            : translate("deliveryList.thereAreNoDeliveriesIn")}
        </Note>
      )}
      <ul>
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
    </Flex>
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
    <li className={css.section} data-testid="delivery" data-state={state}>
      <button
        type="button"
        className={css.pick}
        style={{ flexWrap: "wrap", alignItems: "center" }}
        aria-expanded={open}
        aria-controls={body}
        onClick={() => setOpen(!open)}
      >
        <Text component="time" w={160} c="ink.2" dateTime={delivery.created}>
          {dateTimeText(delivery.created)}
        </Text>
        <Text span w={180} c="ink.0" fw={550}>
          {label || translate("deliveryList.test")}
        </Text>
        <Text span flex="1 1 160px" c={COLOURS[state] ?? "inherit"}>
          {deliveryText(delivery)}
        </Text>
        <IconChevronDown size={15} className={css.chevron} data-open={open} aria-hidden />
      </button>
      {open && (
        <Stack id={body} gap={10} px={8} pb={14}>
          {delivery.attempts.length === 0 ? (
            <Note py={10}>{translate("deliveryList.noAttemptIsCompleteYet")}</Note>
          ) : (
            <Flex component="ol" direction="column" gap={6}>
              {delivery.attempts.map((attempt) => (
                <Flex
                  component="li"
                  key={attempt.at}
                  wrap="wrap"
                  gap="2px 12px"
                  data-testid="attempt"
                >
                  <time dateTime={attempt.at}>{formatDateTime(new Date(attempt.at))}</time>
                  <span>{statusText(attempt)}</span>
                  <span>{durationText(attempt.seconds)}</span>
                  <Text span flex="1 1 200px" style={{ overflowWrap: "anywhere" }}>
                    {answerText(attempt) || translate("deliveryList.emptyResponse")}
                  </Text>
                </Flex>
              ))}
            </Flex>
          )}
          <Payload webhook={webhook} delivery={delivery.id} />
          <Group gap={8}>
            <Button
              size="sm"
              variant="default"
              disabled={!active}
              onClick={replay}
              data-testid="replay"
            >
              {translate("deliveryList.sendAgain")}
            </Button>
            <Text component="small" c="ink.3" style={{ overflowWrap: "anywhere" }}>
              {translateRich("deliveryList.webhookId", {
                id: delivery.id,
                code: (children) => <code>{children}</code>,
              })}
            </Text>
          </Group>
        </Stack>
      )}
    </li>
  );
}

/** The text that is sent. */
function Payload({ webhook, delivery }: { webhook: string; delivery: string }) {
  const { data } = useQuery({ ...queries.delivery(webhook, delivery), refetchInterval: false });
  if (data === undefined) return null;
  return (
    <Code block mah={260} fz={12} style={{ overflow: "auto" }} data-testid="payload">
      {JSON.stringify(JSON.parse(data.payload), null, 2)}
    </Code>
  );
}
