/** The page of webhooks: endpoints of other systems, with the newest delivery to each. */

import { Button, Code, CopyButton, TextInput } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type NewWebhook, service, type Webhook } from "../api/client";
import { errorText } from "../messages/render";
import { ConfirmDialog } from "../panels/ConfirmDialog";
import css from "../panels/webhooks.module.css";
import { queries, queryClient } from "../state/queries";

const refresh = () => queryClient.invalidateQueries({ queryKey: queries.webhooks().queryKey });

export function WebhooksPage() {
  const { data: webhooks, error } = useQuery(queries.webhooks());
  const [fault, setFault] = useState("");
  const [added, setAdded] = useState<NewWebhook | null>(null);
  const act = async (action: () => Promise<unknown>) => {
    setFault("");
    try {
      await action();
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    }
    await refresh();
  };
  const shown = fault || (error === null ? "" : errorText(error));
  return (
    <main className={css.page} data-testid="webhooks">
      <header className={css.head}>
        <h1>Webhooks</h1>
        <Button component="a" href="#/" variant="default">
          Back to drawings
        </Button>
      </header>
      <p>Changes of jobs and drawings are sent to these URLs, signed as Standard Webhooks.</p>
      {shown !== "" && (
        <p className={css.fault} role="alert">
          {shown}
        </p>
      )}
      <AddForm
        onAdd={(url, description) =>
          act(async () => setAdded(await service.addWebhook(url, description)))
        }
      />
      {added !== null && <Secret webhook={added} onClose={() => setAdded(null)} />}
      {webhooks?.length === 0 && <p>There are no webhooks.</p>}
      <ul className={css.list}>
        {(webhooks ?? []).map((webhook) => (
          <Row key={webhook.id} webhook={webhook} act={act} />
        ))}
      </ul>
    </main>
  );
}

function AddForm({ onAdd }: { onAdd: (url: string, description: string) => Promise<void> }) {
  const [url, setUrl] = useState("");
  const [description, setDescription] = useState("");
  return (
    <form
      className={css.form}
      onSubmit={(event) => {
        event.preventDefault();
        void onAdd(url, description);
      }}
    >
      <TextInput
        label="URL"
        placeholder="https://erp.example/hooks"
        value={url}
        onChange={(event) => setUrl(event.currentTarget.value)}
        maxLength={2000}
        required
        data-testid="webhook-url"
      />
      <TextInput
        label="Description"
        value={description}
        onChange={(event) => setDescription(event.currentTarget.value)}
        maxLength={200}
      />
      <Button type="submit" data-testid="webhook-add">
        Add
      </Button>
    </form>
  );
}

function Secret({ webhook, onClose }: { webhook: NewWebhook; onClose: () => void }) {
  return (
    <section className={css.secret} aria-label="Secret of the new webhook">
      <p>Copy the secret for {webhook.url} now: it is not shown again.</p>
      <Code data-testid="webhook-secret">{webhook.secret}</Code>
      <div className={css.actions}>
        <CopyButton value={webhook.secret}>
          {({ copied, copy }) => (
            <Button size="sm" onClick={copy}>
              {copied ? "Copied" : "Copy"}
            </Button>
          )}
        </CopyButton>
        <Button size="sm" variant="default" onClick={onClose}>
          Done
        </Button>
      </div>
    </section>
  );
}

interface RowProps {
  readonly webhook: Webhook;
  readonly act: (action: () => Promise<unknown>) => Promise<void>;
}

function Row({ webhook, act }: RowProps) {
  const [deleting, setDeleting] = useState(false);
  const { id, active } = webhook;
  return (
    <li className={css.row} data-testid="webhook-row">
      <div className={css.texts}>
        <strong>{webhook.url}</strong>
        {webhook.description !== "" && <span>{webhook.description}</span>}
        <span data-testid="webhook-state">{stateText(webhook)}</span>
      </div>
      <div className={css.actions}>
        <Button
          size="sm"
          variant="default"
          disabled={!active}
          onClick={() => void act(() => service.testWebhook(id))}
          data-testid="webhook-test"
        >
          Test
        </Button>
        <Button
          size="sm"
          variant="default"
          disabled={!active}
          onClick={() => void act(() => service.replayWebhook(id))}
        >
          Replay failed
        </Button>
        <Button
          size="sm"
          variant="default"
          onClick={() => void act(() => service.switchWebhook(id, !active))}
        >
          {active ? "Switch off" : "Switch on"}
        </Button>
        <Button size="sm" color="red" variant="light" onClick={() => setDeleting(true)}>
          Delete
        </Button>
      </div>
      <ConfirmDialog
        confirmation={
          deleting
            ? {
                title: "Delete the webhook?",
                text: `Nothing is sent to ${webhook.url} any more.`,
                yes: "Delete",
                no: "Keep",
              }
            : null
        }
        onYes={() => {
          setDeleting(false);
          void act(() => service.deleteWebhook(id));
        }}
        onNo={() => setDeleting(false)}
      />
    </li>
  );
}

function stateText({ active, last_delivery: last }: Webhook): string {
  const off = active ? "" : "Switched off. ";
  if (last === null) return `${off}Nothing was sent yet.`;
  const attempt = last.attempts.at(-1);
  const when = new Date(attempt?.at ?? last.created).toLocaleString();
  if (last.state === "delivered") return `${off}${last.event_type} delivered, ${when}`;
  const answer = attempt === undefined ? "" : `: ${attempt.fault || `status ${attempt.status}`}`;
  const state = last.state === "dead" ? "not delivered" : "being sent";
  return `${off}${last.event_type} ${state}, ${when}${answer}`;
}
