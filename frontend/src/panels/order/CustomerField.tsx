/** The customer of the open drawing, whose earlier drawings answer questions. */

import { TextInput } from "@mantine/core";
import { useEffect, useState } from "react";
import type { Drawing } from "../../api/drawings";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { setCustomer } from "../../state/actions";
import { useUiStore } from "../../state/store";

export function CustomerField({ drawing }: { drawing: Drawing }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  const [typed, setTyped] = useState(drawing.customer);
  useEffect(() => setTyped(drawing.customer), [drawing.customer]);
  const save = () => {
    const customer = typed.trim();
    if (customer !== drawing.customer) void setCustomer(customer);
  };
  return (
    <form
      style={{ marginTop: 12 }}
      onSubmit={(event) => {
        event.preventDefault();
        save();
      }}
    >
      <TextInput
        size="xs"
        label={translate("customerField.customer")}
        placeholder={translate("customerField.answersAreRememberedForEach")}
        maxLength={200}
        value={typed}
        disabled={busy || refusal !== null}
        title={refusal ?? undefined}
        data-testid="drawing-customer"
        onChange={(event) => setTyped(event.currentTarget.value)}
        onBlur={save}
      />
    </form>
  );
}
