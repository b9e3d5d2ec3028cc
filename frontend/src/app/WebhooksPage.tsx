/** The page of webhooks: endpoints of other systems, and the deliveries to them. */

import "../messages/load";
import { Button, Paper, Text, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type NewWebhook, webhookService } from "../api/webhooks";
import { translate } from "../language/translate";
import { errorText } from "../messages/translateMessage";
import { Refusal } from "../panels/accounts/Permitted";
import css from "../panels/shared/panels.module.css";
import { WebhookCard } from "../panels/webhooks/WebhookCard";
import { WebhookForm } from "../panels/webhooks/WebhookForm";
import { WebhookSecret } from "../panels/webhooks/WebhookSecret";
import { useIsPermitted, useRefusal } from "../state/accounts/accounts";
import { queries } from "../state/queries";
import { refreshWebhooks } from "../state/webhooks/webhooks";

const EMPTY = { url: "", description: "", event_types: [] };

export function WebhooksPage() {
  const refusal = useRefusal("GET /api/v1/webhooks");
  const enabled = useIsPermitted("GET /api/v1/webhooks");
  const { data: webhooks, error } = useQuery({ ...queries.webhooks(), enabled });
  const [fault, setFault] = useState("");
  const [adding, setAdding] = useState(false);
  const [added, setAdded] = useState<NewWebhook | null>(null);
  const act = async (action: () => Promise<unknown>) => {
    setFault("");
    try {
      await action();
      return true;
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
      return false;
    } finally {
      await refreshWebhooks();
    }
  };
  const shown = fault || (error === null ? "" : errorText(error));
  const none = webhooks?.length === 0;
  return (
    <main className={css.page} data-touch data-testid="webhooks">
      <header className={css.head}>
        <Title order={1} fz={22}>
          {translate("webhooksPage.webhooks")}
        </Title>
        {!none && !adding && (
          <Button
            disabled={refusal !== null}
            title={refusal ?? undefined}
            onClick={() => setAdding(true)}
            data-testid="webhook-new"
          >
            {translate("webhooksPage.addAWebhook")}
          </Button>
        )}
        <Button component="a" href="#/settings" variant="default" data-testid="to-settings">
          {translate("settingsPage.settings")}
        </Button>
      </header>
      <Text mb={16} c="ink.2">
        {none
          ? translate("webhooksPage.changesOfJobsAndDrawings")
          : translate("webhooksPage.changesOfJobsAndDrawings2")}
      </Text>
      <Refusal reason={refusal} />
      {shown !== "" && (
        <Text mb={12} c="var(--bad-ink)" role="alert">
          {shown}
        </Text>
      )}
      {added !== null && <WebhookSecret webhook={added} onClose={() => setAdded(null)} />}
      {(none || adding) && (
        <Paper
          component="section"
          radius={12}
          p={16}
          mb={12}
          aria-label={translate("webhooksPage.newWebhook")}
        >
          <WebhookForm
            fields={EMPTY}
            label={translate("webhooksPage.add")}
            onSend={async (fields) => {
              const done = await act(async () => setAdded(await webhookService.add(fields)));
              if (done) setAdding(false);
              return done;
            }}
            {...(none ? {} : { onCancel: () => setAdding(false) })}
          />
        </Paper>
      )}
      <ul>
        {(webhooks ?? []).map((webhook) => (
          <WebhookCard key={webhook.id} webhook={webhook} act={act} />
        ))}
      </ul>
    </main>
  );
}
