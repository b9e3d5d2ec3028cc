/** The palette as RGBA bytes, for the viewer. */

import { LINE_TYPES, type LineType } from "../geometry/records";
import type { Palette } from "../scene/dieline";
import type { Scale } from "../scene/figureColours";
import { rgba } from "../scene/lines";
import { COLOURS, LINE_STYLES, SCALE, type Scheme } from "../state/drawing/palette";
import type { ViewerColours } from "../viewer/contract";

/** Colours of the canvas in a colour scheme. */
export function viewerColours(scheme: Scheme): ViewerColours {
  const colours = COLOURS[scheme];
  const lineLook = (type: LineType) =>
    [type, { colour: rgba(colours[type]), dash: LINE_STYLES[type].dash }] as const;
  return {
    palette: Object.fromEntries(LINE_TYPES.map(lineLook)) as Palette,
    swept: {
      cutter: rgba(colours.cutter, 0.2),
      groove: rgba(colours.groove, 0.28),
      groovesRim: rgba(colours.groove, 0.8),
      crease: rgba(colours.pressed, 0.3),
      contact: rgba(colours.pressed, 0.95),
    },
    marks: {
      plunge: rgba(colours.plunge),
      lift: rgba(colours.lift),
      swivel: rgba(colours.swivel),
    },
    uncut: rgba(colours.uncut, 0.5),
    uncutRim: rgba(colours.uncut),
    corner: rgba(colours.blade),
    pin: rgba(colours.pin),
    head: rgba(colours.head),
    lead: rgba(colours.lead),
    tip: rgba(colours.tip, 0.9),
    rapid: rgba(colours.rapid, 0.8),
    done: rgba(colours.done),
    backdrop: colours.backdrop,
    table: colours.table,
    ground: rgba(colours.table),
    tableEdge: rgba(colours.tableEdge),
    sheetEdge: rgba(colours.sheetEdge),
    zone: rgba(colours.zone, 0.9),
    gridMinor: rgba(colours.grid, 0.045),
    gridMajor: rgba(colours.grid, 0.07),
    axisX: rgba(colours.axisX, 0.75),
    axisY: rgba(colours.axisY, 0.75),
    hover: rgba(colours.hover),
    chosen: rgba(colours.chosen, 0.55),
    mark: rgba(colours.hover),
    blade: rgba(colours.blade),
  };
}

/** Scale of the figures in a colour scheme. */
export const mapScale = (scheme: Scheme): Scale => ({
  stops: SCALE[scheme].stops.map((stop) => rgba(stop)),
  beyond: rgba(SCALE[scheme].beyond),
  unworked: rgba(SCALE[scheme].unworked),
});
