/** Asks for confirmation before a command that cannot be undone. */

import { Button } from "@mantine/core";
import type { Confirmation } from "../../state/job/jobs";
import { Dialog } from "./Dialog";

interface Props {
  /** null: the dialog is closed. */
  readonly confirmation: Confirmation | null;
  readonly onYes: () => void;
  readonly onNo: () => void;
}

export function ConfirmDialog({ confirmation, onYes, onNo }: Props) {
  return (
    <Dialog opened={confirmation !== null} onClose={onNo} title={confirmation?.title} centered>
      <p style={{ margin: "0 0 16px" }} data-testid="confirm-text">
        {confirmation?.text}
      </p>
      <div style={{ display: "flex", gap: 8, justifyContent: "flex-end" }}>
        <Button variant="default" onClick={onNo} data-autofocus data-testid="confirm-no">
          {confirmation?.no}
        </Button>
        <Button color="red" onClick={onYes} data-testid="confirm-yes">
          {confirmation?.yes}
        </Button>
      </div>
    </Dialog>
  );
}
