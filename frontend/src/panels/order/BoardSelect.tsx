/** The board of the next job of a drawing, which is never taken over from another drawing. */

import { Button, Select } from "@mantine/core";
import type { Drawing } from "../../api/drawings";
import { translate } from "../../language/translate";
import { useBoards, useBoardTitle, useLastJob } from "../../state/queries";
import { useUiStore } from "../../state/store";

export function BoardSelect({ drawing }: { drawing: Drawing }) {
  const { data: boards } = useBoards();
  const board = useUiStore((ui) => ui.board);
  const job = useUiStore((ui) => ui.job);
  const set = useUiStore((ui) => ui.set);
  const { data: last } = useLastJob({ drawing: drawing.id }, job === null);

  return (
    <div style={{ display: "grid", gap: 4 }}>
      <Select
        label={translate("boardSelect.board")}
        description={
          job === null && board !== null && board === last?.board
            ? translate("boardSelect.asInTheLastJob")
            : undefined
        }
        placeholder={translate("boardSelect.chooseTheBoard")}
        data={(boards ?? []).map(({ name, title }) => ({ value: name, label: title || name }))}
        value={board}
        allowDeselect={false}
        onChange={(value) => set({ board: value })}
        data-testid="board-select"
      />
      {board === null && <UsualBoard drawing={drawing} />}
    </div>
  );
}

/** Offers the board of the last job of the same customer on the same machine. */
function UsualBoard({ drawing }: { drawing: Drawing }) {
  const machine = useUiStore((ui) => ui.machine);
  const typed = useUiStore((ui) => ui.details.customer);
  const set = useUiStore((ui) => ui.set);
  const { data: boards } = useBoards();
  const customer = typed || drawing.customer;
  const { data: last } = useLastJob(
    { customer, machine: machine ?? "" },
    customer !== "" && machine !== null,
  );
  const title = useBoardTitle(last?.board ?? "");
  if (last == null || boards?.some(({ name }) => name === last.board) !== true) return null;
  return (
    <Button
      variant="default"
      size="compact-xs"
      style={{ justifySelf: "start", maxWidth: "100%" }}
      onClick={() => set({ board: last.board })}
      data-testid="usual-board"
    >
      {translate("boardSelect.asLastTimeFor", { customer, title })}
    </Button>
  );
}
