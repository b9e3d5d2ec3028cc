"""apart: a carton hangs together when it has been cut.

    Shape, line types -> which cuts would part a panel from its blank

A slit between two flaps leaves both of them on their creases.  A line between two panels that is
cut, though no fold holds the outer one of them, was meant as a fold, or drawn on the wrong layer.
What falls out of the middle of a blank is a hole and may fall.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.classification.evidence import Shape
from knifetip.classification.role import Role
from knifetip.geometry.columns import U8, Bool
from knifetip.geometry.sets import settle, unite
from knifetip.kernels import I32_2, kernel
from knifetip.model.dieline import LineType

#: What holds less of a blank's area than this has come off; else two blanks share a cut.
_RATHER: Final = 0.35


def parting(shape: Shape, line_type: U8) -> Bool:
    """Return which decided cuts would part a panel at the rim from its blank, (n,).

    Parameters
    ----------
    line_type : (n,)
        As it was decided so far; what is not decided holds panels together like a fold.
    """
    divides = shape.role == Role.DIVIDER
    cut = divides & (line_type == LineType.CUT)
    if not cut.any():
        return np.zeros(len(line_type), np.bool_)
    faces = len(shape.area)
    holding = shape.sides[divides & ~cut]
    sheet = _held(faces, holding)
    rim = np.zeros(faces, np.bool_)
    rim[shape.sides[shape.role == Role.OUTLINE].ravel()] = True
    rim &= shape.area > 0.0
    area = np.bincount(sheet, np.maximum(shape.area, 0.0), faces)
    at_rim = np.bincount(sheet[rim], minlength=faces) > 0
    left, right = sheet[shape.sides[cut]].T
    less = np.where(area[left] < area[right], left, right)
    more = np.where(area[left] < area[right], right, left)
    folded = np.bincount(sheet[holding.ravel()], minlength=faces) > 0
    off: Bool = np.zeros(len(line_type), np.bool_)
    off[cut] = (left != right) & at_rim[less] & folded[more] & (area[less] < _RATHER * area[more])
    return off


@kernel
def _held(faces: int, holding: I32_2) -> Any:
    """Number the faces by what they hang together with."""
    parent = np.arange(faces)
    for k in range(len(holding)):
        unite(parent, holding[k, 0], holding[k, 1])
    settle(parent)
    return parent
