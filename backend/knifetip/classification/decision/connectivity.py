"""connectivity: find cuts that would separate a panel from its blank.

A blank must remain in one piece when it has been cut.  A slit between two flaps leaves both flaps
attached by their creases.  If a cut runs between two panels, and no fold attaches the outer panel
to the blank, the cut was meant as a fold or was drawn on the wrong layer.  A piece that falls out
of the middle of a blank is a hole, and is permitted.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import U8, Bool
from knifetip.model.dieline import LineType
from knifetip.topology.connected_faces import label_connected_faces

#: A piece with less than this fraction of the area of the other piece is a separated panel; two
#: pieces of more equal area are two blanks with a common cut.
_MAX_AREA_FRACTION: Final = 0.35


def find_separating_cuts(features: ShapeFeatures, line_type: U8) -> Bool:
    """Return the mask of cuts that would separate a panel at the outline from its blank, (n,).

    Parameters
    ----------
    features
        Shape features of n edges.
    line_type : (n,)
        ``LineType`` of each edge as decided so far.  Unclassified edges keep panels together, as
        folds do.
    """
    divider = features.role == Role.DIVIDER
    cut = divider & (line_type == LineType.CUT)
    if not cut.any():
        return np.zeros(len(line_type), np.bool_)
    faces = len(features.face_area)
    # A slit may begin at a fold, which then attaches panels on both sides of the slit.
    edge, sides = features.further_faces[:, 0], features.further_faces[:, 1:]
    inside = (features.face_area[sides] > 0.0).all(axis=1)
    uncut_sides = np.concatenate(
        [features.faces[divider & ~cut], sides[inside & (divider & ~cut)[edge]]]
    )
    piece = label_connected_faces(faces, uncut_sides)
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
        & (area[smaller] < _MAX_AREA_FRACTION * area[larger])
    )
    return separating
