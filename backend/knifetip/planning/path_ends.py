"""path_ends: chain edges into paths, and find the positions, directions and kinds of their ends.

In all arrays of the 2p ends of p paths, the starts come first, then the finishes.
"""

from __future__ import annotations

import numpy as np

from knifetip.geometry import arc
from knifetip.geometry.chain import chain, outward_directions
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.geometry.tolerance import JOIN
from knifetip.model.dieline import Dieline
from knifetip.model.operation import End


def chain_edges(
    dieline: Dieline, rows: I32, kink: float, group: I64 | None = None
) -> tuple[Paths, I32]:
    """Chain edges of a dieline into paths; return the paths, and the index in the dieline of the
    edge of each segment.

    Parameters
    ----------
    rows : (m,)
        Indices of the edges in the dieline.
    kink : degrees
        Two edges are not chained if the path would turn by more than this angle between them.
    group : (m,)
        Number of the group of each edge.  Edges of different groups are not chained.  If it is
        None, all edges are one group.
    """
    chains = chain(dieline.ends[rows], dieline.bulge[rows], kink, group=group)
    paths = close_joints(chains.paths(dieline.ends[rows], dieline.bulge[rows]))
    return paths, rows[chains.order]


def close_joints(paths: Paths) -> Paths:
    """Return the paths without the small gaps that the drawing leaves between segments.

    Each segment ends exactly at the start of the next one.  A path whose start and end are less
    than ``JOIN`` mm apart is closed.  The longer of two segments is moved, as this turns it less: a
    knife must follow the direction in which a short edge is drawn.
    """
    start, end = paths.start.copy(), paths.end.copy()
    first, last = paths.first[:-1], paths.first[1:] - 1
    following = np.arange(1, len(end) + 1)
    # A line to a point and back ends where it started, but is no contour.
    gap = np.hypot(*(paths.start[first] - paths.end[last]).T)
    near = (gap < JOIN) & ((last > first + 1) | (np.abs(paths.bulge[first]) > 0.0))
    following[last] = np.where(near, first, -1)
    before = np.flatnonzero(following >= 0)
    after = following[before]
    size = arc.length(paths.start, paths.end, paths.bulge)
    moves_start = size[before] < size[after]
    start[after[moves_start]] = paths.end[before[moves_start]]
    end[before[~moves_start]] = paths.start[after[~moves_start]]
    return Paths(start, end, paths.bulge, paths.first)


def end_points(paths: Paths) -> tuple[F64, I32]:
    """Return the ends of p paths, (2p, 2) mm, and the index of the segment at each end, (2p,).

    The starts of all paths come first, then the finishes.
    """
    begin, finish = paths.first[:-1], paths.first[1:] - 1
    points = np.concatenate([paths.start[begin], paths.end[finish]])
    return points, np.concatenate([begin, finish]).astype(np.int32)


def end_directions(paths: Paths) -> F64:
    """Return the unit vector that points into the path at each end of p paths, (2p, 2).

    The starts of all paths come first, then the finishes.
    """
    _, segment = end_points(paths)
    side = np.repeat([0, 1], len(paths))
    segments = np.stack([paths.start, paths.end], axis=1)
    directions: F64 = outward_directions(segments, paths.bulge)[segment, side]
    return directions


def end_kinds(paths: Paths, marked: Bool, kind: End) -> tuple[U8, U8]:
    """Return the kinds of the starts and of the finishes of p paths, (p,) and (p,).

    Both ends of a closed path have the kind ``End.CLOSED``.  An end of an open path has the kind
    ``kind`` if the mask ``marked`` is true for it, else ``End.FREE``.  The mask, (2p,), has the
    starts of all paths first, then the finishes.
    """
    kinds = np.where(marked, kind, End.FREE)
    start, finish = np.split(np.where(np.tile(paths.closed, 2), End.CLOSED, kinds), 2)
    return start.astype(np.uint8), finish.astype(np.uint8)
