/** Picture of a lead-in: its length L, and its angle α to the contour. */

import css from "./corners.module.css";

/** The tool arrives at (42, 26) on the edge of a part, which it cuts from right to left. */
export function LeadPicture() {
  return (
    <svg viewBox="0 0 88 44" width="88" height="44" style={{ flex: "none" }} aria-hidden="true">
      <path d="M0 26H88V44H0Z" className={css.cornerPart} />
      <circle cx="70" cy="9" r="5" className={css.cornerDisc} />
      <path d="M70 9L42 26H6M12 22L6 26L12 30" className={css.cornerPath} />
      <path d="M66 3L38 20M58 26A16 16 0 0 0 55.5 18" className={css.cornerPath} data-faint />
      <text x="46" y="11" className={css.letter}>
        L
      </text>
      <text x="62" y="24" className={css.letter}>
        α
      </text>
    </svg>
  );
}
