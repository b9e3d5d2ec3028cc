/** Outline of a kind of tool, to recognise it in its station: seen from the side, tip down. */

import css from "./station.module.css";

/** Paths in a square of 24, by kind. */
const OUTLINES: Readonly<Record<string, string>> = {
  knife: "M9 2h6v8l0 6-6 6V2M9 10h6",
  "v-cutter": "M10 2h4v7l5 9-4 4-5-9V2M10 9h4",
  "crease-wheel": "M12 2v6M9 2h6M12 8a7 7 0 1 0 0 14 7 7 0 0 0 0-14M12 13.5v3M10.500 15h3",
  cutter: "M9 2h6v20H9V2M9 9l6-3M9 14l6-3M9 19l6-3",
  laser: "M8 2h8v6l-3 5h-2L8 8V2M12 15v2M12 19v3",
};
const OTHER = "M9 2h6v12l-3 8-3-8V2M9 8h6";

export function ToolPicture({ kind }: { kind: string }) {
  return (
    <svg className={css.toolPicture} viewBox="0 0 24 24" aria-hidden="true">
      <path d={OUTLINES[kind] ?? OTHER} />
    </svg>
  );
}
