/** Sample of the colour and dash of a line type. */

import type { LineType } from "../../geometry/records";
import { LINE_STYLES } from "../../state/drawing/palette";
import css from "./panels.module.css";

const DASHES = { solid: undefined, dashed: "6 3", dotted: "2 2.5", long: "11 3" } as const;

export function Swatch({ type }: { type: LineType }) {
  const { colour, dash } = LINE_STYLES[type];
  return (
    <svg className={css.swatch} viewBox="0 0 20 10" aria-hidden="true">
      <line
        x1="0"
        x2="20"
        y1="5"
        y2="5"
        stroke={colour}
        strokeWidth="2.5"
        strokeDasharray={DASHES[dash]}
      />
    </svg>
  );
}
