"""connectivity: find decided cuts that would separate a panel from its blank.

    ShapeFeatures, line types -> which cuts separate a panel

A blank must stay in one piece when it has been cut.  A slit between two flaps leaves both of them
attached by their creases.  A cut between two panels of which the outer one is attached by no fold
was meant as a fold, or was drawn on the wrong layer.  What falls out of the middle of a blank is
a hole, and may fall out.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import U8, Bool
from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import I32_2, kernel
from knifetip.model.dieline import LineType

#: A piece with less than this share of the other's area is a separated panel; two larger pieces are
#: two blanks that share a cut.
_MAX_AREA_SHARE: Final = 0.35


def find_separating_cuts(features: ShapeFeatures, line_type: U8) -> Bool:
    """Return which cuts would separate a panel at the rim from its blank, (n,).

    Parameters
    ----------
    line_type : (n,)
        LineType as decided so far.  Undecided edges keep panels together like folds.
    """
    divider = features.role == Role.DIVIDER
    cut = divider & (line_type == LineType.CUT)
    if not cut.any():
        return np.zeros(len(line_type), np.bool_)
    faces = len(features.face_area)
    uncut_sides = features.faces[divider & ~cut]
    piece = _label_connected_faces(faces, uncut_sides)
    rim = np.zeros(faces, np.bool_)
    rim[features.faces[features.role == Role.OUTLINE].ravel()] = True
    rim &= features.face_area > 0.0
    area = np.bincount(piece, np.maximum(features.face_area, 0.0), faces)
    at_rim = np.bincount(piece[rim], minlength=faces) > 0
    left, right = piece[features.faces[cut]].T
    smaller = np.where(area[left] < area[right], left, right)
    larger = np.where(area[left] < area[right], right, left)
    has_fold = np.bincount(piece[uncut_sides.ravel()], minlength=faces) > 0
    separating: Bool = np.zeros(len(line_type), np.bool_)
    separating[cut] = (
        (left != right)
        & at_rim[smaller]
        & has_fold[larger]
        & (area[smaller] < _MAX_AREA_SHARE * area[larger])
    )
    return separating


@kernel
def _label_connected_faces(faces: int, sides: I32_2) -> Any:
    """Return a label of each face, (faces,), equal where pairs of ``sides``, (k, 2), connect it."""
    parent = np.arange(faces)
    for k in range(len(sides)):
        union(parent, sides[k, 0], sides[k, 1])
    flatten(parent)
    return parent
