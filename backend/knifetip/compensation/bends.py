"""bends: find the joints of bends at which a knife is lifted, because its blade has a width.

A blade of width w that turns in the board forces it apart over w mm of its path.  At a corner
sharper than its ``swivel`` angle it is therefore lifted.  The same turn, spread over several joints
or over a joint and an arc within the width of the blade, needs the same lift.

Source: our derivation.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.path import Paths
from knifetip.model.tool import Knife

#: A joint that turns by less than this part of the swivel angle is no corner of a bend.
_LEAST_CORNER: Final = 1.0 / 3.0


def bend_corners(paths: Paths, c_start: F64, c_end: F64, blade: Knife) -> Bool:
    """Return the mask of the segments at whose start a knife is lifted because of a bend, (n,).

    At the start of such a segment the path turns by more than a third of the blade's swivel angle,
    and within the width of the blade before or after that joint by more than the swivel angle.

    Parameters
    ----------
    paths
        The paths of the tip, with n segments.
    c_start, c_end : (n,) degrees
        Heading of the blade at the start and end of each segment, without jumps of 360° in a path.
    blade
        The knife.
    """
    turned = np.abs(c_start - np.roll(c_end, 1))
    turned[paths.first[:-1]] = 0.0
    result: Bool = turned > _LEAST_CORNER * blade.swivel
    joints = np.flatnonzero(result & (turned <= blade.swivel))
    if len(joints):
        length = arc.length(paths.start, paths.end, paths.bulge)
        before = _headings_away(paths, c_start, c_end, length, joints, -blade.blade_width)
        after = _headings_away(paths, c_start, c_end, length, joints, blade.blade_width)
        most = np.maximum(np.abs(c_start[joints] - before), np.abs(after - c_end[joints - 1]))
        result[joints] = most > blade.swivel
    return result


def _headings_away(
    paths: Paths, c_start: F64, c_end: F64, length: F64, joints: I64, distance: float
) -> F64:
    """Return the heading at a distance along the path from the starts of k segments, (k,) degrees.

    ``distance`` (mm) is negative towards the start of the path.  The heading at the end of a path
    is that of all points beyond.
    """
    reached = np.cumsum(length)
    owner = paths.path_of[joints]
    low, high = paths.first[:-1][owner], paths.first[1:][owner] - 1
    wanted = reached[joints - 1] + distance
    row = np.clip(np.searchsorted(reached, wanted), low, high)
    share = np.clip((wanted - reached[row]) / length[row] + 1.0, 0.0, 1.0)
    result: F64 = c_start[row] + (c_end[row] - c_start[row]) * share
    return result
