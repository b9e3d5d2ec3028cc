"""A small picture of a drawing as SVG, for lists."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Drawing
from knifetip.presentation.edges import EdgeTable

#: Number of edges that a picture shows; the shortest of further edges are left out.
_MOST: Final = 3000
#: Colours that are legible on light and on dark backgrounds, as in the drawings of the page.
COLOURS: Final = {
    LineType.CUT: "#d9534f",
    LineType.CREASE: "#2fa36b",
    LineType.V_GROOVE: "#8f6ae6",
    LineType.PERFORATION: "#c28a1d",
    LineType.HALF_CUT: "#d9772b",
    LineType.COMBI: "#93a01f",
    LineType.UNCLASSIFIED: "#8a919c",
}


def svg_picture(block: bytes) -> str:
    """Return a picture of a stored drawing, in the colours of its line types.

    Ignored edges are left out.

    Parameters
    ----------
    block
        The packed ``EdgeTable`` of the drawing.
    """
    columns = EdgeTable.unpack(block).columns
    return _picture(columns["ends"], columns["bulge"], columns["length"], columns["line_type"])


def svg_outline(drawing: Drawing) -> str:
    """Return a picture of a drawing that is not classified, in the colour of such edges."""
    line_type = np.full(len(drawing), LineType.UNCLASSIFIED, np.uint8)
    return _picture(drawing.ends, drawing.bulge, drawing.lengths, line_type)


def svg_edges(ends: F64, bulge: F64, line_type: U8) -> str:
    """Return a picture of n edges, in the colours of their line types.

    Parameters
    ----------
    ends : (n, 2, 2)
        Start and end point of each edge (mm).
    bulge : (n,)
        tan(sweep / 4) of each edge.
    line_type : (n,)
        LineType of each edge.
    """
    return _picture(ends, bulge, arc.length(ends[:, 0], ends[:, 1], bulge), line_type)


def _picture(ends: F64, bulge: F64, length: F64, line_type: U8) -> str:
    """Return the picture of n edges; the arguments are columns of ``EdgeTable``."""
    shown = np.flatnonzero(line_type != LineType.IGNORED)
    if len(shown) > _MOST:
        shown = shown[np.argsort(length[shown], kind="stable")[-_MOST:]]
    ends, bulge, line_type = ends[shown], bulge[shown], line_type[shown]
    boxes = arc.bounding_boxes(ends[:, 0], ends[:, 1], bulge).reshape(-1, 4)
    low = boxes[:, :2].min(axis=0, initial=np.inf) if len(boxes) else np.zeros(2)
    high = boxes[:, 2:].max(axis=0, initial=-np.inf) if len(boxes) else np.ones(2)
    size = np.maximum(high - low, 1e-6)
    # Y points down in SVG; a tenth of a unit is fine enough for 1000 units.
    scale = 1000.0 / size.max()
    points = (ends - low) * (scale, -scale) + (0.0, size[1] * scale)
    radius = np.abs(arc.radius(points[:, 0], points[:, 1], bulge))
    paths = []
    for kind, colour in COLOURS.items():
        rows = np.flatnonzero(line_type == kind).tolist()
        steps = "".join(_edge_path_data(points[row], radius[row], bulge[row]) for row in rows)
        if steps:
            style = f'stroke="{colour}" vector-effect="non-scaling-stroke"'
            paths.append(f'<path d="{steps}" {style}/>')
    width, height = size * scale
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="-12 -12 {width + 24:.0f} '
        f'{height + 24:.0f}" fill="none" stroke-width="1.2" stroke-linecap="round">'
        f"{''.join(paths)}</svg>"
    )


def _edge_path_data(points: F64, radius: float, bulge: float) -> str:
    """Return the path data of one edge: a line, or an arc with a bulge other than 0.

    ``points`` (2, 2) are the start and the end of the edge.
    """
    (x0, y0), (x1, y1) = points.tolist()
    if bulge == 0.0:
        return f"M{x0:.1f} {y0:.1f}L{x1:.1f} {y1:.1f}"
    large, clockwise = int(abs(bulge) > 1.0), int(bulge < 0.0)
    return f"M{x0:.1f} {y0:.1f}A{radius:.1f} {radius:.1f} 0 {large} {clockwise} {x1:.1f} {y1:.1f}"
