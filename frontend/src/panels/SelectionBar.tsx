/** What can be done with the chosen edges. */

import { ActionIcon, CloseButton, Tooltip } from "@mantine/core";
import { IconArrowBackUp } from "@tabler/icons-react";
import { lineTypeOf } from "../geometry/records";
import { retype } from "../state/actions";
import { useLength } from "../state/measure";
import { CHOICES, LINE_LOOKS } from "../state/palette";
import { useEdges } from "../state/queries";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./over.module.css";
import { Swatch } from "./Swatch";

export function SelectionBar() {
  const selection = usePage((page) => page.selection);
  const choose = usePage((page) => page.choose);
  const busy = usePage((page) => page.busy);
  const { data: edges } = useEdges();
  const length = useLength();
  if (selection.size === 0 || edges === undefined) return null;
  const rows = [...selection];
  const run = rows.reduce((sum, row) => sum + (edges.length[row] ?? 0), 0);
  const types = new Set(rows.map((row) => lineTypeOf(edges.lineType[row])));
  return (
    <div
      className={`${css.float} ${css.selection}`}
      role="toolbar"
      aria-label="Line type of the chosen edges"
      data-testid="selection"
    >
      <span className={css.selectionText}>
        {count(rows.length, "edge")} · {length(run)}
      </span>
      {CHOICES.map((type) => {
        const { title, key } = LINE_LOOKS[type];
        return (
          <Tooltip key={type} label={`${title} (${key})`}>
            <button
              type="button"
              className={css.chip}
              aria-label={`Make ${title.toLowerCase()}`}
              aria-pressed={types.size === 1 && types.has(type)}
              disabled={busy}
              data-testid={`type-${type}`}
              onClick={() => void retype(rows, type)}
            >
              <Swatch type={type} />
              <span className={css.chipWord}>{title}</span>
            </button>
          </Tooltip>
        );
      })}
      <Tooltip label="As the profile says (0)">
        <ActionIcon
          variant="subtle"
          color="gray"
          disabled={busy}
          aria-label="As the profile says"
          data-testid="type-none"
          onClick={() => void retype(rows, null)}
        >
          <IconArrowBackUp size={16} />
        </ActionIcon>
      </Tooltip>
      <CloseButton size="sm" aria-label="Choose nothing" onClick={() => choose([])} />
    </div>
  );
}
