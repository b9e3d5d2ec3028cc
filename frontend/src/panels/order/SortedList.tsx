/** A list whose rows are dragged with the mouse or a finger, or moved with keys and buttons. */

import { ActionIcon } from "@mantine/core";
import { IconArrowDown, IconArrowUp } from "@tabler/icons-react";
import type { ReactNode } from "react";
import { translate } from "../../language/translate";
import { Grip, SortableRows, useSortableRow } from "../shared/Sortable";
import css from "./workOrder.module.css";

export interface SortedRow {
  readonly id: number;
  /** For screen readers. */
  readonly name: string;
  /** Beside the handle. */
  readonly content: ReactNode;
  /** Under the row, such as a list of what it consists of; moved with it. */
  readonly below?: ReactNode;
}

interface Props {
  rows: readonly SortedRow[];
  /** Called with two different places; it may leave the rows as they are. */
  onMove(from: number, to: number): void;
  /** What a row is, in test ids. */
  kind: "track" | "layer" | "part";
  testId: string;
}

export function SortedList({ rows, onMove, kind, testId }: Props) {
  const ids = rows.map(({ id }) => id);
  const move = (from: number, to: number) => {
    if (from >= 0 && to >= 0 && to < rows.length && from !== to) onMove(from, to);
  };
  return (
    <SortableRows
      ids={ids}
      howTo={translate("workOrder.howToMove")}
      nameOf={(id) => rows[ids.indexOf(id)]?.name ?? ""}
      onMove={move}
    >
      <ol className={css.list} data-kind={kind} data-testid={testId}>
        {rows.map((row, place) => (
          <Row
            key={row.id}
            row={row}
            place={place}
            last={place === rows.length - 1}
            kind={kind}
            move={move}
          />
        ))}
      </ol>
    </SortableRows>
  );
}

interface RowProps {
  row: SortedRow;
  place: number;
  last: boolean;
  kind: Props["kind"];
  move: (from: number, to: number) => void;
}

function Row({ row: { id, name, content, below }, place, last, kind, move }: RowProps) {
  const { row: moved, grip } = useSortableRow({ id });
  return (
    <li {...moved} className={css.item} data-id={id}>
      <div className={css.row}>
        <Grip
          grip={grip}
          label={translate("workOrder.drag", { name, place: place + 1 })}
          testId={`drag-${kind}`}
        />
        {content}
        <ActionIcon
          variant="subtle"
          color="gray"
          size={28}
          disabled={place === 0}
          aria-label={translate("workOrder.moveUp", { name })}
          onClick={() => move(place, place - 1)}
          data-testid={`${kind}-up`}
        >
          <IconArrowUp size={15} aria-hidden />
        </ActionIcon>
        <ActionIcon
          variant="subtle"
          color="gray"
          size={28}
          disabled={last}
          aria-label={translate("workOrder.moveDown", { name })}
          onClick={() => move(place, place + 1)}
          data-testid={`${kind}-down`}
        >
          <IconArrowDown size={15} aria-hidden />
        </ActionIcon>
      </div>
      {below}
    </li>
  );
}
