"""export: write a figure as a DXF file that ``dxf.read`` reads back as it was."""

from __future__ import annotations

import io
from typing import Final

import numpy as np
from ezdxf.filemanagement import new

from knifetip.dxf.samples.write import fixed_dates
from knifetip.dxf.writers import OWN_COMMENT
from knifetip.geometry import arc
from knifetip.model.figure import Figure

#: $INSUNITS of mm.
_MILLIMETRES: Final = 4
#: Radius (mm) from which an arc is a polyline with a bulge: the angles of an ARC are not exact
#: enough for its ends.
_FLAT: Final = 1e5


def export_dxf(figure: Figure) -> bytes:
    """Return a figure as a DXF file of the version R2010, with a layer for each of its layers.

    Lines are LINE, and arcs are ARC.  Arcs that are nearly straight, with a radius of more than
    100 m, are LWPOLYLINE.  The file states mm; a figure without a unit has a file without one.
    """
    # Equal figures give equal files.
    with fixed_dates():
        text = _text(figure)
    comment = f"999\n{OWN_COMMENT}\n" if figure.unit else ""
    return (comment + text).encode("utf-8")


def _text(figure: Figure) -> str:
    document = new("R2010", units=_MILLIMETRES if figure.unit else 0)
    model = document.modelspace()
    for layer in figure.layers:
        document.layers.add(layer.name, color=layer.aci)
        attributes = {"layer": layer.name}
        start, end = layer.ends[:, 0], layer.ends[:, 1]
        radius = np.abs(arc.radius(start, end, layer.bulge))
        curved = radius <= _FLAT
        # The centre of a line is at infinity.
        centre = np.zeros_like(start)
        centre[curved] = arc.centre(start[curved], end[curved], layer.bulge[curved])
        angles = np.degrees(
            np.arctan2(
                layer.ends[..., 1] - centre[:, None, 1], layer.ends[..., 0] - centre[:, None, 0]
            )
        )
        for row, bulge in enumerate(layer.bulge.tolist()):
            first, last = layer.ends[row].tolist()
            if bulge == 0.0:
                model.add_line(first, last, dxfattribs=attributes)
            elif not curved[row]:
                points = [(*first, bulge), (*last, 0.0)]
                model.add_lwpolyline(points, format="xyb", dxfattribs=attributes)
            else:
                # ARC runs counter-clockwise.
                begin, stop = angles[row, :: 1 if bulge > 0.0 else -1].tolist()
                middle, size = centre[row].tolist(), float(radius[row])
                model.add_arc(middle, size, begin, stop, dxfattribs=attributes)
    low, high = figure.box
    document.header["$EXTMIN"], document.header["$EXTMAX"] = (*low, 0.0), (*high, 0.0)
    text = io.StringIO()
    document.write(text)
    return text.getvalue()
