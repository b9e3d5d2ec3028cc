"""polyline_widths: the widths of polylines that are drawn as wide lines.

A wide polyline has a width in file units, which is that of the drawn line if it is the same
everywhere.  Programs that convert pages to DXF, such as pstoedit, write the width of a pen in
this way.
"""

from __future__ import annotations

import numpy as np

from knifetip.drawing_builder.line_widths import hundredths
from knifetip.dxf.fast_reader import fields as f
from knifetip.dxf.fast_reader.scan import Scan
from knifetip.dxf.shapes import one_width
from knifetip.geometry.columns import F64


def set_polyline_widths(scanned: Scan, scale: float) -> F64:
    """Return the width of each wide polyline, (e,) (file units), 0 for other entities.

    The widths also replace the line widths in the column ``LINE_WIDTH`` of ``Scan.entity``.

    Parameters
    ----------
    scanned
        The scanned file, with e entities.
    scale
        Millimetres per file unit, 0 while the unit is unknown.
    """
    entity, width = scanned.entity, np.zeros(len(scanned.entity))
    kind = entity[:, f.KIND]
    # Few drawings have a wide polyline: the columns of all other entities are not read.
    rows = np.flatnonzero((kind == f.LWPOLYLINE) | (kind == f.POLYLINE))
    rows = rows[entity[rows, f.UNSUPPORTED] == 0]
    values = {column: scanned.value[rows, column] for column in f.OF_POLYLINE}
    rows = rows[(values[f.MOST_WIDTH] > 0.0) | (values[f.START_WIDTH] > 0.0)]
    if not len(rows):
        return width
    values = {column: scanned.value[rows, column] for column in f.OF_POLYLINE}
    is_light = entity[rows, f.KIND] == f.LWPOLYLINE
    count = entity[rows, f.COUNT]
    least, most = values[f.LEAST_WIDTH], values[f.MOST_WIDTH]
    for number, default in ((f.STARTS, f.START_WIDTH), (f.ENDS, f.END_WIDTH)):
        missing = ~(values[number] >= count)
        other = np.where(is_light, 0.0, np.nan_to_num(values[default]))
        least = np.where(missing, np.fmin(least, other), least)
        most = np.where(missing, np.fmax(most, other), most)
    whole = is_light & (least == 0.0) & (most == 0.0)
    constant = values[f.START_WIDTH]
    width[rows] = one_width(np.where(whole, constant, least), np.where(whole, constant, most))
    rows = rows[width[rows] > 0.0]
    entity[rows, f.LINE_WIDTH] = hundredths(width[rows] * (scale or 1.0))
    return width
