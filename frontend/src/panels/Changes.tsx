/** Edges that would become something else: by what they are and would be. */

import { IconArrowRight } from "@tabler/icons-react";
import type { Retyped } from "../api/client";
import { LINE_LOOKS } from "../state/palette";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./learned.module.css";
import { Swatch } from "./Swatch";

export const proposedOf = (changes: readonly Retyped[]) =>
  changes.map(({ edges, after }) => ({ rows: edges, type: after }));

export function Changes({ changes }: { changes: readonly Retyped[] }) {
  const look = usePage((page) => page.look);
  return (
    <ul className={css.changes} data-testid="changes">
      {changes.map(({ before, after, edges }) => (
        <li key={`${before} ${after}`}>
          <button
            type="button"
            className={css.change}
            title="Show these edges"
            onClick={() => look(edges)}
          >
            {count(edges.length, "edge")}
            <Swatch type={before} />
            {LINE_LOOKS[before].title}
            <IconArrowRight size={13} aria-label="becomes" />
            <Swatch type={after} />
            {LINE_LOOKS[after].title}
          </button>
        </li>
      ))}
    </ul>
  );
}
