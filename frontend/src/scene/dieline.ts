/** Edges → lines coloured by what is to be done along them. */

import { length, walk } from "../geometry/arc";
import { type Edges, type LineType, lineTypeOf, type Point } from "../geometry/records";
import { mm } from "../geometry/units";
import { DASHES, type Dash, type Lines, LinesUnderWay, type Rgba } from "./lines";

/** Chords keep this near to their arcs: what a knife is held to. */
export const ROUNDNESS = mm(0.01);

/** How each line type looks. */
export type Palette = Readonly<Record<LineType, { colour: Rgba; dash: Dash }>>;

/** The nominal lines of those edges that `shown` lets through. */
export function dielineLines(
  edges: Edges,
  origin: Point,
  palette: Palette,
  shown: (row: number) => boolean = () => true,
): Lines {
  const lines = new LinesUnderWay(origin);
  for (let row = 0; row < edges.bulge.length; row++) {
    if (!shown(row)) continue;
    const { colour, dash } = palette[lineTypeOf(edges.lineType[row])];
    addEdge(lines, edges, row, colour, DASHES.indexOf(dash));
  }
  return lines.done();
}

/** The same edges in one colour, to lie under or over the others. */
export function highlightLines(
  edges: Edges,
  origin: Point,
  rows: Iterable<number>,
  colour: Rgba,
): Lines {
  const lines = new LinesUnderWay(origin);
  for (const row of rows) {
    if (row >= 0 && row < edges.bulge.length) addEdge(lines, edges, row, colour, 0);
  }
  return lines.done();
}

function addEdge(lines: LinesUnderWay, edges: Edges, row: number, colour: Rgba, dash: number) {
  const at = row * 4;
  let x = edges.ends[at] as number;
  let y = edges.ends[at + 1] as number;
  const x1 = edges.ends[at + 2] as number;
  const y1 = edges.ends[at + 3] as number;
  const bulge = edges.bulge[row] as number;
  const whole = length(x, y, x1, y1, bulge);
  let before = 0;
  walk(x, y, x1, y1, bulge, ROUNDNESS, (nextX, nextY, fraction) => {
    lines.add(x, y, nextX, nextY, colour, { along: before, dash, row });
    before = whole * fraction;
    x = nextX;
    y = nextY;
  });
}
