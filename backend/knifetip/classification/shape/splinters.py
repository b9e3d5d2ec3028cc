"""splinters: find narrow triangles between lines that meet at a small angle.

They lie where the outline of one flap crosses that of its neighbour, and are no panels.
"""

from __future__ import annotations

from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, I32_1, kernel

#: Greatest area of a splinter, as a fraction of the square of its longest side.
_MAX_AREA: Final = 0.1
_SIDES: Final = 3


@kernel
def find_splinters(left: I32_1, right: I32_1, twin: I32_1, length: F64_1, area: F64_1) -> Any:
    """Return the mask of the faces that are narrow triangles, (f,).

    Parameters
    ----------
    left, right, twin, length : (p,) each
        Faces on the left and right of each piece, the first piece that coincides with it, and its
        length.
    area : (f,)
        Signed area of each face.
    """
    sides = np.zeros(len(area), np.int32)
    longest = np.zeros(len(area))
    for p in range(len(left)):
        if twin[p] == p:
            for face in (left[p], right[p]):
                sides[face] += 1
                longest[face] = max(longest[face], length[p])
    splinter = np.zeros(len(area), np.bool_)
    for f in range(len(area)):
        splinter[f] = sides[f] == _SIDES and 0.0 < area[f] < _MAX_AREA * longest[f] * longest[f]
    return splinter
