/** Adds a drawing of the server to the sheet. */

import { Select } from "@mantine/core";
import { translate } from "../../language/translate";
import { useOrders } from "../../state/queries";

const NEWEST = { sort: "newest" } as const;

export function AddDrawing({ onAdd }: { readonly onAdd: (drawing: string) => void }) {
  const { data: rows } = useOrders(NEWEST);
  return (
    <Select
      label={translate("layoutEditor.addADrawing")}
      size="xs"
      searchable
      data={(rows ?? [])
        .filter(({ drawing }) => drawing.unit !== null && !drawing.is_layout)
        .map(({ drawing }) => ({ value: drawing.id, label: drawing.name }))}
      value={null}
      onChange={(id) => id !== null && onAdd(id)}
      data-testid="layout-add"
    />
  );
}
