/** Edges whose line type would change, grouped by old and new type. */

import { IconArrowRight } from "@tabler/icons-react";
import type { Retyped } from "../api/client";
import { pluralize } from "../state/format";
import { LINE_STYLES } from "../state/palette";
import { useUiStore } from "../state/store";
import { SHOW_EDGES } from "./labels";
import css from "./learned.module.css";
import { Swatch } from "./Swatch";

export const previewsOfChanges = (changes: readonly Retyped[]) =>
  changes.map(({ edges, after }) => ({ rows: edges, type: after }));

export function TypeChanges({ changes }: { changes: readonly Retyped[] }) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <ul className={css.changes} data-testid="changes">
      {changes.map(({ before, after, edges }) => (
        <li key={`${before} ${after}`}>
          <button
            type="button"
            className={css.change}
            title={SHOW_EDGES}
            onClick={() => zoomToEdges(edges)}
          >
            {pluralize(edges.length, "edge")}
            <Swatch type={before} />
            {LINE_STYLES[before].title}
            <IconArrowRight size={13} aria-label="becomes" />
            <Swatch type={after} />
            {LINE_STYLES[after].title}
          </button>
        </li>
      ))}
    </ul>
  );
}
