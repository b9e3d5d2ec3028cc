"""motion: where the panels lie when their folds have turned by a fraction of their angles.

The transform of a panel is that of its parent times a turn about the axis of their fold:
W = W' · T(p) · R(u, φ) · T(-p), with a point p of the axis, its direction u and the angle φ.
R is the rotation by the formula of Rodrigues.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.folding.records import Fold, FoldTree
from knifetip.geometry.columns import F64


def panel_transforms(tree: FoldTree, fractions: F64) -> F64:
    """Return the transform of each of n panels for each of f fractions, (f, n, 4, 4).

    A transform takes a point (x, y, z, 1) of the flat board (mm) to its place.

    Parameters
    ----------
    tree
        The fold tree.
    fractions : (f,)
        Share of its angle by which each fold has turned, 0 … 1.
    """
    placed = np.tile(np.eye(4), (len(fractions), len(tree.panels), 1, 1))
    for number in tree.order:
        fold = tree.folds[number]
        placed[:, fold.child] = placed[:, fold.parent] @ fold_turns(fold, fractions)
    return placed


def fold_turns(fold: Fold, fractions: F64) -> F64:
    """Return the turn of a fold about its axis in the flat board for f fractions, (f, 4, 4)."""
    start, end = fold.axis
    u = (end - start) / np.linalg.norm(end - start)
    cross = np.array([[0.0, -u[2], u[1]], [u[2], 0.0, -u[0]], [-u[1], u[0], 0.0]])
    angle = math.radians(fold.angle) * fractions[:, None, None]
    turn = np.eye(3) + np.sin(angle) * cross + (1.0 - np.cos(angle)) * (cross @ cross)
    placed = np.tile(np.eye(4), (len(fractions), 1, 1))
    placed[:, :3, :3] = turn
    placed[:, :3, 3] = start - turn @ start
    return placed
