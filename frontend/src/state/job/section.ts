/** The measures of a section across an edge, and its outlines in pixels, to scale. */

import type { EdgeSection, ToolSection } from "../../api/jobs";

/** Measures with a dimension in the picture, in the order of their letters. */
export const DRAWN = ["caliper", "depth", "base", "beyond", "topWidth", "foldAngle"] as const;
export type Drawn = (typeof DRAWN)[number];

export type MeasureName =
  | Drawn
  | "requiredFold"
  | "flankAngle"
  | "passes"
  | "rimWidth"
  | "wheelRadius"
  | "contactLength"
  | "bladeWidth"
  | "bladeAngle"
  | "bladeLead";

export interface Measure {
  readonly name: MeasureName;
  readonly value: number;
  readonly unit: "mm" | "°" | "";
  /** Letter of its dimension in the picture; empty if it has none. */
  readonly letter: string;
}

/** Shorter lengths are not drawn (mm). */
const VISIBLE = 0.005;

/** What the tool makes of the board, with a letter for each dimension of the picture. */
export function measuresOf(
  section: Pick<EdgeSection, "caliper" | "required_fold">,
  tool: ToolSection,
): readonly Measure[] {
  const { cross, shape } = tool;
  const isGroove = shape === "groove";
  const drawn: Readonly<Record<Drawn, number | null>> = {
    caliper: section.caliper,
    depth: tool.depth,
    base: tool.base >= VISIBLE ? tool.base : null,
    beyond: tool.beyond >= VISIBLE ? tool.beyond : null,
    topWidth: cross.top_width,
    foldAngle: cross.fold_angle,
  };
  const listed = DRAWN.filter((name) => drawn[name] !== null);
  const lengths: readonly (readonly [MeasureName, number | null])[] = [
    // The width of a crease is that of the rim.
    ["rimWidth", shape === "wheel" ? null : cross.rim_width],
    ["wheelRadius", cross.wheel_radius],
    ["contactLength", cross.contact_length],
    ["bladeWidth", cross.blade_width],
    ["bladeLead", cross.blade_lead],
  ];
  const angles: readonly (readonly [MeasureName, number | null])[] = [
    ["requiredFold", isGroove ? section.required_fold : null],
    ["flankAngle", cross.flank_angle],
    ["bladeAngle", cross.blade_angle],
  ];
  const plain =
    (unit: Measure["unit"]) =>
    ([name, value]: readonly [MeasureName, number | null]): readonly Measure[] =>
      value === null ? [] : [{ name, value, unit, letter: "" }];
  return [
    ...listed.map((name, at) => ({
      name,
      value: drawn[name] ?? 0,
      unit: name === "foldAngle" ? ("°" as const) : ("mm" as const),
      letter: String.fromCharCode(97 + at),
    })),
    ...angles.flatMap(plain("°")),
    ...lengths.flatMap(plain("mm")),
    ...(tool.passes > 1
      ? [{ name: "passes" as const, value: tool.passes, unit: "" as const, letter: "" }]
      : []),
  ];
}

/** Whether the flanks of a groove meet before the board has folded as far as it must. */
export const closesEarly = (
  { required_fold }: Pick<EdgeSection, "required_fold">,
  { cross }: ToolSection,
): boolean => cross.fold_angle !== null && cross.fold_angle < required_fold - 0.05;

/** Size of the picture, and the space beside the board for dimensions (pixels). */
const WIDTH = 340;
const SIDE = { left: 78, right: 92, top: 50, bottom: 26 };
const TALLEST = 120;

export interface SectionView {
  readonly width: number;
  readonly height: number;
  /** Pixels per mm. */
  readonly scale: number;
  /** Middle of the tool, and left and right end of the board. */
  readonly x: { readonly middle: number; readonly left: number; readonly right: number };
  /** Top face, bottom face, deepest place of the board that is made, and tip of the tool. */
  readonly y: {
    readonly top: number;
    readonly bottom: number;
    readonly depth: number;
    readonly tip: number;
  };
  /** Half the width of the opening in the top face. */
  readonly half: number;
  /** Outlines of the board, and of the tool in it. */
  readonly board: string;
  readonly tool: string;
}

/** Outlines of the section, at one scale in both directions. */
export function sectionView(caliper: number, tool: ToolSection): SectionView {
  const opening = tool.cross.top_width ?? 0;
  const space = (WIDTH - SIDE.left - SIDE.right) / 2;
  const reach = Math.max(opening / 2 + 0.7 * caliper, 1.3 * caliper, 0.1);
  const scale = Math.min(space / reach, TALLEST / Math.max(caliper, 0.01));
  const middle = SIDE.left + space;
  const x = { middle, left: middle - space, right: middle + space };
  const top = SIDE.top;
  const y = {
    top,
    bottom: top + caliper * scale,
    depth: top + tool.depth * scale,
    tip: top + (tool.depth + tool.beyond) * scale,
  };
  const half = (opening / 2) * scale;
  const height = Math.max(y.bottom, y.tip) + SIDE.bottom;
  const view = { width: WIDTH, height, scale, x, y, half };
  return { ...view, board: boardOutline(view, tool), tool: toolOutline(view, tool) };
}

type Frame = Omit<SectionView, "board" | "tool">;

/** The board without what the tool removes or presses. */
function boardOutline({ x, y, half }: Frame, { shape, depth }: ToolSection): string {
  const [left, right] = [x.middle - half, x.middle + half];
  const whole = `M${x.left} ${y.top}H${left}`;
  const rest = `H${x.right}V${y.bottom}H${x.left}Z`;
  if (depth <= 0 || shape === "line") return `${whole}${rest}`;
  if (shape === "groove") return `${whole}L${x.middle} ${y.depth}L${right} ${y.top}${rest}`;
  if (shape === "disc") return `${whole}V${y.depth}H${right}V${y.top}${rest}`;
  // The rim of a wheel is round, and the board bends beside it.
  const round = Math.min(half / 2, (y.depth - y.top) / 2);
  return (
    `${whole}V${y.depth - round}q0 ${round} ${round} ${round}` +
    `H${right - round}q${round} 0 ${round} ${-round}V${y.top}${rest}`
  );
}

/** How far the tool is drawn above the board (pixels). */
const ABOVE = 16;

function toolOutline({ x, y, half }: Frame, { shape }: ToolSection): string {
  const above = y.top - ABOVE;
  if (shape === "line") return `M${x.middle} ${above}V${y.tip}`;
  if (shape === "groove") {
    // The blade along one flank, from its tip to above the board.
    const slope = y.depth > y.top ? half / (y.depth - y.top) : 0;
    return `M${x.middle} ${y.depth}L${x.middle + slope * (y.depth - above)} ${above}`;
  }
  return `M${x.middle - half} ${above}V${y.tip}H${x.middle + half}V${above}`;
}
