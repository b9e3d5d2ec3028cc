"""priority: rules that decide which of two coincident edges is kept.

The edge that removes or separates more board is kept if its operation includes the operation of the
other edge or makes it ineffective:

* a cut goes through the board: a crease or half-cut at the same position has no effect;
* a V-groove removes the board that a crease would press and a half-cut would slit;
* a combi line is creased and perforated, so it includes a crease and a perforation;
* a perforation goes through the board that a half-cut would slit;
* a half-cut opens the surface that a crease would press.

Of a crease and a perforation both are kept, and together they are a combi line.  Ignored and
unclassified edges are neither cut nor creased, so no edge is removed because of them, and they are
not removed because of other edges.
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

#: (types,) priority of each line type, 0 for types that no tool makes.
PRIORITY: Final[I32] = np.zeros(len(LineType), np.int32)
PRIORITY[[kind.value for kind in _ORDER]] = np.arange(1, len(_ORDER) + 1)

#: (types, types) whether an edge of the first type covers a coincident edge of the second type.
COVERS: Final[Bool] = (PRIORITY[:, None] >= PRIORITY) & (PRIORITY > 0)
COVERS[LineType.PERFORATION, LineType.CREASE] = False
