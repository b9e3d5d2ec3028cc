"""file: a carton as a DXF file with a named layer for each line type, which import reads back."""

from __future__ import annotations

import numpy as np

from knifetip.cartons.carton import Carton
from knifetip.dxf.samples.contours import CREASE, CUT, V_GROOVE, separate_lines
from knifetip.dxf.samples.write import Layer, write_own_dxf
from knifetip.geometry.path import Paths
from knifetip.model.dieline import LineType


def carton_dxf(carton: Carton) -> bytes:
    """Return the DXF file of a carton: in mm, the same bytes for equal cartons."""
    sheet: list[tuple[Layer, Paths]] = [(CUT, path) for path in (carton.outline, *carton.cuts)]
    for layer, kind in ((CREASE, LineType.CREASE), (V_GROOVE, LineType.V_GROOVE)):
        lines = [(*fold.start, *fold.end) for fold in carton.folds if fold.line_type == kind]
        if lines:
            sheet.append((layer, separate_lines(np.array(lines))))
    return write_own_dxf(sheet)
