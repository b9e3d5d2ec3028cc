"""open_corners: find boxes whose walls are attached to the bottom only, without glue tabs.

The walls of a folding carton are held by glue tabs or locks at its corners.  A cross of a bottom
and four walls has none: it is a rigid box of grooved board, or a creased tray whose corners are
taped.  The same holds for a rectangle with two folds across two other folds, whose corners are cut
out after folding.  The shape of such a blank does not show whether its folds are creases or
V-grooves.
"""

from __future__ import annotations

import numpy as np

from knifetip.classification.shape.features import ShapeFeatures
from knifetip.classification.shape.roles import Role
from knifetip.geometry.columns import I32, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.topology.connected_faces import label_connected_faces

#: Panels, and pairs of panels with a common fold, of a cross and of a rectangle with four folds.
_CROSS = (5, 4)
_GRID = (9, 12)


def find_open_corner_folds(features: ShapeFeatures, folds: Bool, uncut: Bool) -> Bool:
    """Return the mask of the folds of boxes without glue tabs, (n,).

    Parameters
    ----------
    features
        Shape features of n edges.
    folds : (n,)
        Mask of the folds of one style.
    uncut : (n,)
        Mask of the edges of all styles that are not cut.  Such edges of other styles may divide a
        panel, as a fold in the bottom does.
    """
    left, right = features.faces.T
    divides = (features.role == Role.DIVIDER) & (left != right)
    folds = folds & divides & (features.face_area[left] > 0.0) & (features.face_area[right] > 0.0)
    result = np.zeros(len(folds), np.bool_)
    if not folds.any():
        return result
    count = len(features.face_area)
    others = features.faces[divides & uncut & ~folds]
    panel = label_connected_faces(count, others)
    sides: I32 = np.sort(panel[features.faces[folds]], axis=1)
    pairs = sides[unique_rows(*sides.T)[0]]
    pairs = pairs[pairs[:, 0] != pairs[:, 1]]
    blank = label_connected_faces(count, pairs.astype(np.int32))
    links = np.bincount(pairs.ravel(), minlength=count)
    panels = np.bincount(blank[links > 0], minlength=count)
    joints = np.bincount(blank[pairs[:, 0]], minlength=count)
    most = np.zeros(count, np.int64)
    np.maximum.at(most, blank, links)
    least = np.full(count, count)
    np.minimum.at(least, blank[links > 0], links[links > 0])
    cross = (panels == _CROSS[0]) & (joints == _CROSS[1]) & (most == 4)
    grid = (panels == _GRID[0]) & (joints == _GRID[1]) & (most == 4) & (least == 2)
    result[folds] = (cross | grid)[blank[sides[:, 0]]]
    return result
