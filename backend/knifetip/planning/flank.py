"""Flank: whether both flanks of a V-groove stay on the board.

At depth h the flanks meet the top face h tan θ beside the line.  A cut that runs closer than
that beside a groove would leave an edge without its full thickness.
"""

from __future__ import annotations

import numpy as np

from knifetip.errors import FlankOutside
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left, unit
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import GAP, POINT
from knifetip.model.dieline import Dieline, LineType

_CHORDS = 8
#: Pairs of flank and chord that are looked at in one go.
_PAIRS = 4_000_000


def check_flanks(paths: Paths, source: I32, reach: float, out: F64, dieline: Dieline) -> None:
    """Refuse grooves whose flanks cross a cut beside them.

    A groove ends where a cut crosses it, and there its flanks may leave the board: twice their
    reach is left out at either end, and as much as it runs out where that is more.

    Parameters
    ----------
    paths, source
        The grooves, and the edge of each of their segments.
    reach : mm
        Of a flank beside the line.
    out : (p, 2) mm
        By which each groove runs out past its start and its end.

    Raises
    ------
    FlankOutside
        Names the groove.
    """
    cut = dieline.line_type == LineType.CUT
    ends = dieline.ends[cut]
    points = arc.points_along(ends[:, 0], ends[:, 1], dieline.bulge[cut], _CHORDS + 1)
    chords = np.stack([points[:, :-1], points[:, 1:]], axis=2).reshape(-1, 2, 2)
    begin, finish = paths.start[paths.first[:-1]], paths.end[paths.first[1:] - 1]
    # Where a groove runs out over the edge, its other flank left the board as far before it.
    inset = np.maximum(2.0 * reach, out * 1.001 + GAP)
    long = np.hypot(*(finish - begin).T) > np.maximum(inset.sum(axis=1), POINT)
    ahead = unit((finish - begin)[long])
    after, before = inset[long, :1] * ahead, inset[long, 1:] * ahead
    for side in (1.0, -1.0):
        beside = side * reach * left(ahead)
        start, end = begin[long] + beside + after, finish[long] + beside - before
        step = max(1, _PAIRS // max(1, len(chords)))
        for row in range(0, len(start), step):
            hit = _crossed(start[row : row + step], end[row : row + step], chords)
            if hit.any():
                path = np.flatnonzero(long)[row + int(np.argmax(hit))]
                edge = int(source[paths.first[path]])
                raise FlankOutside(
                    f"The V-groove at edge {edge} is {2.0 * reach:.2f} mm wide at the top face, "
                    "and a cut runs through its flank.",
                    "Move the groove or the cut, or take a shallower groove.",
                    [str(edge)],
                )


def _crossed(start: F64, end: F64, chords: F64) -> Bool:
    """Return for each line whether any chord crosses it."""

    def side(a: F64, b: F64, p: F64) -> F64:
        turned: F64 = (b[..., 0] - a[..., 0]) * (p[..., 1] - a[..., 1]) - (
            b[..., 1] - a[..., 1]
        ) * (p[..., 0] - a[..., 0])
        return turned

    a, b = start[:, None], end[:, None]
    c, d = chords[None, :, 0], chords[None, :, 1]
    crossing = (side(a, b, c) * side(a, b, d) < 0.0) & (side(c, d, a) * side(c, d, b) < 0.0)
    hit: Bool = np.logical_or.reduce(crossing, axis=1)
    return hit
