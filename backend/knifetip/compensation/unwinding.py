"""unwinding: lift a knife where its heading would leave the limits of axis C.

While the tool is above the board, C may turn by whole periods of the tool without effect.  A pass,
which is the part of a path between two lifts, fits if its headings plus a multiple of the period
are within the limits.  A pass that does not fit is divided between two segments: there the knife is
lifted, turned back by a period, and enters the same cut again.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, Bool

#: Excess over a limit that is rounding (degrees); the same as in ``sequencing.travel``.
_ROUNDING = 1e-6


class TurnLimits(NamedTuple):
    """Limits of the heading of a tool, and rotation after which the tool is the same (degrees)."""

    low: float
    high: float
    period: float


def lifts_to_unwind(c_start: F64, c_end: F64, length: F64, down: Bool, limits: TurnLimits) -> Bool:
    """Return the mask of n segments before which a knife plunges.  It adds plunges to ``down``
    where the knife must be lifted to unwind C.

    Passes that fit stay as they are.  A segment that does not fit alone remains beyond the limits.

    Parameters
    ----------
    c_start, c_end : (n,) degrees
        Headings at the start and the end of each segment, without jumps of 360°.
    length : (n,) mm
        Length of each segment.
    down : (n,)
        Mask of the segments before which the knife plunges in any case; it includes the first one.
    limits
        Limits of C.
    """
    least, greatest = np.minimum(c_start, c_end), np.maximum(c_start, c_end)
    first = np.flatnonzero(down)
    low, high = np.minimum.reduceat(least, first), np.maximum.reduceat(greatest, first)
    wide = np.flatnonzero(~_passes_that_fit(low, high, limits))
    if len(wide) == 0:
        return down
    result = down.copy()
    turned = np.abs(c_start - np.roll(c_end, 1))
    for number in wide.tolist():
        begin = int(first[number])
        end = int(first[number + 1]) if number + 1 < len(first) else len(down)
        while begin < end:
            rows = slice(begin, end)
            size = _first_part(least[rows], greatest[rows], length[rows], turned[rows], limits)
            begin += size
            if begin < end:
                result[begin] = True
    return result


def _passes_that_fit(low: F64, high: F64, limits: TurnLimits) -> Bool:
    """Return the mask of the passes that fit, from their least and greatest headings (degrees)."""
    turns = np.floor((limits.high - high) / limits.period)
    result: Bool = low + turns * limits.period >= limits.low - _ROUNDING
    return result


def _first_part(least: F64, greatest: F64, length: F64, turned: F64, limits: TurnLimits) -> int:
    """Return the number of segments, of the m segments of a pass, before the knife is next lifted.

    If one lift suffices, it is at the sharpest corner at which both parts fit; of equal corners
    (to 0.1°) it is the one farthest from the ends of the pass.  Otherwise the first part is as long
    as possible.

    ``least``, ``greatest`` (m,) degrees: least and greatest heading of each segment.
    ``length``, ``turned`` (m,) mm and (m,) degrees: length of each segment, and angle of the corner
    at its start.
    """
    count = len(length)
    low, high = np.minimum.accumulate(least), np.maximum.accumulate(greatest)
    before = _passes_that_fit(low, high, limits)
    if before[-1]:
        return count
    low, high = np.minimum.accumulate(least[::-1]), np.maximum.accumulate(greatest[::-1])
    after = _passes_that_fit(low, high, limits)[::-1]
    sufficient = np.flatnonzero(before[:-1] & after[1:]) + 1
    if len(sufficient) == 0:
        return max(1, int(before.sum()))
    travelled = np.cumsum(length)
    margin = np.minimum(travelled, travelled[-1] - travelled)[sufficient - 1]
    return int(sufficient[np.lexsort((margin, np.round(turned[sufficient], 1)))[-1]])
