"""Compare the passes of a cut: find stretches of tip paths that are too deep for one pass, and
stretches that only shallow passes follow.
"""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from knifetip.verification.checks.common.context import DEPTH_TOLERANCE
from knifetip.verification.columns import F64, I32, Bool
from knifetip.verification.curves.curve import azimuth_at
from knifetip.verification.curves.intervals import uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import angle_between


def too_deep_spans(
    curve: F64, deep: F64, step: float, near: float, *, one_way: bool = False
) -> tuple[I32, F64]:
    """Return the stretches of tip paths that are more than a step deeper than all earlier passes.

    Parameters
    ----------
    curve : (n, 6)
        Tip paths in the order of the program: lines and arcs as rows of six numbers (see
        ``curves.curve``).
    deep : (n,) mm
        Depth of each tip path below the top of the board.
    step : mm
        Greatest permitted depth of one pass.
    near : mm
        Greatest distance at which an earlier tip path counts as an earlier pass of the same cut.
    one_way
        True if only earlier passes in the same direction count.

    Returns
    -------
    Index of the tip path of each of k stretches (k,), and the start and end of the stretch along
    that path (k, 2) mm.
    """
    late = np.flatnonzero(deep > step + DEPTH_TOLERANCE)
    if len(late) == 0:
        return np.zeros(0, np.int32), np.zeros((0, 2))
    overlaps = find_overlaps(curve[late], curve, np.zeros(len(curve)), curve[:, 5], near)
    ready = overlaps.edge < late[overlaps.curve]
    ready &= deep[overlaps.edge] >= deep[late[overlaps.curve]] - step - DEPTH_TOLERANCE
    if one_way:
        own = azimuth_at(curve[late[overlaps.curve]], overlaps.along.mean(axis=1))
        ready &= (
            angle_between(own, azimuth_at(curve[overlaps.edge], overlaps.place.mean(axis=1))) < 90.0
        )
    earlier = replace(overlaps, curve=overlaps.curve[ready], along=overlaps.along[ready])
    path_rows, spans = uncovered_curves(earlier, curve[late])
    return late[path_rows].astype(np.int32), spans


def unfinished_spans(curve: F64, is_final: Bool, near: float) -> tuple[I32, F64]:
    """Return the stretches of tip paths that no pass at the final depth repeats.

    Parameters
    ----------
    curve : (n, 6)
        Tip paths: lines and arcs as rows of six numbers (see ``curves.curve``).
    is_final : (n,)
        Mask of the tip paths at the final depth.
    near : mm
        Greatest distance between two passes of the same cut.

    Returns
    -------
    Index of the tip path of each of k stretches (k,), and the start and end of the stretch along
    that path (k, 2) mm.
    """
    shallow = np.flatnonzero(~is_final)
    final = curve[is_final]
    overlaps = find_overlaps(curve[shallow], final, np.zeros(len(final)), final[:, 5], near)
    path_rows, spans = uncovered_curves(overlaps, curve[shallow])
    return shallow[path_rows].astype(np.int32), spans
