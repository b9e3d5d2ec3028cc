/** Edges whose line type would change, grouped by old and new type. */

import { Box } from "@mantine/core";
import { IconArrowRight } from "@tabler/icons-react";
import type { Retyped } from "../../api/drawings";
import { translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import { useUiStore } from "../../state/store";
import { SHOW_EDGES } from "../shared/labels";
import css from "../shared/panels.module.css";
import { Swatch } from "../shared/Swatch";

export const previewsOfChanges = (changes: readonly Retyped[]) =>
  changes.map(({ edges, after }) => ({ rows: edges, type: after }));

export function TypeChanges({ changes }: { changes: readonly Retyped[] }) {
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <Box component="ul" mt={8} mb={10} fz={12} c="ink.2" data-testid="changes">
      {changes.map(({ before, after, edges }) => (
        <li key={`${before} ${after}`}>
          <button
            type="button"
            className={css.pick}
            title={SHOW_EDGES}
            onClick={() => zoomToEdges(edges)}
          >
            {translate("typeChanges.edges", { edges: edges.length })}
            <Swatch type={before} />
            {LINE_STYLES[before].title}
            <IconArrowRight size={13} aria-label={translate("typeChanges.becomes")} />
            <Swatch type={after} />
            {LINE_STYLES[after].title}
          </button>
        </li>
      ))}
    </Box>
  );
}
