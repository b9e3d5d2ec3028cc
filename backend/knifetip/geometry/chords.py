"""chords: split moves into equal pieces, for controllers that cannot follow an arc."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I64

#: Deviation of chords from their arc on a machine whose controller cannot follow arcs (mm).
DEVIATION: Final = 0.002


def chord_counts(start: F64, end: F64, bulge: F64, deviation: float) -> I64:
    """Return the number of equal chords of each of n segments, (n,), at least 1.

    Parameters
    ----------
    start, end : (n, 2) mm
        Ends of the segments.
    bulge : (n,)
        tan(sweep / 4) of each segment.
    deviation : mm
        Greatest distance of a chord from its arc.
    """
    # The sagitta of a part of an arc is proportional to the square of its length.
    bow = np.abs(bulge) * np.hypot(*(end - start).T) / 2.0
    counts: I64 = np.ceil(np.sqrt(bow / deviation)).astype(np.int64).clip(1)
    return counts


def split_moves(pose: F64, bulge: F64, pieces: I64) -> tuple[F64, I64]:
    """Split each of n moves into pieces of equal length.

    Parameters
    ----------
    pose : (n + 1, k) float64
        Poses before the first of the n moves and after each move: X and Y (mm) first, then axes
        that change linearly along each move.
    bulge : (n,) float64
        tan(sweep / 4) of each move in XY.
    pieces : (n,) int64
        Number of pieces of each move, at least 1.

    Returns
    -------
    pose : (m + 1, k) float64
        Poses before the first of the m pieces and after each piece.
    move : (m,) int64
        Index of the move to which each piece belongs.
    """
    rows = np.repeat(np.arange(len(bulge)), pieces)
    if len(rows) == len(bulge):
        return pose, rows
    ordinal = np.arange(len(rows)) - np.repeat(np.cumsum(pieces) - pieces, pieces) + 1
    fraction = ordinal / pieces[rows]
    between = pose[rows] + (pose[rows + 1] - pose[rows]) * fraction[:, None]
    start, end = pose[:-1, :2], pose[1:, :2]
    between[:, :2] = arc.point_at(start[rows], end[rows], bulge[rows], fraction)
    return np.concatenate([pose[:1], between]), rows
