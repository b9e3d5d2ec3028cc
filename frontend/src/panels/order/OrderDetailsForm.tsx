/** Fields for the details of a new order; they are stored with the job and change no program. */

import { Stack, Text, Textarea, TextInput } from "@mantine/core";
import { translate } from "../../language/translate";
import { hasDetails } from "../../state/order/orderDetails";
import { useUiStore } from "../../state/store";
import { fromLocalInput, localInput } from "../../state/times";

export function OrderDetailsForm() {
  const details = useUiStore((ui) => ui.details);
  const set = useUiStore((ui) => ui.set);
  const change = (part: Partial<typeof details>) => set({ details: { ...details, ...part } });
  return (
    <details data-testid="order-details">
      <Text component="summary" mih={32} fw={600}>
        {hasDetails(details) && details.external_id !== ""
          ? translate("orderDetailsForm.orderDetails", { externalId: details.external_id })
          : translate("orderDetailsForm.orderDetails2")}
      </Text>
      <Stack gap={8}>
        <TextInput
          label={translate("orderDetailsForm.orderNumber")}
          maxLength={200}
          value={details.external_id}
          onChange={({ currentTarget }) => change({ external_id: currentTarget.value })}
          data-testid="order-number"
        />
        <TextInput
          label={translate("orderDetailsForm.customer")}
          maxLength={200}
          value={details.customer}
          onChange={({ currentTarget }) => change({ customer: currentTarget.value })}
          data-testid="order-customer"
        />
        <TextInput
          type="datetime-local"
          label={translate("orderDetailsForm.due")}
          value={localInput(details.due ?? null)}
          onChange={({ currentTarget }) => change({ due: fromLocalInput(currentTarget.value) })}
          data-testid="order-due"
        />
        <Textarea
          label={translate("orderDetailsForm.notes")}
          maxLength={2000}
          autosize
          minRows={2}
          maxRows={6}
          value={details.notes}
          onChange={({ currentTarget }) => change({ notes: currentTarget.value })}
          data-testid="order-notes"
        />
      </Stack>
    </details>
  );
}
