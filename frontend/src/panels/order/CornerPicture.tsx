/** Picture of the path of a cutter past an outer corner. */

import type { CornerType } from "../../state/order/corners";
import css from "./corners.module.css";

/** Path of the tool centre past a corner at (34, 26), with a tool radius of 14. */
const PATHS: Readonly<Record<Exclude<CornerType, "auto">, string>> = {
  B: "M2 12H34A14 14 0 0 1 48 26V42",
  C: "M2 12H48V42",
  D: "M2 12H41A7 7 0 0 1 48 19V42",
};

export function CornerPicture({ type }: { type: CornerType }) {
  const all = type === "auto";
  return (
    <svg viewBox="0 0 56 44" width="56" height="44" aria-hidden="true">
      <path d="M2 26H34V44H2Z" className={css.cornerPart} />
      <circle cx="20" cy="12" r="10" className={css.cornerDisc} />
      {(all ? (["B", "C", "D"] as const) : [type]).map((shown) => (
        <path key={shown} d={PATHS[shown]} className={css.cornerPath} data-faint={all} />
      ))}
    </svg>
  );
}
