"""rank: of two edges that lie on each other, which one stays.

The work that takes more of the board apart stays, because it does what the other one asks for or
leaves nothing of it to do:

* a cut goes through: what lies under it is cut through anyway, and a cut drawn on a crease cuts;
* a V-groove takes the board away that a crease would press and a half-cut would slit;
* a combi line is creased and perforated, so it holds both;
* a perforation goes through where a half-cut slits;
* a half-cut opens the face that a crease would press.

A crease and a perforation hide nothing of each other: both are worked, and together they are what a
combi line is.  Edges that are ignored or not classified are no work: they hide nothing, and
nothing hides them.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import I32, Bool
from knifetip.model.dieline import LineType

_ORDER: Final = (
    LineType.CREASE,
    LineType.HALF_CUT,
    LineType.PERFORATION,
    LineType.COMBI,
    LineType.V_GROOVE,
    LineType.CUT,
)

#: (types,) the rank of each line type, 0 for what is no work.
RANK: Final[I32] = np.zeros(len(LineType), np.int32)
RANK[[kind.value for kind in _ORDER]] = np.arange(1, len(_ORDER) + 1)

#: (types, types) whether an edge of the first type hides one of the second that lies on it.
HIDES: Final[Bool] = (RANK[:, None] >= RANK) & (RANK > 0)
HIDES[LineType.PERFORATION, LineType.CREASE] = False
