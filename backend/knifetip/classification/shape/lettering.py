"""lettering: find letters of texts that were converted to lines.

Letters are small components in a row, at the distances of letters and with different shapes.  A row
of small components with equal shapes is not a word but, for example, a row of holes.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.kernels import F64_2, I64_1, OutBool_1, kernel

#: Greatest height and width of a letter (mm).
_LARGEST: Final = 25.0
#: Least number of different shapes in a word.
_FEWEST_SHAPES: Final = 3
#: Largest number of small components of a drawing that is searched.
_MOST_PARTS: Final = 20_000
#: Number of following components among which the next letter is searched.
_LOOKAHEAD: Final = 40


def find_letters(box: F64, length: F64, pieces: I64, unit: float) -> Bool:
    """Return the mask of components that are letters of texts drawn as lines, (c,).

    A component is a set of connected edges; its edges are divided into pieces where they meet.

    Parameters
    ----------
    box : (c, 4)
        Bounding box of each component: x min, y min, x max, y max.
    length : (c,)
        Total length of the pieces of each component.
    pieces : (c,)
        Number of pieces of each component.
    unit
        Number of drawing units in a millimetre.
    """
    count = len(box)
    found = np.zeros(count, np.bool_)
    width, height = box[:, 2] - box[:, 0], box[:, 3] - box[:, 1]
    size = np.maximum(width, height)
    small = np.flatnonzero((size <= _LARGEST * unit) & (size > 0.5 * unit))
    if not _FEWEST_SHAPES <= len(small) <= _MOST_PARTS:
        return found
    shape = np.column_stack([np.minimum(width, height), size, length, pieces])[small]
    letter = np.zeros(len(small), np.bool_)
    for axis in range(2):
        order = np.argsort(box[small, axis], kind="stable")
        _mark_words(box[small], shape, order, axis, letter)
    found[small[letter]] = True
    return found


@kernel
def _mark_words(box: F64_2, shape: F64_2, order: I64_1, axis: int, letter: OutBool_1) -> None:
    """Mark the components that form words: rows along an axis with enough different shapes.

    ``box`` (k, 4): bounding boxes of k small components.
    ``shape`` (k, 4): shorter side, longer side, total edge length and number of edge pieces of each
    component.
    ``order`` (k,): the components sorted by the least coordinate of their boxes along the axis.
    ``axis``: direction of the rows: 0 for x, 1 for y.
    ``letter`` (k,): set to True for the components of words.
    """
    across = 1 - axis
    count = len(order)
    following = np.full(count, -1, np.int64)
    has_predecessor = np.zeros(count, np.bool_)
    for k in range(count):
        i = order[k]
        height = max(box[i, across + 2] - box[i, across], shape[i, 1])
        for m in range(k + 1, min(k + _LOOKAHEAD, count)):
            j = order[m]
            if box[j, axis] - box[i, axis + 2] > 1.0 * height:
                break
            overlap = min(box[i, across + 2], box[j, across + 2]) - max(
                box[i, across], box[j, across]
            )
            similar_size = 0.4 * shape[i, 1] <= shape[j, 1] <= 2.5 * shape[i, 1]
            if overlap >= 0.3 * shape[i, 1] and similar_size and box[j, axis] > box[i, axis]:
                following[i] = j
                has_predecessor[j] = True
                break
    for k in range(count):
        head = order[k]
        if has_predecessor[head]:
            continue
        different_shapes = 0
        i = head
        while i >= 0:
            new = True
            j = head
            while j != i:
                same = True
                for n in range(4):
                    if abs(shape[i, n] - shape[j, n]) > 0.02 * max(shape[i, n], shape[j, n]):
                        same = False
                if same:
                    new = False
                    break
                j = following[j]
            different_shapes += new
            i = following[i]
        i = head
        while i >= 0:
            if different_shapes >= _FEWEST_SHAPES:
                letter[i] = True
            i = following[i]
