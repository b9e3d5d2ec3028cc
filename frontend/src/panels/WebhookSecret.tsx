/** The secret of a webhook, shown once, and the dialog that replaces it. */

import { Button, Code, CopyButton, Modal, Select } from "@mantine/core";
import { useState } from "react";
import type { NewWebhook } from "../api/webhooks";
import { dateTimeText } from "../state/times";
import css from "./webhooks.module.css";

export function WebhookSecret({ webhook, onClose }: { webhook: NewWebhook; onClose: () => void }) {
  const until = webhook.previous_secret_until;
  return (
    <section className={css.secret} aria-label="Secret of the webhook">
      <p>
        <strong>Copy the secret now. It cannot be shown again.</strong>{" "}
        {until !== null && `Requests are signed with both secrets until ${dateTimeText(until)}.`}
      </p>
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

/** Choices for the time (h) in which requests are also signed with the old secret. */
const OVERLAPS = [
  { value: "24", label: "24 hours" },
  { value: "1", label: "1 hour" },
  { value: "168", label: "7 days" },
  { value: "0", label: "0 hours (the old secret was disclosed)" },
];

interface RotationProps {
  readonly opened: boolean;
  readonly onClose: () => void;
  /** `overlap`: time in which both secrets sign (h). */
  readonly onRotate: (overlap: number) => void;
}

export function RotationDialog({ opened, onClose, onRotate }: RotationProps) {
  const [overlap, setOverlap] = useState("24");
  return (
    <Modal opened={opened} onClose={onClose} title="Replace the secret?" centered>
      <div className={css.dialog}>
        <p>
          For the chosen time, requests are signed with both secrets, so that the receiver accepts
          them before and after you enter the new secret there. Older secrets become invalid now.
        </p>
        <Select
          label="Also sign with the old secret for"
          data={OVERLAPS}
          value={overlap}
          allowDeselect={false}
          onChange={(value) => setOverlap(value ?? "24")}
        />
        <div className={css.actions} data-end>
          <Button variant="default" onClick={onClose}>
            Cancel
          </Button>
          <Button onClick={() => onRotate(Number(overlap))} data-testid="webhook-rotate-yes">
            Replace the secret
          </Button>
        </div>
      </div>
    </Modal>
  );
}
