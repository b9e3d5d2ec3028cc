/** Whether all designers may change the open drawing; its owner and operators decide. */

import { Checkbox } from "@mantine/core";
import type { Drawing } from "../api/client";
import { useMe, useRefusal } from "../state/accounts";
import { shareDrawing } from "../state/actions";
import { maySetShare } from "../state/sharing";
import { Refusal } from "./Permitted";

export function ShareControl({ drawing }: { drawing: Drawing }) {
  const me = useMe();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  // A drawing without an owner is open to all designers.
  if (me === undefined || drawing.owner === "") return null;
  const reason =
    refusal ?? (maySetShare(me, drawing) ? null : "Its owner or an operator can share it.");
  return (
    <>
      <Checkbox
        mt={10}
        size="xs"
        label="All designers may change this drawing"
        checked={drawing.shared}
        disabled={reason !== null}
        data-testid="share-drawing"
        onChange={(event) => void shareDrawing(event.currentTarget.checked)}
      />
      <Refusal reason={reason} />
    </>
  );
}
