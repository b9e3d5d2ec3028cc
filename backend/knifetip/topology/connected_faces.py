"""connected_faces: label faces of a planar graph that are connected by pairs of neighbours."""

from __future__ import annotations

from typing import Any

import numpy as np

from knifetip.geometry.union_find import flatten, union
from knifetip.kernels import I32_2, kernel


@kernel
def label_connected_faces(faces: int, sides: I32_2) -> Any:
    """Return a label of each face, (faces,), which is equal for faces that are connected.

    ``sides`` (k, 2) are k pairs of neighbouring faces.  Two faces are connected if a series of such
    pairs leads from one to the other.  ``faces`` is the number of faces.
    """
    parent = np.arange(faces)
    for k in range(len(sides)):
        union(parent, sides[k, 0], sides[k, 1])
    flatten(parent)
    return parent
