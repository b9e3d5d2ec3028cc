/** Opens a new layout with a drawing on its sheet. */

import { Button } from "@mantine/core";
import { useState } from "react";
import { layoutService } from "../../api/layouts";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { showLayout } from "../../state/routes";
import { atOrigin, NEW_SHEET } from "./placing";

interface Props {
  readonly drawing: {
    readonly id: string;
    readonly name: string;
    readonly unit: string | null;
    readonly width: number;
    readonly height: number;
  };
}

/** Size of a new sheet (mm), unless the drawing is larger. */
const SHEET = { width: 1200, height: 800 };

export function LayOutButton({ drawing }: Props) {
  const [busy, setBusy] = useState(false);
  const [fault, setFault] = useState("");
  const layOut = async () => {
    setBusy(true);
    setFault("");
    try {
      const { id } = await layoutService.add(drawing.name, {
        sheet: {
          ...NEW_SHEET,
          width: Math.max(SHEET.width, Math.ceil(drawing.width) + 2 * NEW_SHEET.margin),
          height: Math.max(SHEET.height, Math.ceil(drawing.height) + 2 * NEW_SHEET.margin),
        },
        placed: [{ ...atOrigin(drawing.id), x: NEW_SHEET.margin, y: NEW_SHEET.margin }],
      });
      showLayout(id);
    } catch (reason) {
      setFault(reason instanceof Error ? errorText(reason) : String(reason));
    } finally {
      setBusy(false);
    }
  };
  return (
    <>
      <Button
        size="xs"
        mt={10}
        variant="default"
        fullWidth
        loading={busy}
        disabled={drawing.unit === null}
        onClick={layOut}
        data-testid="lay-out"
      >
        {translate("layoutEditor.layOut")}
      </Button>
      {fault !== "" && (
        <p role="alert" style={{ color: "var(--bad-ink)" }}>
          {fault}
        </p>
      )}
    </>
  );
}
