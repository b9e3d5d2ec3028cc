/** The secret of a webhook, shown once, and the dialog that replaces it. */

import { Button, Code, CopyButton, Flex, Group, Modal, Select, Stack } from "@mantine/core";
import { useState } from "react";
import type { NewWebhook } from "../../api/webhooks";
import { translate } from "../../language/translate";
import { dateTimeText } from "../../state/times";
import css from "../shared/panels.module.css";

export function WebhookSecret({ webhook, onClose }: { webhook: NewWebhook; onClose: () => void }) {
  const until = webhook.previous_secret_until;
  return (
    <Flex
      component="section"
      direction="column"
      align="flex-start"
      gap={12}
      mb={12}
      className={css.callout}
      data-tone="amber"
      aria-label={translate("webhookSecret.secretOfTheWebhook")}
    >
      <p>
        <strong>{translate("webhookSecret.copyTheSecretNowIt")}</strong>{" "}
        {until !== null &&
          translate("webhookSecret.requestsAreSignedWithBoth", { until: dateTimeText(until) })}
      </p>
      <Code data-testid="webhook-secret">{webhook.secret}</Code>
      <Group gap={8}>
        <CopyButton value={webhook.secret}>
          {({ copied, copy }) => (
            <Button size="sm" onClick={copy}>
              {copied ? translate("webhookSecret.copied") : translate("webhookSecret.copy")}
            </Button>
          )}
        </CopyButton>
        <Button size="sm" variant="default" onClick={onClose}>
          {translate("webhookSecret.done")}
        </Button>
      </Group>
    </Flex>
  );
}

/** Choices for the time (h) in which requests are also signed with the old secret. */
const OVERLAPS = [
  { value: "24", label: translate("webhookSecret.n24Hours") },
  { value: "1", label: translate("webhookSecret.n1Hour") },
  { value: "168", label: translate("webhookSecret.n7Days") },
  { value: "0", label: translate("webhookSecret.n0HoursTheOldSecret") },
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
    <Modal
      opened={opened}
      onClose={onClose}
      title={translate("webhookSecret.replaceTheSecret")}
      centered
    >
      <Stack gap={16}>
        <p>{translate("webhookSecret.forTheChosenTimeRequests")}</p>
        <Select
          label={translate("webhookSecret.alsoSignWithTheOld")}
          data={OVERLAPS}
          value={overlap}
          allowDeselect={false}
          onChange={(value) => setOverlap(value ?? "24")}
        />
        <Group gap={8} justify="flex-end">
          <Button variant="default" onClick={onClose}>
            {translate("webhookSecret.cancel")}
          </Button>
          <Button onClick={() => onRotate(Number(overlap))} data-testid="webhook-rotate-yes">
            {translate("webhookSecret.replaceTheSecret2")}
          </Button>
        </Group>
      </Stack>
    </Modal>
  );
}
