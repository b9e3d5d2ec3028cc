"""Find the edges that may have another line beside them, without a comparison of their points.

``near_lines`` compares points along edges with all other edges.  Most drawings have few edges for
which this can find anything; this module selects them.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_1, F64_2, I32_1, inline_kernel, kernel
from knifetip.verification.columns import F64, Bool
from knifetip.verification.curves.curve_grid import CurveGrid, cells_near_curve
from knifetip.verification.expectation.edges import Edges

#: Rounding error of the sine of an angle.
_ROUNDING: Final = 1e-6


class _Lines(NamedTuple):
    """n edges, and the distance at which they count as near."""

    line_type: I32_1  #: (n,)
    ends: F64_2  #: (2n, 2) mm
    limits: F64_2  #: (t, t) mm, for each pair of line types; 0 if they are not compared
    widest: F64_1  #: (t,) mm, the greatest limit of each line type
    touch: float  #: mm, ends within this distance are common
    alongside: float  #: sine of the greatest angle between lines side by side


def edges_beside(edges: Edges, limits: F64, touch: float, alongside: float) -> Bool:
    """Return the mask of those of n ≥ 1 edges that may have another edge beside them, (n,).

    Another edge that is beside an edge lies on a normal of it, nearer than the limit, and there in
    nearly the same direction.  All such edges are in the mask, and some others near arcs.  Edges
    with a common end do not count.

    Parameters
    ----------
    edges
        The n edges.
    limits : (t, t) mm
        Distance of an edge from another one, for each pair of line types; 0 if they may touch.
    touch : mm
        Ends within this distance are common ends.
    alongside : degrees
        Greatest difference in direction of edges side by side.
    """
    lines = _Lines(
        edges.line_type,
        np.ascontiguousarray(edges.ends),
        limits,
        limits.max(axis=1),
        touch,
        math.sin(math.radians(alongside)) + _ROUNDING,
    )
    result: Bool = _find_beside(edges.grid(), lines)
    return result


@kernel
def _find_beside(grid: CurveGrid, lines: _Lines) -> Any:
    """Return the result of ``edges_beside``."""
    curves, count = grid.curves, len(grid.curves)
    found = np.zeros(count, np.bool_)
    met = np.full(count, -1, np.int32)
    cells = np.empty(64, np.int32)
    for edge in range(count):
        reach = lines.widest[lines.line_type[edge]]
        if reach <= 0.0:
            continue
        many = cells_near_curve(curves, edge, reach, grid.layout, cells)
        if many > len(cells):
            cells = np.empty(2 * many, np.int32)
            cells_near_curve(curves, edge, reach, grid.layout, cells)
        for k in range(many):
            for place in range(grid.first[cells[k]], grid.first[cells[k] + 1]):
                other = grid.listed[place]
                if met[other] != edge:
                    met[other] = edge
                    if _may_be_beside(curves, edge, other, lines):
                        found[edge] = True
                        break
            if found[edge]:
                break
    return found


@inline_kernel
def _may_be_beside(curves: F64_2, edge: int, other: int, lines: _Lines) -> bool:
    """Return whether an edge may have another one beside it; see ``edges_beside``."""
    kind = lines.line_type[edge]
    limit = lines.limits[kind, lines.line_type[other]]
    if limit <= 0.0:
        return False
    if curves[edge, 0] != 0.0 or curves[other, 0] != 0.0:
        return not _have_common_end(lines.ends, edge, other, lines.touch)
    if edge == other:
        return False
    ux, uy, length = curves[edge, 3], curves[edge, 4], curves[edge, 5]
    vx, vy, size = curves[other, 3], curves[other, 4], curves[other, 5]
    if abs(ux * vy - uy * vx) > lines.alongside:
        return False
    # The other line from its start to its end, in the coordinates of the edge.
    dx, dy = curves[other, 1] - curves[edge, 1], curves[other, 2] - curves[edge, 2]
    along, beside = dx * ux + dy * uy, ux * dy - uy * dx
    slope, rise = vx * ux + vy * uy, ux * vy - uy * vx
    first, last = along, along + slope * size
    low = max(min(first, last), 0.0) - lines.touch
    high = min(max(first, last), length) + lines.touch
    if low > high:
        return False
    one = beside + rise * (low - along) / slope
    two = beside + rise * (high - along) / slope
    if one * two > 0.0 and min(abs(one), abs(two)) >= limit:
        return False
    return not _have_common_end(lines.ends, edge, other, lines.touch)


@inline_kernel
def _have_common_end(ends: F64_2, edge: int, other: int, touch: float) -> bool:
    """Return whether an end of an edge lies within ``touch`` mm of an end of another one."""
    for one in range(2 * edge, 2 * edge + 2):
        for two in range(2 * other, 2 * other + 2):
            if math.hypot(ends[one, 0] - ends[two, 0], ends[one, 1] - ends[two, 1]) <= touch:
                return True
    return False
