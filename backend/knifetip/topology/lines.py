"""lines: the record of a drawing's edges from which the planar graph is built."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.kernels import F64_1, F64_3, I32_1
from knifetip.topology.edge_grid import EdgeGrid


class Lines(NamedTuple):
    """The n edges of a drawing, the vertices at their ends, and a grid to find nearby edges."""

    ends: F64_3  #: (n, 2, 2) start and end point of each edge
    bulge: F64_1  #: (n,) tan(sweep / 4) of each edge
    end_vertex: I32_1  #: (2n,) vertices of start (2 i) and end (2 i + 1) of each edge i
    twin: I32_1  #: (n,) first edge that coincides with each edge; the edge itself if none does
    grid: EdgeGrid
    tolerance: float  #: ends nearer than this are one vertex (drawing units)
    unit: float  #: number of drawing units in one millimetre
