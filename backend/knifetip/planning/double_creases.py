"""double_creases: replace creases by two parallel lines.

The two lines of a double crease end at the same positions as the drawn crease.
"""

from __future__ import annotations

from math import cos, radians

import numpy as np

from knifetip.errors import EdgeTooShort
from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal, unit_vectors
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.path import Paths, select_paths
from knifetip.geometry.tolerance import ANGLE


def double_creases(paths: Paths, distance: float, source: I32) -> tuple[Paths, I32, I32]:
    """Replace each path by two parallel paths.

    Parameters
    ----------
    distance : mm
        Distance between the two paths; the drawn path lies midway between them.
    source : (n,)
        Index in the dieline of the edge of each segment, for error messages.

    Returns
    -------
    The new paths, the index in ``paths`` of the path that each new path replaces, and the index of
    the segment of ``paths`` that each new segment replaces.

    Raises
    ------
    EdgeTooShort
        A crease has a bend with a radius of less than half of ``distance``.
    """
    half = distance / 2.0
    radius = arc.radius(paths.start, paths.end, paths.bulge)
    tight = np.flatnonzero(radius <= half * 1.001)
    if len(tight):
        raise EdgeTooShort(
            "crease.tight-bend",
            edge=source[tight[0]],
            radius=radius[tight[0]],
            offset=half,
            at_edges=source[tight],
        )
    old_path = np.repeat(np.arange(len(paths), dtype=np.int32), 2)
    pair, rows = select_paths(paths, old_path)
    owner = pair.path_of
    ahead, last = arc.tangents(pair.start, pair.end, pair.bulge)
    ahead, last = left_normal(unit_vectors(ahead)), left_normal(unit_vectors(last))
    # At a joint the parallel lines meet on the mitre of both normals.
    before = np.roll(last, 1, axis=0)
    after = np.roll(ahead, -1, axis=0)
    first, final = pair.first[:-1], pair.first[1:] - 1
    smooth = (last[final] * ahead[first]).sum(axis=1) >= cos(radians(ANGLE))
    closed = (pair.closed & smooth)[:, None]
    before[first] = np.where(closed, last[final], ahead[first])
    after[final] = np.where(closed, ahead[first], last[final])
    side = np.where(owner % 2 == 0, half, -half)[:, None]
    return (
        Paths(
            pair.start + side * _mitre_offset(before, ahead),
            pair.end + side * _mitre_offset(last, after),
            pair.bulge,
            pair.first,
        ),
        old_path,
        rows,
    )


def _mitre_offset(line_a: F64, line_b: F64) -> F64:
    """Return the offset from each of n joints of two lines to the joint of their parallels at
    distance 1, (n, 2).

    ``line_a`` and ``line_b`` are the unit normals of the two lines at each joint, (n, 2).  The
    parallels lie on the side to which the normals point.
    """
    both = line_a + line_b
    result: F64 = both / (1.0 + (line_a * line_b).sum(axis=1))[:, None]
    return result
