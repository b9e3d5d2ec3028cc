/** A question with two answers, before something that cannot be taken back. */

import { Button, Modal } from "@mantine/core";
import type { Ask } from "../state/jobs";

interface Props {
  /** What is asked; null while nothing is. */
  readonly ask: Ask | null;
  readonly onYes: () => void;
  readonly onNo: () => void;
}

export function AskDialog({ ask, onYes, onNo }: Props) {
  return (
    <Modal opened={ask !== null} onClose={onNo} title={ask?.title} centered>
      <p style={{ margin: "0 0 16px" }} data-testid="ask">
        {ask?.text}
      </p>
      <div style={{ display: "flex", gap: 8, justifyContent: "flex-end" }}>
        <Button variant="default" onClick={onNo} data-autofocus data-testid="ask-no">
          Back
        </Button>
        <Button color="red" onClick={onYes} data-testid="ask-yes">
          {ask?.yes}
        </Button>
      </div>
    </Modal>
  );
}
