/** Line-type buttons for the selected edges. */

import { ActionIcon, CloseButton, Tooltip } from "@mantine/core";
import { IconArrowBackUp } from "@tabler/icons-react";
import { lineTypeOf } from "../../geometry/records";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { retype } from "../../state/actions";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../../state/drawing/palette";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { USE_PROFILE_TYPE } from "../shared/labels";
import { Swatch } from "../shared/Swatch";
import css from "./overlay.module.css";

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
      aria-label={translate("selectionBar.setTheLineTypeOf")}
      data-testid="selection"
    >
      <span
        className={css.selectionText}
      >{`${translate("selectionBar.edgesSelected", { rows: rows.length })} · ${formatLength(total)}`}</span>
      {ASSIGNABLE_TYPES.map((type) => {
        const { title, key } = LINE_STYLES[type];
        return (
          <Tooltip
            key={type}
            label={translate("selectionBar.setTheLineTypeTo", {
              title: insideSentence(title),
              key,
            })}
          >
            <button
              type="button"
              className={css.chip}
              aria-label={translate("selectionBar.setTheLineTypeTo2", {
                title: insideSentence(title),
              })}
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
      <Tooltip label={translate("selectionBar.key0", { useprofiletype: USE_PROFILE_TYPE })}>
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
        aria-label={translate("selectionBar.clearTheSelectionOfEdges")}
        onClick={() => selectEdges([])}
      />
    </div>
  );
}
