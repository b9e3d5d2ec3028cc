/** Pictures of the dimensions of tools and boards beside their fields. */

import { translate } from "../../language/translate";
import css from "./library.module.css";

interface Picture {
  /** Outline of the tool or the board. */
  readonly body: string;
  /** Axes, and the top face of the board. */
  readonly thin: string;
  /** Dimension lines. */
  readonly lines: string;
  /** Letters at their places, with the name of the field that they stand for. */
  readonly letters: readonly (readonly [letter: string, field: string, x: number, y: number])[];
}

/** In a frame of 240 × 130; tools travel to the right, or away from the viewer. */
const PICTURES: Readonly<Record<string, Picture>> = {
  knife: {
    body: "M70 10H110V60L70 115V10",
    thin: "M20 85H220M70 115V125M70 60V85",
    lines: "M70 20H110M70 16v8M110 16v8M70 75A40 40 0 0 1 93 83",
    letters: [
      ["w", "blade_width", 90, 34],
      ["α", "blade_angle", 84, 72],
    ],
  },
  "v-cutter": {
    body: "M40 110L48 112L104 56L96 48ZM170 20H206V110H170Z",
    thin: "M100 8V124M20 84H130M150 84H226M188 8V124M40 110V60",
    lines: "M40 122H100M40 118v8M100 118v8M40 78A32 32 0 0 1 63 87M170 120H188M170 116v8M188 116v8",
    letters: [
      ["d", "back", 66, 118],
      ["θ", "tilt", 54, 74],
      ["r", "half_width", 200, 126],
    ],
  },
  "crease-wheel": {
    body: "M70 20a45 45 0 1 0 .1 0M180 20h12v90h-12Z",
    thin: "M10 104H226M70 10V120M186 10V120",
    lines: "M70 65L102 33M180 118h12M180 114v8M192 114v8",
    letters: [
      ["R", "radius", 92, 60],
      ["b", "width", 206, 122],
    ],
  },
  cutter: {
    body: "M96 10H144V110H96ZM96 40L144 28M96 66L144 54M96 92L144 80",
    thin: "M30 80H90M150 80H210M120 4V124",
    lines: "M120 118H144M120 114v8M144 114v8",
    letters: [["r", "radius", 158, 122]],
  },
  board: {
    body: "M20 40H96Q108 40 111 54Q120 64 129 54Q132 40 144 40H220V110H20Z",
    thin: "",
    lines: "M40 40V110M36 40h8M36 110h8M120 40V60M116 40h8",
    letters: [
      ["T", "caliper", 54, 80],
      ["c", "crease_along", 120, 32],
    ],
  },
};

interface Props {
  /** Kind of the tool, or board. */
  readonly kind: string;
  /** Title of a field by its name. */
  readonly titleOf: (field: string) => string | undefined;
}

export function DimensionPicture({ kind, titleOf }: Props) {
  const picture = PICTURES[kind];
  if (picture === undefined) return null;
  const legend = picture.letters
    .map(([letter, field]) => `${letter} ${titleOf(field) ?? ""}`.trim())
    .join(" · ");
  return (
    <figure className={css.dimensions} data-testid={`dimensions-${kind}`}>
      <svg viewBox="0 0 240 130" role="img" aria-label={translate("dimensionPicture.dimensions")}>
        <title>{legend}</title>
        <path className={css.body} d={picture.body} />
        <path className={css.thin} d={picture.thin} />
        <path className={css.line} d={picture.lines} />
        {picture.letters.map(([letter, field, x, y]) => (
          <text key={field} x={x} y={y} textAnchor="middle">
            {letter}
          </text>
        ))}
      </svg>
      <figcaption>{legend}</figcaption>
    </figure>
  );
}
