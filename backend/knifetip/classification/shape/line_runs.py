"""line_runs: join lines and arcs that a program wrote in many pieces of one length.

Some programs divide each line and arc into pieces, for example of 3 mm.  A carton has the same
shape with whole lines, so the pieces of a line are examined as one line.  They remain edges of the
drawing.  A run of pieces is recognised only in the order of the file: each piece has the style of
the one before, begins where it ends, and continues it in the same direction or on the same arc.
All pieces of a run have one length; the last one may be shorter.  A run ends where another line
begins or ends, because there a fold may continue as the side of a flap.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.unique_rows import unique_rows
from knifetip.kernels import F64_1, F64_3, I64_1, Bool_1, kernel

#: Fewest pieces of a run; an author may also draw a few equal lines, such as the sides of panels.
_FEWEST: Final = 5
#: Fewest pieces where other lines of the drawing are in pieces that are at least as long.
_FEWEST_AMONG_RUNS: Final = 2
#: Greatest difference between the lengths and bulges of the pieces of a run, as a fraction.
_LENGTH_TOLERANCE: Final = 0.001
#: Greatest sine of the angle between a piece and the direction in which the run continues.
_SINE: Final = 0.001
#: Greatest distance between two pieces of a run, as a fraction of their length.
_GAP: Final = 0.001


class LineRuns(NamedTuple):
    """The lines and arcs of which the n edges of a drawing are pieces."""

    ends: F64  #: (m, 2, 2) ends of each line or arc
    bulge: F64  #: (m,)
    row: I64  #: (n,) line or arc of each edge
    first: I64  #: (m,) first edge of each line or arc


def join_runs(ends: F64, bulge: F64, style: I64) -> LineRuns | None:
    """Return the lines and arcs of which edges are pieces; None if no edge is a piece.

    Parameters
    ----------
    ends, bulge, style : (n, 2, 2), (n,) and (n,)
        Ends, bulges and styles of the edges, in the order of the file.
    """
    if len(bulge) < _FEWEST:
        return None
    no_joints = np.zeros(len(bulge), np.bool_)
    first = _find_first(ends, bulge, style, no_joints, 0.0)
    if len(first) == len(bulge):
        return None
    pieces = first[_last_edges(first, len(bulge)) > first]
    longest = float(np.hypot(*(ends[pieces, 1] - ends[pieces, 0]).T).max())
    known = (1.0 + _LENGTH_TOLERANCE) * longest
    first = _find_first(ends, bulge, style, no_joints, known)
    last = _last_edges(first, len(bulge))
    joint = _find_joints(ends, np.concatenate([ends[first, 0], ends[last, 1]]), _GAP * longest)
    first = _find_first(ends, bulge, style, joint, known)
    last = _last_edges(first, len(bulge))
    is_first = np.zeros(len(bulge), np.int64)
    is_first[first] = 1
    joined = np.stack([ends[first, 0], ends[last, 1]], axis=1)
    whole = np.tan((last - first + 1) * np.arctan(bulge[first]))
    return LineRuns(joined, whole, np.cumsum(is_first) - 1, first)


def _last_edges(first: I64, count: int) -> I64:
    """Return the last of ``count`` edges of each line, given the first edges of lines, (m,)."""
    return np.append(first[1:], count) - 1


def _find_joints(ends: F64, line_ends: F64, tolerance: float) -> Bool:
    """Return the mask of the n edges whose start is an end of a line, (n,).

    ``ends`` (n, 2, 2): ends of the edges.
    ``line_ends`` (k, 2): ends of the lines of which the edges are pieces.
    ``tolerance``: points that are nearer to each other than this count as one, except at borders of
    a grid.
    """
    points = np.concatenate([ends[:, 0], line_ends])
    first, cell = unique_rows(np.round(points / tolerance).astype(np.int64))
    has_end = np.zeros(len(first), np.bool_)
    has_end[cell[len(ends) :]] = True
    joint: Bool = has_end[cell[: len(ends)]]
    return joint


@kernel
def _find_first(ends: F64_3, bulge: F64_1, style: I64_1, joint: Bool_1, known: float) -> Any:
    """Return the first edge of each line or arc, (m,); most lines and arcs are one edge.

    ``ends``, ``bulge``, ``style`` (n, 2, 2), (n,) and (n,): ends, bulges and styles of the edges.
    ``joint`` (n,): whether a line begins or ends at the start of each edge.
    ``known``: greatest length of pieces of which a few are enough for a run.
    """
    count = len(bulge)
    first = np.empty(count, np.int64)
    found = 0
    i = 0
    while i < count:
        x, y = ends[i, 1, 0] - ends[i, 0, 0], ends[i, 1, 1] - ends[i, 0, 1]
        length = math.sqrt(x * x + y * y)
        j = i + 1
        while j < count and style[j] == style[i] and length > 0.0:
            near = _GAP * length
            if joint[j]:
                break
            if abs(ends[j, 0, 0] - ends[j - 1, 1, 0]) > near:
                break
            if abs(ends[j, 0, 1] - ends[j - 1, 1, 1]) > near:
                break
            if abs(bulge[j] - bulge[i]) > _LENGTH_TOLERANCE * abs(bulge[i]):
                break
            # An arc is joined up to half a turn.
            sweep = 4.0 * math.atan(bulge[i])
            if abs(sweep) * (j - i + 1) > math.pi:
                break
            u, v = ends[j, 1, 0] - ends[j, 0, 0], ends[j, 1, 1] - ends[j, 0, 1]
            own = math.sqrt(u * u + v * v)
            c, s = math.cos(sweep * (j - i)), math.sin(sweep * (j - i))
            a, b = c * x - s * y, s * x + c * y
            tolerance = _SINE * length * own + near * length
            if a * u + b * v <= 0.0 or abs(a * v - b * u) > tolerance:
                break
            if own > (1.0 + _LENGTH_TOLERANCE) * length:
                break
            shorter = own < (1.0 - _LENGTH_TOLERANCE) * length
            if shorter and bulge[i] != 0.0:
                break
            j += 1
            if shorter:
                break
        if j - i < (_FEWEST_AMONG_RUNS if length <= known else _FEWEST):
            j = i + 1
        first[found] = i
        found += 1
        i = j
    return first[:found]
