"""layout_file: write the lines of a sheet as a DXF file, with one layer for each line type."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.dxf.samples.write import Layer, write_dxf
from knifetip.geometry.path import Paths
from knifetip.model.dieline import Dieline, LineType

#: AutoCAD colour indices of the first line types; the others are white.
_COLOURS: Final = {LineType.CUT: 1, LineType.CREASE: 5, LineType.V_GROOVE: 3}
_WHITE: Final = 7


def write_lines(dieline: Dieline) -> bytes:
    """Return the content of a DXF file (mm) with each line on the layer of its line type."""
    layers = []
    for kind in LineType:
        rows = np.flatnonzero(dieline.line_type == kind)
        if len(rows):
            ends = dieline.ends[rows]
            lines = Paths(
                ends[:, 0],
                ends[:, 1],
                dieline.bulge[rows],
                np.arange(len(rows) + 1, dtype=np.int32),
            )
            layers.append((Layer(kind.word.upper(), _COLOURS.get(kind, _WHITE)), lines))
    return write_dxf(layers)
