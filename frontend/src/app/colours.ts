/** The palette as RGBA bytes, for the viewer. */

import { LINE_TYPES, type LineType } from "../geometry/records";
import type { Palette } from "../scene/dieline";
import type { Scale } from "../scene/figureColours";
import { rgba } from "../scene/lines";
import { CANVAS, LINE_STYLES, MARKS, SCALE, SWEPT, TRAVEL, UNCUT } from "../state/drawing/palette";
import type { ViewerColours } from "../viewer/contract";

const lineLook = (type: LineType) =>
  [type, { colour: rgba(LINE_STYLES[type].colour), dash: LINE_STYLES[type].dash }] as const;

export const VIEWER_COLOURS: ViewerColours = {
  palette: Object.fromEntries(LINE_TYPES.map(lineLook)) as Palette,
  swept: {
    cutter: rgba(SWEPT.cutter, 0.2),
    groove: rgba(SWEPT.groove, 0.28),
    groovesRim: rgba(SWEPT.groove, 0.8),
    crease: rgba(SWEPT.crease, 0.3),
    contact: rgba(SWEPT.crease, 0.95),
  },
  marks: { plunge: rgba(MARKS.plunge), lift: rgba(MARKS.lift), swivel: rgba(MARKS.swivel) },
  uncut: rgba(UNCUT, 0.5),
  uncutRim: rgba(UNCUT),
  corner: rgba(CANVAS.blade),
  pin: rgba(CANVAS.pin),
  head: rgba(TRAVEL.head),
  lead: rgba(TRAVEL.lead),
  tip: rgba(TRAVEL.tip, 0.9),
  rapid: rgba(TRAVEL.rapid, 0.8),
  done: rgba(TRAVEL.done),
  backdrop: CANVAS.backdrop,
  table: CANVAS.table,
  ground: rgba(CANVAS.table),
  tableEdge: rgba(CANVAS.tableEdge),
  sheetEdge: rgba(CANVAS.sheetEdge),
  zone: rgba(CANVAS.zone, 0.9),
  gridMinor: rgba(CANVAS.gridMinor, 0.045),
  gridMajor: rgba(CANVAS.gridMajor, 0.07),
  axisX: rgba("#ff6b61", 0.75),
  axisY: rgba("#3ddc97", 0.75),
  hover: rgba(CANVAS.hover),
  chosen: rgba(CANVAS.chosen, 0.55),
  mark: rgba(CANVAS.mark),
  blade: rgba(CANVAS.blade),
};

export const MAP_SCALE: Scale = {
  stops: SCALE.stops.map((stop) => rgba(stop)),
  beyond: rgba(SCALE.beyond),
  unworked: rgba(SCALE.unworked),
};
