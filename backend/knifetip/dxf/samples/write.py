"""write: write lines and arcs on layers as a DXF file such as CAD programs write.

The file has version R2010 and the unit mm, and contains LINE, ARC and LWPOLYLINE with bulges.  The
same paths give the same bytes on every run and every machine, so that a sample can be named by its
hash and compared in a test.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from dataclasses import dataclass
from io import StringIO

import numpy as np
from ezdxf import options, units
from ezdxf.filemanagement import new
from ezdxf.layouts.layout import Modelspace

from knifetip.dxf.writers import OWN_COMMENT
from knifetip.errors import GeometryError
from knifetip.geometry import arc
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import BULGE
from knifetip.model.drawing import extents

#: A dash and a gap (mm), as ISO 128 draws a fold on paper at this scale.
_DASHES = {
    "DASHED": (6.0, 3.0),
    "DASHDOT": (8.0, 2.0, 0.0, 2.0),
}


@dataclass(frozen=True, slots=True)
class Layer:
    """A layer of the DXF file, with the colour and the linetype of all entities on it."""

    name: str
    colour: int  #: AutoCAD colour index
    linetype: str = "Continuous"  #: or DASHED, DASHDOT


def write_own_dxf(sheet: Sequence[tuple[Layer, Paths]]) -> bytes:
    """Return the same as ``write_dxf`` after a comment by which import recognises the unit.

    Drawings that are made here may be so small that their size alone would suggest cm.
    """
    return f"999\n{OWN_COMMENT}\n".encode() + write_dxf(sheet)


def write_dxf(sheet: Sequence[tuple[Layer, Paths]]) -> bytes:
    """Return the content of a DXF file with paths on layers.

    Parameters
    ----------
    sheet
        Layers with the paths on them, in the order of the file; a layer may occur more than once.
        A path with one segment becomes a LINE or an ARC, a longer path an LWPOLYLINE, which is
        closed if the path is closed.

    Returns
    -------
    bytes
        DXF R2010 in UTF-8, ``$INSUNITS`` 4 (mm), without dates or random numbers.

    Raises
    ------
    GeometryError
        A coordinate is not a finite number.
    """
    for layer, paths in sheet:
        if not all(np.isfinite(column).all() for column in (paths.start, paths.end, paths.bulge)):
            raise GeometryError("layer.not-finite", layer=layer.name)
    with fixed_dates():
        return _save_bytes(sheet)


def _save_bytes(sheet: Sequence[tuple[Layer, Paths]]) -> bytes:
    document = new("R2010")
    document.units = units.MM
    document.header["$MEASUREMENT"] = 1
    for name, pattern in _DASHES.items():
        signed = [-length if gap % 2 else length for gap, length in enumerate(pattern)]
        document.linetypes.add(name, [sum(pattern), *signed])
    model = document.modelspace()
    for layer, paths in sheet:
        if layer.name not in document.layers:
            document.layers.add(layer.name, color=layer.colour, linetype=layer.linetype)
        _add_paths(model, layer.name, paths)

    if sheet:
        ends = [np.stack([paths.start, paths.end], axis=1) for _, paths in sheet]
        bulge = [paths.bulge for _, paths in sheet]
        # Adding 0 makes a zero of minus zero.
        box = extents(np.concatenate(ends), np.concatenate(bulge)).round(9) + 0.0
        low, high = box[:2].tolist(), box[2:].tolist()
        model.reset_extents((*low, 0.0), (*high, 0.0))
        # ezdxf would recompute the extents if a corner were at the origin.
        document.header["$EXTMIN"] = (*low, 0.0)
        document.header["$EXTMAX"] = (*high, 0.0)
        document.set_modelspace_vport(
            max(high[0] - low[0], high[1] - low[1]),
            ((low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0),
        )
    # ezdxf adds them in the order of a set, which differs between two processes.
    for name in sorted(document.entitydb.dxf_types_in_use()):
        document.classes.add_class(name)
    text = StringIO()
    document.write(text)
    return text.getvalue().encode("utf-8")


def _add_paths(model: Modelspace, layer: str, paths: Paths) -> None:
    centres = arc.centre(paths.start, paths.end, paths.bulge)
    radii = arc.radius(paths.start, paths.end, paths.bulge)
    attributes = {"layer": layer}
    for number, closed in enumerate(paths.closed):
        first, last = paths.first[number : number + 2]
        start, end, bulge = paths.start[first], paths.end[first], paths.bulge[first]
        if last - first > 1:
            vertices = np.column_stack([paths.start[first:last], paths.bulge[first:last]])
            if not closed:
                vertices = np.vstack([vertices, [*paths.end[last - 1], 0.0]])
            model.add_lwpolyline(
                vertices.tolist(), "xyb", close=bool(closed), dxfattribs=attributes
            )
        elif abs(bulge) < BULGE:
            model.add_line(start.tolist(), end.tolist(), attributes)
        else:
            # An ARC runs counter-clockwise, whichever way the segment went.
            spokes = np.array([start, end][:: 1 if bulge > 0 else -1]) - centres[first]
            angles = np.degrees(np.arctan2(spokes[:, 1], spokes[:, 0])) % 360.0
            # Rounded, so that the last digit does not depend on a processor's arctangent.
            model.add_arc(
                centres[first].round(9).tolist(),
                round(float(radii[first]), 9),
                round(float(angles[0]), 9),
                round(float(angles[1]), 9),
                dxfattribs=attributes,
            )


@contextmanager
def fixed_dates() -> Iterator[None]:
    """Return a context manager within which ezdxf writes fixed dates and identifiers."""
    previous = options.write_fixed_meta_data_for_testing
    options.write_fixed_meta_data_for_testing = True
    try:
        yield
    finally:
        options.write_fixed_meta_data_for_testing = previous
