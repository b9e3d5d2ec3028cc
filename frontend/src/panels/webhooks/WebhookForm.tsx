/** URL, description and events of a webhook: a new one, or one that is changed. */

import { Button, Group, MultiSelect, Stack, TextInput } from "@mantine/core";
import { useState } from "react";
import type { WebhookEvent, WebhookFields } from "../../api/webhooks";
import { translate } from "../../language/translate";
import { EVENT_LABELS } from "../../state/webhooks/webhooks";

interface Props {
  readonly fields: WebhookFields;
  readonly label: string;
  /** Returns whether the server has accepted the fields. */
  readonly onSend: (fields: WebhookFields) => Promise<boolean>;
  readonly onCancel?: () => void;
}

const EVENTS = Object.entries(EVENT_LABELS).map(([value, label]) => ({ value, label }));

export function WebhookForm({ fields, label, onSend, onCancel }: Props) {
  const [draft, setDraft] = useState(fields);
  const [busy, setBusy] = useState(false);
  const change = (part: Partial<WebhookFields>) => setDraft({ ...draft, ...part });
  const send = async () => {
    setBusy(true);
    const accepted = await onSend(draft);
    setBusy(false);
    if (accepted) setDraft(fields);
  };
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void send();
      }}
    >
      <Stack gap={12}>
        <TextInput
          label={translate("webhookForm.url")}
          placeholder="https://erp.example/hooks"
          value={draft.url}
          onChange={(event) => change({ url: event.currentTarget.value })}
          maxLength={2000}
          required
          inputMode="url"
          autoComplete="off"
          data-testid="webhook-url"
        />
        <TextInput
          label={translate("webhookForm.description")}
          placeholder={translate("webhookForm.systemThatReceivesTheEvents")}
          value={draft.description}
          onChange={(event) => change({ description: event.currentTarget.value })}
          maxLength={200}
          data-testid="webhook-description"
        />
        <MultiSelect
          label={translate("webhookForm.events")}
          placeholder={draft.event_types.length === 0 ? translate("webhookForm.allEvents") : ""}
          data={EVENTS}
          value={draft.event_types}
          onChange={(types) => change({ event_types: types as WebhookEvent[] })}
          clearable
          searchable
          data-testid="webhook-events"
        />
        <Group gap={8}>
          <Button type="submit" loading={busy} data-testid="webhook-save">
            {label}
          </Button>
          {onCancel !== undefined && (
            <Button variant="default" onClick={onCancel}>
              {translate("webhookForm.cancel")}
            </Button>
          )}
        </Group>
      </Stack>
    </form>
  );
}
