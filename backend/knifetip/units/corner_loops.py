"""corner_loops: evidence for the unit from loops at the corners of outlines.

Programs that draw for a laser move each line outwards by half the width of the beam, and connect
the moved lines with curls.  Beams are about 0.2 mm wide, so the curls show the unit, and that the
drawing is one for a laser: it may be smaller than a carton.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, UnitEvidence, factor
from knifetip.units import weights

#: Fewest loops of a drawing, and most edges of a loop.
_FEWEST: Final = 8
_MOST_EDGES: Final = 12
#: Least fraction of the edges that are short, and the length of a short edge, as a fraction of the
#: size of the drawing.
_SHORT_EDGES: Final = 0.3
_SHORT: Final = 0.005
#: Greatest distance between points that are equal, as a fraction of the size of the drawing.
_EXACT: Final = 1e-6
#: Circumference of a loop (mm).
_CIRCUMFERENCE: Final = (0.05, 0.8)


def loop_evidence(drawing: Drawing, size: float) -> list[UnitEvidence]:
    """Return the evidence for each unit in which loops at corners fit the width of a laser beam.

    Parameters
    ----------
    drawing
        The drawing; its ends are used in file units.
    size
        The longer side of the drawing, in file units.
    """
    around = corner_loops(drawing.ends / factor(drawing.unit), drawing.bulge, size)
    if len(around) < _FEWEST:
        return []
    middle = float(np.median(around))
    low, high = _CIRCUMFERENCE
    return [
        UnitEvidence(
            unit,
            Message("unit.corner-loops", unit=unit, count=len(around), length=middle * scale),
            weights.CORNER_LOOPS,
            "features",
        )
        for unit, scale in MILLIMETRES.items()
        if low <= middle * scale <= high
    ]


def corner_loops(ends: F64, bulge: F64, size: float) -> F64:
    """Return the circumference of each loop between two longer edges that meet in it.

    The edges of a loop are consecutive, and so are the longer edges before and after it.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Ends and bulges of the edges.
    size
        The longer side of the drawing.
    """
    count = len(bulge)
    length = arc.length(ends[:, 0], ends[:, 1], bulge)
    if np.count_nonzero(length < _SHORT * size) < _SHORT_EDGES * count:
        return np.empty(0)
    exact = _EXACT * size
    joined = np.abs(ends[1:, 0] - ends[:-1, 1]).max(axis=1, initial=0.0) <= exact
    links = np.concatenate([[0], np.cumsum(joined)])
    reach = np.concatenate([[0.0], np.cumsum(length)])
    found = []
    for edges in range(2, _MOST_EDGES + 1):
        first = np.arange(1, count - edges)
        if len(first) == 0:
            break
        closed = np.abs(ends[first + edges - 1, 1] - ends[first, 0]).max(axis=1) <= exact
        closed &= links[first + edges] - links[first - 1] == edges + 1
        around = reach[first + edges] - reach[first]
        longer = np.minimum(length[first - 1], length[first + edges]) > around
        found.append(around[closed & longer & (around <= _SHORT * size)])
    return np.concatenate(found) if found else np.empty(0)
