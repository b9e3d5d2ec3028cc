"""raw_segments: move the segments of a path to one side by the radius of the tool.

At corners the moved segments overlap or leave a gap; ``trim`` and ``untrimmed`` connect them.

Source: "Tool radius compensation", equations 3 to 5, P_e = P + σ r n with σ = +1 left of travel.
"""

from __future__ import annotations

import math
from typing import Final

from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.kernels import F64_2, OutF64_2, kernel
from knifetip.offset.records import Contours

# Failure codes of the kernels: none, a coordinate that is not a number, a segment without length, a
# segment where the tool does not fit, a closed path whose offset is not closed.
NO_FAILURE: Final = 0
NOT_A_NUMBER: Final = 1
NO_LENGTH: Final = 2
DOES_NOT_FIT: Final = 3
NOT_CLOSED: Final = 4

# Kinds of joints at the start of a segment.  At SHIFTED joints the ends were moved to an
# intersection.
OPEN: Final = 0
SMOOTH: Final = 1
CONVEX: Final = 2
CONCAVE: Final = 3
SHIFTED: Final = 4

# Columns of the table, one row per segment: tangents at both ends, chord, signed radius (0 for a
# line), ends of the moved segment, and its signed radius (0 for a line, NaN if nothing is left).
U1X, U1Y, U2X, U2Y, CHORD, RADIUS, SX, SY, EX, EY, MOVED = range(11)
COLUMNS: Final = 11

#: Largest shift of an end for which an arc keeps its bulge (mm).
NEGLIGIBLE_SHIFT: Final = 1e-10


@kernel(allocates=False)
def is_closed(contours: Contours, low: int, high: int) -> bool:
    """Return whether the path with the segments low … high - 1 ends at its start."""
    start, end = contours.start, contours.end
    return math.hypot(start[low, 0] - end[high - 1, 0], start[low, 1] - end[high - 1, 1]) < POINT


@kernel(allocates=False)
def move_segments(
    contours: Contours, low: int, high: int, signed: float, table: OutF64_2, first_row: int
) -> tuple[int, int]:
    """Move contour segments sideways by the tool's radius, and write them to ``table``.

    The contour segments low … high - 1 are written from row ``first_row`` on.  ``signed`` is the
    radius of the tool (mm), positive left of travel.

    Returns
    -------
    code, segment
        ``NO_FAILURE`` or another failure code of this module, and the contour segment that failed.
    """
    start, end, bulge = contours.start, contours.end, contours.bulge
    for i in range(low, high):
        row = first_row + i - low
        x0, y0, x1, y1, b = start[i, 0], start[i, 1], end[i, 0], end[i, 1], bulge[i]
        dx = x1 - x0
        dy = y1 - y0
        length = math.sqrt(dx * dx + dy * dy)
        if not math.isfinite(length + b + x0 + y0):
            return NOT_A_NUMBER, i
        if length < POINT:
            return NO_LENGTH, i
        ux = dx / length
        uy = dy / length
        u1x, u1y, u2x, u2y = ux, uy, ux, uy
        radius = 0.0
        beside = 0.0
        if abs(b) >= BULGE:
            # Cosine and sine of half the sweep, 2 atan b.
            whole = 1.0 + b * b
            cos = (1.0 - b * b) / whole
            sin = 2.0 * b / whole
            u1x = ux * cos + uy * sin
            u1y = uy * cos - ux * sin
            u2x = ux * cos - uy * sin
            u2y = uy * cos + ux * sin
            radius = length * whole / (4.0 * b)
            size = abs(radius) - math.copysign(signed, signed * b)
            beside = math.copysign(size, b) if size >= POINT else math.nan
        table[row, U1X] = u1x
        table[row, U1Y] = u1y
        table[row, U2X] = u2x
        table[row, U2Y] = u2y
        table[row, CHORD] = length
        table[row, RADIUS] = radius
        table[row, SX] = x0 - signed * u1y
        table[row, SY] = y0 + signed * u1x
        table[row, EX] = x1 - signed * u2y
        table[row, EY] = y1 + signed * u2x
        table[row, MOVED] = beside
    return NO_FAILURE, low


@kernel(allocates=False)
def remaining_bulge(
    table: F64_2, row: int, dx: float, dy: float, bulge: float, x: float, y: float
) -> float:
    """Return the bulge of the remaining part of a moved arc, 0 if no part remains.

    Parameters
    ----------
    table, row
        Moved segments, and the row of the arc in them.  The start of the arc in the table is
        already the start of the remaining part.
    dx, dy : mm
        Chord of the remaining part.
    bulge
        Bulge of the whole arc.
    x, y : mm
        Start of the contour's arc, before it was moved by the tool's radius.
    """
    beside = table[row, MOVED]
    # The ray from the centre to the start, perpendicular to the tangent there.
    rx = table[row, SX] - x + table[row, RADIUS] * table[row, U1Y]
    ry = table[row, SY] - y - table[row, RADIUS] * table[row, U1X]
    sine = (rx * dx + ry * dy) / beside
    cosine = (rx * dy - ry * dx) / beside
    bent: float = -sine / (math.sqrt(dx * dx + dy * dy) + cosine)
    if bent * bulge <= 0.0 or abs(bent) > 1.5 * abs(bulge):
        return 0.0
    return bent
