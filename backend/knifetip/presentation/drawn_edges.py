"""The columns of edges that a picture needs, a fifth of the bytes of all columns.

Coordinates are float32 about the centre of the drawing, which is what a graphics card computes
with: a drawing of 2 m has steps of 0.0001 mm.  Measuring and snapping need the float64 columns.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.presentation.columns import pack_columns, unpack_columns

#: Number of edges from which a picture is drawn before all columns are there.
MANY_EDGES: Final = 50_000


def pack_drawn_edges(block: bytes) -> bytes:
    """Return the columns that a picture of the edges of a packed ``EdgeTable`` needs.

    Returns
    -------
    bytes
        A block in the layout of ``presentation.columns``.  Its columns are ``ends`` (n, 2, 2) and
        ``bulge`` (n,) in float32, and ``line_type`` and ``outcome`` (n,) in uint8.  Its metadata
        are ``origin``, the point in mm to which the ends are relative.
    """
    columns, _ = unpack_columns(block)
    ends = columns["ends"].reshape(-1, 2)
    origin = (ends.min(0) + ends.max(0)) / 2.0 if len(ends) else np.zeros(2)
    drawn = {
        "ends": (ends - origin).astype(np.float32).reshape(-1, 2, 2),
        "bulge": columns["bulge"].astype(np.float32),
        "line_type": columns["line_type"].astype(np.uint8),
        "outcome": columns["outcome"].astype(np.uint8),
    }
    return pack_columns(drawn, {"origin": origin.tolist()})
