/** Line-type buttons for the selected edges. */

import { ActionIcon, CloseButton, Tooltip } from "@mantine/core";
import { IconArrowBackUp } from "@tabler/icons-react";
import { lineTypeOf } from "../geometry/records";
import { useRefusal } from "../state/accounts";
import { retype } from "../state/actions";
import { pluralize } from "../state/format";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../state/palette";
import { useEdges } from "../state/queries";
import { useUiStore } from "../state/store";
import { useFormatLength } from "../state/useFormatLength";
import { USE_PROFILE_TYPE } from "./labels";
import css from "./overlay.module.css";
import { Swatch } from "./Swatch";

export function SelectionBar() {
  const selection = useUiStore((ui) => ui.selection);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const { data: edges } = useEdges();
  const formatLength = useFormatLength();
  if (selection.size === 0 || edges === undefined) return null;
  const rows = [...selection];
  const total = rows.reduce((sum, row) => sum + (edges.length[row] ?? 0), 0);
  const types = new Set(rows.map((row) => lineTypeOf(edges.lineType[row])));
  return (
    <div
      className={`${css.float} ${css.selection}`}
      role="toolbar"
      aria-label="Set the line type of the selected edges"
      data-testid="selection"
    >
      <span className={css.selectionText}>
        {pluralize(rows.length, "edge")} selected · {formatLength(total)}
      </span>
      {ASSIGNABLE_TYPES.map((type) => {
        const { title, key } = LINE_STYLES[type];
        return (
          <Tooltip key={type} label={`Set the line type to ${title.toLowerCase()} (key ${key})`}>
            <button
              type="button"
              className={css.chip}
              aria-label={`Set the line type to ${title.toLowerCase()}`}
              aria-pressed={types.size === 1 && types.has(type)}
              disabled={busy || refusal !== null}
              title={refusal ?? undefined}
              data-testid={`type-${type}`}
              onClick={() => void retype(rows, type)}
            >
              <Swatch type={type} />
              <span className={css.chipWord}>{title}</span>
            </button>
          </Tooltip>
        );
      })}
      <Tooltip label={`${USE_PROFILE_TYPE} (key 0)`}>
        <ActionIcon
          variant="subtle"
          color="gray"
          disabled={busy || refusal !== null}
          aria-label={USE_PROFILE_TYPE}
          data-testid="type-none"
          onClick={() => void retype(rows, null)}
        >
          <IconArrowBackUp size={16} />
        </ActionIcon>
      </Tooltip>
      <CloseButton
        size="sm"
        aria-label="Clear the selection of edges"
        onClick={() => selectEdges([])}
      />
    </div>
  );
}
