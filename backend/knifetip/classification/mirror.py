"""mirror: cartons are symmetrical, so what is cut on the left is not folded on the right.

    Shape, line types -> which edges contradict their mirror image

A line between two panels may be a fold or a slit, and its layer is all that says which.  Where
a blank is its own mirror image and such a line is cut while its image is folded, one of the two was
drawn on the wrong layer.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.conventions import FOLDS
from knifetip.classification.evidence import Shape
from knifetip.classification.role import Role
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.distinct import distinct
from knifetip.model.dieline import LineType

#: Two lines nearer than this, as a share of the blank's size, are the same line.
_NEAR: Final = 1.0 / 500.0
#: Whether a line type is a fold, by its number: to look it up takes less than to search.
_FOLDED: Final = np.isin(np.arange(256), FOLDS)
#: So much of the length of a blank must have an image before it counts as symmetrical.
_LIKE: Final = 0.9
_MOST: Final = 50


def contradicted(ends: F64, shape: Shape, line_type: U8, length: F64) -> Bool:
    """Return which decided edges are cut while their mirror image is folded, or the reverse, (n,).

    Parameters
    ----------
    ends, length : (n, 2, 2) and (n,)
    line_type : (n,)
        As it was decided so far.
    """
    odd = np.zeros(len(ends), np.bool_)
    divides = shape.role == Role.DIVIDER
    cut = np.flatnonzero(divides & (line_type == LineType.CUT))
    fold = np.flatnonzero(divides & _FOLDED[line_type])
    if len(cut) == 0 or len(fold) == 0:
        return odd
    # Of all parts only those that have such cuts, by numbers of their own.
    number = np.full(int(shape.part.max()) + 2, -1, np.int32)
    number[shape.part[cut]] = 0
    wanted = np.flatnonzero(number == 0)
    number[wanted] = np.arange(len(wanted), dtype=np.int32)
    of = number[shape.part]
    rows = np.flatnonzero(of >= 0)
    box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (len(wanted), 1))
    points = ends[rows].reshape(-1, 2)
    owner = np.repeat(of[rows], 2)
    np.minimum.at(box[:, :2], owner, points)
    np.maximum.at(box[:, 2:], owner, points)
    centre = 0.5 * (box[:, :2] + box[:, 2:])
    size = np.maximum(box[:, 2] - box[:, 0], box[:, 3] - box[:, 1])
    fold = fold[of[fold] >= 0]
    for axis in range(2):
        one, other = _images(ends, of, cut, fold, centre, size, axis)
        for part in np.unique(of[one])[:_MOST].tolist():
            own = rows[of[rows] == part]
            there, _ = _images(ends, of, own, own, centre, size, axis)
            if length[np.unique(there)].sum() >= _LIKE * length[own].sum():
                pairs = of[one] == part
                odd[one[pairs]] = odd[other[pairs]] = True
    return odd


def _images(
    ends: F64, of: I32, rows: I64, among: I64, centre: F64, size: F64, axis: int
) -> tuple[I64, I64]:
    """Return which rows have a mirror image among others, and which that is."""
    found: list[tuple[I64, I64]] = []
    for shift in (0.0, 0.5):
        seen = _key(ends, of, rows, centre, size, axis, -1.0, shift)
        there = _key(ends, of, among, centre, size, axis, 1.0, shift)
        first, kind = distinct(np.concatenate([there, seen]))
        place = first[kind[len(among) :]]
        hit = place < len(among)
        found.append((rows[hit], among[place[hit]]))
    return (
        np.concatenate([one for one, _ in found]),
        np.concatenate([other for _, other in found]),
    )


def _key(
    ends: F64, of: I32, rows: I64, centre: F64, size: F64, axis: int, sign: float, shift: float
) -> I64:
    """Return whole numbers that are the same for a line and for the image of its image, (k, 5)."""
    part = of[rows]
    near = _NEAR * size[part][:, None]
    middle = ends[rows].mean(axis=1) - centre[part]
    middle[:, axis] *= sign
    run = np.abs(ends[rows, 1] - ends[rows, 0])
    measures = np.hstack([middle, run]) / near
    return np.column_stack([part, np.floor(measures + shift)]).astype(np.int64)
