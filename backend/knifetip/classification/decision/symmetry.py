"""symmetry: find cuts whose mirror image is a fold.

A line between two panels may be a fold or a slit, and often only its layer distinguishes the two.
If a blank is its own mirror image, and such a line is cut while its image is folded, one of the two
lines was drawn on the wrong layer.
"""

from __future__ import annotations

from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.decision.conventions import FOLD_TYPES
from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.model.dieline import LineType

#: Lines nearer to each other than this fraction of the blank's size count as the same line.
_TOLERANCE: Final = 1.0 / 500.0
#: Whether each line type is a fold, as a table, which is faster than ``numpy.isin``.
_IS_FOLD: Final = np.isin(np.arange(256), FOLD_TYPES)
#: A blank is symmetrical if at least this fraction of its length has a mirror image.
_MIN_MIRRORED: Final = 0.9
#: Largest number of blanks that are checked.
_MOST_BLANKS: Final = 50


class _Blanks(NamedTuple):
    """Edges and blanks of a drawing, for the search of mirror images.

    The record contains the ends and the blank of each of n edges, and centre and size of b blanks.
    """

    ends: F64  #: (n, 2, 2) ends of each edge
    blank: I32  #: (n,) number of the blank, -1 for none
    centre: F64  #: (b, 2) centre of each blank's bounding box
    size: F64  #: (b,) longer side of each blank's bounding box


def find_asymmetric_edges(ends: F64, features: ShapeFeatures, line_type: U8, length: F64) -> Bool:
    """Return the mask of edges that are cut and whose mirror image is folded, or the reverse, (n,).

    Parameters
    ----------
    ends, length : (n, 2, 2) and (n,)
        Ends and length of each edge.
    features
        Shape features of the edges.
    line_type : (n,)
        LineType as decided so far.
    """
    found = np.zeros(len(ends), np.bool_)
    divider = features.role == Role.DIVIDER
    cut = np.flatnonzero(divider & (line_type == LineType.CUT))
    fold = np.flatnonzero(divider & _IS_FOLD[line_type])
    if len(cut) == 0 or len(fold) == 0:
        return found
    blanks = _blanks_of(ends, features.component, cut)
    rows = np.flatnonzero(blanks.blank >= 0)
    fold = fold[blanks.blank[fold] >= 0]
    for axis in range(2):
        cuts, folds = _mirror_pairs(blanks, cut, fold, axis)
        for number in np.unique(blanks.blank[cuts])[:_MOST_BLANKS].tolist():
            own = rows[blanks.blank[rows] == number]
            mirrored, _ = _mirror_pairs(blanks, own, own, axis)
            if length[np.unique(mirrored)].sum() >= _MIN_MIRRORED * length[own].sum():
                pairs = blanks.blank[cuts] == number
                found[cuts[pairs]] = found[folds[pairs]] = True
    return found


def _blanks_of(ends: F64, component: I32, cut_edges: I64) -> _Blanks:
    """Return the blanks that contain at least one of the edges with the indices ``cut_edges``.

    ``ends`` (n, 2, 2) and ``component`` (n,) are the ends and the connected component of each edge;
    each component is a blank.
    """
    number = np.full(int(component.max()) + 2, -1, np.int32)
    number[component[cut_edges]] = 0
    wanted = np.flatnonzero(number == 0)
    number[wanted] = np.arange(len(wanted), dtype=np.int32)
    blank = number[component]
    rows = np.flatnonzero(blank >= 0)
    box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (len(wanted), 1))
    points = ends[rows].reshape(-1, 2)
    owner = np.repeat(blank[rows], 2)
    np.minimum.at(box[:, :2], owner, points)
    np.maximum.at(box[:, 2:], owner, points)
    size = np.maximum(box[:, 2] - box[:, 0], box[:, 3] - box[:, 1])
    return _Blanks(ends, blank, 0.5 * (box[:, :2] + box[:, 2:]), size)


def _mirror_pairs(blanks: _Blanks, rows: I64, candidates: I64, axis: int) -> tuple[I64, I64]:
    """Return pairs of edges that are mirror images of each other, as two arrays (k,) and (k,).

    The first array has edges from ``rows``, the second array their images from ``candidates``; all
    are indices of edges.  ``axis`` is 0 for images with opposite x and 1 for images with opposite
    y, relative to the centre of the blank.  ``blanks`` are the edges and the blanks of the drawing.
    """
    found: list[tuple[I64, I64]] = []
    # Two grids, half a cell apart: lines near a border of one are inside a cell of the other.
    for shift in (0.0, 0.5):
        mirrored = _position_keys(blanks, rows, axis, -1.0, shift)
        plain = _position_keys(blanks, candidates, axis, 1.0, shift)
        first, key = unique_rows(np.concatenate([plain, mirrored]))
        image = first[key[len(candidates) :]]
        hit = image < len(candidates)
        found.append((rows[hit], candidates[image[hit]]))
    return (
        np.concatenate([row for row, _ in found]),
        np.concatenate([image for _, image in found]),
    )


def _position_keys(blanks: _Blanks, rows: I64, axis: int, sign: float, shift: float) -> I64:
    """Return integers that describe the position of each edge with an index in ``rows``, (k, 5).

    The columns are the number of the edge's blank, x and y of the edge's middle relative to the
    centre of the blank, and the edge's extent in x and in y.  The coordinates are rounded down to
    cells of a grid.  Before rounding, one coordinate of the middle (x if ``axis`` is 0, y if it is
    1) is multiplied by ``sign``.  An edge with ``sign`` 1 and its mirror image with ``sign`` -1
    therefore get equal integers.  ``shift``, a fraction of a cell, is added before rounding, so
    that positions on the border of two cells can be compared too.
    """
    blank = blanks.blank[rows]
    tolerance = _TOLERANCE * blanks.size[blank][:, None]
    middle = blanks.ends[rows].mean(axis=1) - blanks.centre[blank]
    middle[:, axis] *= sign
    extent = np.abs(blanks.ends[rows, 1] - blanks.ends[rows, 0])
    measures = np.hstack([middle, extent]) / tolerance
    return np.column_stack([blank, np.floor(measures + shift)]).astype(np.int64)
