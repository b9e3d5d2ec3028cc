/** Head of the layout editor: name, board use, undo and redo, save, and the order of the sheet. */

import { ActionIcon, Button, Title } from "@mantine/core";
import { IconArrowBackUp, IconArrowForwardUp } from "@tabler/icons-react";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import css from "./layout.module.css";
import type { EditedDraft } from "./useDraft";

interface Props {
  readonly name: string;
  readonly edited: EditedDraft;
  /** Share of the sheet that the blanks use (%), and number of copies. */
  readonly use: number;
  readonly copies: number;
  readonly canOrder: boolean;
  readonly onSave: () => void;
  readonly onOrder: () => void;
}

export function LayoutHead({ name, edited, use, copies, canOrder, onSave, onOrder }: Props) {
  return (
    <header className={css.head}>
      <Title order={1} fz={16} className={css.title}>
        {name}
      </Title>
      <span data-testid="layout-use">
        {translate("layoutEditor.boardUse", {
          use: formatNumber(use, { maximumFractionDigits: 1 }),
          count: copies,
        })}
      </span>
      <ActionIcon
        variant="default"
        size="lg"
        disabled={!edited.canUndo}
        aria-label={translate("layoutEditor.undo")}
        onClick={edited.undo}
        data-testid="layout-undo"
      >
        <IconArrowBackUp size={18} />
      </ActionIcon>
      <ActionIcon
        variant="default"
        size="lg"
        disabled={!edited.canRedo}
        aria-label={translate("layoutEditor.redo")}
        onClick={edited.redo}
        data-testid="layout-redo"
      >
        <IconArrowForwardUp size={18} />
      </ActionIcon>
      <Button
        variant="default"
        disabled={!edited.unsaved || copies === 0}
        onClick={onSave}
        data-testid="layout-save"
      >
        {translate("layoutEditor.save")}
      </Button>
      <Button disabled={!canOrder} onClick={onOrder} data-testid="layout-order">
        {translate("layoutEditor.orderThisSheet")}
      </Button>
    </header>
  );
}
