"""file: a test piece as a DXF file in mm, whose entities are its lines in their order."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.dxf.samples.contours import CREASE, CUT, V_GROOVE, separate_lines
from knifetip.dxf.samples.write import Layer, write_own_dxf
from knifetip.model.dieline import LineType
from knifetip.testpieces.piece import Piece

_LAYERS: Final = {
    LineType.CUT: CUT,
    LineType.CREASE: CREASE,
    LineType.V_GROOVE: V_GROOVE,
    LineType.HALF_CUT: Layer("HALF-CUT", 3),
}


def piece_dxf(piece: Piece) -> bytes:
    """Return the DXF file of a test piece: the same bytes for equal pieces."""
    return write_own_dxf(
        [
            (_LAYERS[line.line_type], separate_lines(np.array([(*line.start, *line.end)])))
            for line in piece.lines
        ]
    )
