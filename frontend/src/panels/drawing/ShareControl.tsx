/** Whether all designers may change the open drawing; its owner and operators decide. */

import { Checkbox } from "@mantine/core";
import type { Drawing } from "../../api/drawings";
import { translate } from "../../language/translate";
import { useMe, useRefusal } from "../../state/accounts/accounts";
import { shareDrawing } from "../../state/actions";
import { maySetShare } from "../../state/drawing/sharing";
import { Refusal } from "../accounts/Permitted";

export function ShareControl({ drawing }: { drawing: Drawing }) {
  const me = useMe();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  // A drawing without an owner is open to all designers.
  if (me === undefined || drawing.owner === "") return null;
  const reason =
    refusal ?? (maySetShare(me, drawing) ? null : translate("shareControl.itsOwnerOrAnOperator"));
  return (
    <>
      <Checkbox
        mt={10}
        size="xs"
        label={translate("shareControl.allDesignersMayChangeThis")}
        checked={drawing.shared}
        disabled={reason !== null}
        data-testid="share-drawing"
        onChange={(event) => void shareDrawing(event.currentTarget.checked)}
      />
      <Refusal reason={reason} />
    </>
  );
}
