"""lines: the record of a drawing's edges from which the planar graph is built."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.geometry.columns import F64, I32
from knifetip.topology.edge_grid import EdgeGrid


class Lines(NamedTuple):
    """The n edges of a drawing, the vertices at their ends, and a grid to find nearby edges."""

    ends: F64  #: (n, 2, 2) start and end point of each edge
    bulge: F64  #: (n,) tan(sweep / 4) of each edge
    end_vertex: I32  #: (2n,) vertices of start and end of each edge
    twin: I32  #: (n,) first edge that coincides with each edge; the edge itself if none does
    grid: EdgeGrid
    tolerance: float  #: ends nearer than this are one vertex
    unit: float  #: number of drawing units in one millimetre
