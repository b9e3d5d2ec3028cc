"""lines: the edges of a drawing while their planar graph is built."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.geometry.columns import F64, I32
from knifetip.topology.edge_grid import EdgeGrid


class Lines(NamedTuple):
    """n edges, and what is known of them before they are split."""

    ends: F64  #: (n, 2, 2)
    bulge: F64  #: (n,)
    end_vertex: I32  #: (2n,) vertex of each end
    twin: I32  #: (n,) first edge that coincides with each, or the edge itself
    grid: EdgeGrid
    tolerance: float  #: ends nearer than this are one vertex
    unit: float  #: one millimetre in file units
