/** A small picture of the edges of a track. */

import type { Box } from "../../geometry/records";
import { pathData } from "../../geometry/svgPath";
import { useEdges } from "../../state/queries";
import css from "./workOrder.module.css";

interface Props {
  edges: readonly number[];
  /** Box of the edges (mm). */
  box: Box;
  colour: string;
}

const [WIDTH, HEIGHT, MARGIN] = [34, 26, 3];

export function WorkPicture({ edges: rows, box, colour }: Props) {
  const { data: edges } = useEdges();
  const [left, low, right, high] = box;
  const scale = Math.min(
    (WIDTH - 2 * MARGIN) / Math.max(right - left, 1e-6),
    (HEIGHT - 2 * MARGIN) / Math.max(high - low, 1e-6),
  );
  const x = WIDTH / 2 - (scale * (left + right)) / 2;
  const y = HEIGHT / 2 + (scale * (low + high)) / 2;
  return (
    <svg className={css.picture} viewBox={`0 0 ${WIDTH} ${HEIGHT}`} aria-hidden="true">
      {edges !== undefined && (
        <path
          d={pathData(edges, rows)}
          stroke={colour}
          transform={`matrix(${scale} 0 0 ${-scale} ${x} ${y})`}
          vectorEffect="non-scaling-stroke"
        />
      )}
    </svg>
  );
}
