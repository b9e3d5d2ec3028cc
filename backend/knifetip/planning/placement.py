"""placement: compute the position of a drawing on a machine's table."""

from __future__ import annotations

import numpy as np

from knifetip.errors import TravelExceeded
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import extents
from knifetip.model.machine import Machine
from knifetip.model.sheet import Sheet


def placement(
    dieline: Dieline, machine: Machine, sheet: Sheet | None = None
) -> tuple[float, float]:
    """Return the shift (x, y) in mm that moves the drawing to its position on the machine's table.

    The lower left corner of the drawing is moved to the machine's origin, or as far from the edges
    of the table as the margins of the sheet require.  Ignored and unclassified edges have no
    influence.

    Raises
    ------
    TravelExceeded
        The drawing is larger than the table; the message states whether it would fit if it were
        turned by 90°.
    """
    has_work = ~np.isin(dieline.line_type, (LineType.IGNORED, LineType.UNCLASSIFIED))
    low_x, low_y, high_x, high_y = extents(dieline.ends[has_work], dieline.bulge[has_work])
    x, y = machine.origin
    if sheet is not None:
        x, y = (
            start + distance
            for start, distance in zip(sheet.corner((x, y)), sheet.margins, strict=True)
        )
    width, height = high_x - low_x, high_y - low_y
    room_x, room_y = machine.width - x, machine.height - y
    if width > room_x or height > room_y:
        fits_turned = height <= room_x and width <= room_y
        raise TravelExceeded(
            "drawing.fits-turned" if fits_turned else "drawing.larger-than-table",
            width=width,
            height=height,
            machine=machine.title,
            room_x=room_x,
            room_y=room_y,
        )
    # Rounded to the decimals of a program, so that the shift in its header is exact.
    return round(x - float(low_x), 4), round(y - float(low_y), 4)
