/** One webhook: its state, what was sent to it, and what can be changed. */

import { Button, Group, Paper, Stack, Text } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type NewWebhook, type Webhook, webhookService } from "../../api/webhooks";
import { translate } from "../../language/translate";
import { queries } from "../../state/queries";
import { dateTimeText } from "../../state/times";
import { answerText, deliveryText, eventsText, healthText } from "../../state/webhooks/webhooks";
import { ConfirmDialog } from "../shared/ConfirmDialog";
import css from "../shared/panels.module.css";
import { DeliveryList } from "./DeliveryList";
import { WebhookForm } from "./WebhookForm";
import { RotationDialog, WebhookSecret } from "./WebhookSecret";

interface Props {
  readonly webhook: Webhook;
  /** Executes a request and shows its error; returns whether it succeeded. */
  readonly act: (action: () => Promise<unknown>) => Promise<boolean>;
}

/** The part that is open below the texts of a webhook. */
type View = "" | "edit" | "deliveries";

export function WebhookCard({ webhook, act }: Props) {
  const [view, setView] = useState<View>("");
  const [asking, setAsking] = useState<"" | "delete" | "rotate">("");
  const [test, setTest] = useState<string | null>(null);
  const [rotated, setRotated] = useState<NewWebhook | null>(null);
  const { id, active } = webhook;
  const toggle = (wanted: View) => setView(view === wanted ? "" : wanted);
  const rotate = (overlap: number) => {
    setAsking("");
    void act(async () => setRotated(await webhookService.rotateSecret(id, overlap)));
  };
  return (
    <Paper component="li" radius={12} p={16} mb={12} data-testid="webhook-row">
      <Stack gap={12}>
        <Texts webhook={webhook} />
        {test !== null && <TestResult webhook={id} delivery={test} />}
        {rotated !== null && <WebhookSecret webhook={rotated} onClose={() => setRotated(null)} />}
        <Group gap={8}>
          <Button
            size="sm"
            disabled={!active}
            onClick={() => void act(async () => setTest((await webhookService.test(id)).id))}
            data-testid="webhook-test"
          >
            {translate("webhookCard.sendATest")}
          </Button>
          <Button
            size="sm"
            variant="default"
            aria-expanded={view === "deliveries"}
            onClick={() => toggle("deliveries")}
            data-testid="webhook-deliveries"
          >
            {translate("webhookCard.deliveries")}
          </Button>
          <Button
            size="sm"
            variant="default"
            aria-expanded={view === "edit"}
            onClick={() => toggle("edit")}
            data-testid="webhook-edit"
          >
            {translate("webhookCard.edit")}
          </Button>
          <Button
            size="sm"
            variant="default"
            onClick={() => setAsking("rotate")}
            data-testid="webhook-rotate"
          >
            {translate("webhookCard.replaceTheSecret")}
          </Button>
          <Button
            size="sm"
            variant="default"
            onClick={() => void act(() => webhookService.change(id, { active: !active }))}
            data-testid="webhook-switch"
          >
            {active ? translate("webhookCard.switchOff") : translate("webhookCard.switchOn")}
          </Button>
          <Button size="sm" color="red" variant="light" onClick={() => setAsking("delete")}>
            {translate("webhookCard.delete")}
          </Button>
        </Group>
        {view === "edit" && (
          <WebhookForm
            fields={webhook}
            label={translate("webhookCard.save")}
            onSend={async ({ url, description, event_types }) => {
              const saved = await act(() =>
                webhookService.change(id, { url, description, event_types }),
              );
              if (saved) setView("");
              return saved;
            }}
            onCancel={() => setView("")}
          />
        )}
        {view === "deliveries" && <DeliveryList webhook={id} active={active} act={act} />}
        <RotationDialog
          opened={asking === "rotate"}
          onClose={() => setAsking("")}
          onRotate={rotate}
        />
        <ConfirmDialog
          confirmation={
            asking === "delete"
              ? {
                  title: translate("webhookCard.deleteTheWebhook"),
                  text: translate("webhookCard.noMoreEventsAreSent", { url: webhook.url }),
                  yes: translate("webhookCard.delete"),
                  no: translate("webhookCard.keep"),
                }
              : null
          }
          onYes={() => {
            setAsking("");
            void act(() => webhookService.delete(id));
          }}
          onNo={() => setAsking("")}
        />
      </Stack>
    </Paper>
  );
}

function Texts({ webhook }: { webhook: Webhook }) {
  const { active, failures, last_delivery: last, previous_secret_until: until } = webhook;
  const health = !active ? "ink.3" : failures > 0 ? "var(--bad-ink)" : "var(--good)";
  return (
    <Stack gap={4} style={{ overflowWrap: "anywhere" }}>
      <Text c="ink.0" fz={14}>
        <strong>{webhook.url}</strong>
        <Text span ml={10} fz={12.5} fw={600} c={last === null && active ? "ink.3" : health}>
          {healthText(webhook)}
        </Text>
      </Text>
      {webhook.description !== "" && <p>{webhook.description}</p>}
      <Text c="ink.3">{eventsText(webhook.event_types)}</Text>
      {last !== null && (
        <Text c="ink.3" data-testid="webhook-state">
          {translate("webhookCard.last", {
            eventType: last.event_type,
            created: dateTimeText(last.created),
            last: deliveryText(last),
          })}
        </Text>
      )}
      {until !== null && (
        <Text c="ink.3">
          {translate("webhookCard.alsoSignedWithTheOld", { until: dateTimeText(until) })}
        </Text>
      )}
    </Stack>
  );
}

/** Result of a test event. */
function TestResult({ webhook, delivery }: { webhook: string; delivery: string }) {
  const { data } = useQuery(queries.delivery(webhook, delivery));
  const attempt = data?.attempts.at(-1);
  const answer = attempt === undefined ? "" : answerText(attempt);
  const result = attempt === undefined ? "grey" : data?.state === "delivered" ? "green" : "red";
  return (
    <div className={css.callout} role="status" data-tone={result} data-testid="webhook-test-result">
      <strong>{translate("webhookCard.test", { data: deliveryText(data) })}</strong>
      {answer !== "" && <div>{answer}</div>}
    </div>
  );
}
