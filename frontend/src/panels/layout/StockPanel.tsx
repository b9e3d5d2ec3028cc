/** Sheets in stock: lay out on one of them, add the size of the sheet, keep its remnant. */

import { ActionIcon, Button, Collapse } from "@mantine/core";
import { IconTrash } from "@tabler/icons-react";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { type LayoutSheet, layoutService, type StockSheet } from "../../api/layouts";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { queryClient } from "../../state/queries";
import css from "./layout.module.css";
import type { Size } from "./remnant";

interface Props {
  readonly name: string;
  readonly sheet: LayoutSheet;
  readonly remnant: Size | null;
  readonly onChoose: (sheet: Pick<LayoutSheet, "width" | "height" | "grain">) => void;
  /** Executes an action and shows its error. */
  readonly attempt: (action: () => Promise<unknown>) => Promise<void>;
}

const KEY = ["stock"] as const;

/** The sheets in stock of a board; with an empty name, those for which no board is stated. */
export const useStock = (board: string) =>
  useQuery({
    queryKey: [...KEY, board],
    queryFn: ({ signal }) => layoutService.stock(board, signal),
  });

export const sizeText = ({ width, height }: Size): string =>
  translate("layoutEditor.size", { width: formatNumber(width), height: formatNumber(height) });

export function StockPanel({ name, sheet, remnant, onChoose, attempt }: Props) {
  const [open, setOpen] = useState(false);
  const { data: stock } = useStock(sheet.board);
  const change = (action: () => Promise<unknown>) =>
    attempt(async () => {
      await action();
      await queryClient.invalidateQueries({ queryKey: KEY });
    });
  const add = (size: Size, note: string) =>
    change(() =>
      layoutService.addToStock({
        ...{ width: size.width, height: size.height, board: sheet.board, grain: sheet.grain },
        ...{ count: 1, note },
      }),
    );
  return (
    <section className={css.stock} aria-label={translate("layoutEditor.stock")}>
      <button
        type="button"
        className={css.fill}
        aria-expanded={open}
        onClick={() => setOpen(!open)}
        data-testid="stock"
      >
        {translate("layoutEditor.stockCount", { count: stock?.length ?? 0 })}
      </button>
      <Collapse expanded={open}>
        <ul className={css.list}>
          {(stock ?? []).map((one) => (
            <Row
              key={one.id}
              one={one}
              onChoose={() =>
                onChoose({ width: one.width, height: one.height, grain: one.grain ?? null })
              }
              onRemove={() => change(() => layoutService.removeFromStock(one))}
            />
          ))}
        </ul>
        <Button
          size="compact-sm"
          variant="default"
          onClick={() => add(sheet, "")}
          data-testid="stock-add"
        >
          {translate("layoutEditor.addThisSize")}
        </Button>
      </Collapse>
      {remnant !== null && (
        <Button
          size="compact-sm"
          variant="default"
          onClick={() => add(remnant, translate("layoutEditor.remnantOf", { name }))}
          data-testid="keep-remnant"
        >
          {translate("layoutEditor.keepRemnant", { size: sizeText(remnant) })}
        </Button>
      )}
    </section>
  );
}

interface RowProps {
  readonly one: StockSheet;
  readonly onChoose: () => void;
  readonly onRemove: () => void;
}

function Row({ one, onChoose, onRemove }: RowProps) {
  return (
    <li className={css.entryHead} data-testid="stock-sheet">
      <button type="button" className={css.entryName} onClick={onChoose} title={one.note}>
        {sizeText(one)}
        {one.count !== null && one.count !== undefined && one.count > 1 && ` · ${one.count}`}
        {one.note !== "" && ` · ${one.note}`}
      </button>
      <ActionIcon
        variant="subtle"
        color="gray"
        aria-label={translate("layoutEditor.useUp", { size: sizeText(one) })}
        onClick={onRemove}
      >
        <IconTrash size={16} />
      </ActionIcon>
    </li>
  );
}
