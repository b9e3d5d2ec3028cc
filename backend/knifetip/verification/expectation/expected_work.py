"""Expected depths of creases, cuts and grooves, and the points at which the tip starts and stops.

The rules are derived from the records of board and tools:

* A wheel of radius R at depth δ touches the board over a length s on both sides of its lowest
  point, s² = δ(2R − δ).  At an end at which no other crease continues, it stops before the end by s
  and the board's end clearance.  A crease that is too short for that is pressed at one point, with
  a smaller depth, so that the wheel touches the board only within the crease.
* A blade slanted by α cuts the top face ahead of its tip by h tan α at depth h.  A cut that ends
  inside a panel stops where the cut in the top face reaches the end.  A cut that ends on another
  cut runs past its end if waste lies ahead.  If a panel lies ahead, the tip stops on the other cut.
  A closed cut runs past its own start, unless it starts at a corner at which the knife is lifted.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.curves.near_points import pair_distances
from knifetip.verification.expectation.crease_depth import depth_towards, with_chosen
from knifetip.verification.expectation.edge_paths import EdgePaths, edge_paths, link_ends
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    LIMIT_SLACK,
    STRAIGHT_ANGLE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
)
from knifetip.verification.expectation.waste_ahead import waste_ahead
from knifetip.verification.tools import OperationKind

#: A wheel that would be pressed by this depth or less is not pressed (mm).
_SHALLOWEST_PRESS: Final = 0.01
#: Greatest error of the angle between two edges by rounding (degrees).
_ANGLE_SLACK: Final = 1e-6
#: Greatest difference in direction of grooves that continue each other (degrees).
_COLLINEAR_ANGLE: Final = 0.005


#: Line types of each kind of operation.
WORKED_TYPES: Final[dict[OperationKind, tuple[LineType, ...]]] = {
    OperationKind.CUT: (LineType.CUT, LineType.PERFORATION, LineType.COMBI),
    OperationKind.HALF_CUT: (LineType.HALF_CUT,),
    OperationKind.CREASE: (LineType.CREASE, LineType.COMBI),
    OperationKind.GROOVE: (LineType.V_GROOVE,),
    OperationKind.MILL: (LineType.CUT,),
}


@dataclass(frozen=True, eq=False, slots=True)
class ExpectedCreases:
    """The positions between which the wheel must make n creases, and the depths of presses."""

    edges: Edges
    #: (n,) mm, depth below the top face of a crease that is pressed at one point; NaN for a crease
    #: that is rolled, whose depth follows from its direction (see ``crease_depth``)
    press_depth: F64
    low: F64  #: (n,) mm along the edge at which the tip may begin
    high: F64  #: (n,) mm at which the tip must stop; less than ``low`` if there is no work
    pressed: Bool  #: (n,) the wheel presses the crease at one point
    refused: Bool  #: (n,) not made: too short to roll, and pressing is forbidden or impossible


def expected_creases(
    edges: Edges,
    board: Board,
    wheel: CreaseWheel,
    all_creases: Edges | None = None,
    split_ends: Bool | None = None,
    chosen: F64 | None = None,
) -> ExpectedCreases:
    """Return where the wheel must start and stop on each of n creases, and the depths of presses.

    The depth is measured from the board's top face to the wheel's lowest point.  An end of a crease
    is free if no other crease continues there; the wheel stops before a free end.

    Parameters
    ----------
    edges
        The n creases of one wheel, including combi lines (alternating cuts and creases).
    board, wheel
        Board and wheel, whose records determine depths and positions.
    all_creases
        All creases that may continue at an end, including those of other wheels; None if these are
        only ``edges``.
    split_ends : (2n,)
        Mask of the ends at which a cut splits a crease, which are always free; None for no end.
    chosen : (n,) mm
        Depths that the user has chosen, NaN for the depth of the board; None if there are none.
    """
    if chosen is None:
        chosen = np.full(len(edges), np.nan)
    depth = with_chosen(depth_towards(edges.outward, board), np.repeat(chosen, 2))
    contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    link, _ = link_ends(edges, STRAIGHT_ANGLE)
    if split_ends is not None:
        link[split_ends] = -1
        link[(link >= 0) & split_ends[link]] = -1
    paths = edge_paths(edges, link)
    goes_on = _continued_ends(edges, edges if all_creases is None else all_creases)
    if split_ends is not None:
        goes_on[split_ends] = False
    open_ = paths.first >= 0
    free = [open_ & ~goes_on[np.maximum(end, 0)] for end in (paths.first, paths.last)]
    back = [
        np.where(at_end, contact[np.maximum(end, 0)] + board.end_clearance, 0.0)
        for at_end, end in zip(free, (paths.first, paths.last), strict=True)
    ]
    begin, finish = back[0], paths.length - back[1]
    short = finish - begin <= 1e-5
    low, high = paths.intervals(begin, finish, edges.curve)
    low[short[paths.path]], high[short[paths.path]] = 0.0, -1.0

    press_depth = np.full(len(edges), np.nan)
    pressed = np.zeros(len(edges), np.bool_)
    refused = np.zeros(len(edges), np.bool_)
    short_rows = np.flatnonzero(short)
    if len(short_rows):
        both = free[0][short_rows] & free[1][short_rows]
        size = paths.length[short_rows]
        position = np.where(both, size / 2.0, np.where(free[0][short_rows], size, 0.0))
        half = np.where(both, size / 2.0, size) - board.end_clearance
        row, place = paths.locate(short_rows, position, edges.curve)
        reach = np.clip(half, 0.0, wheel.radius)
        fits = wheel.radius - np.sqrt(wheel.radius**2 - reach**2)
        rolled = depth_towards(azimuth_at(edges.curve[row], place), board)
        rolled = with_chosen(rolled, chosen[row])
        possible = (board.short_crease == "press") & (fits > _SHALLOWEST_PRESS)
        refused[row] = ~possible
        row, place = row[possible], place[possible]
        press_depth[row] = np.minimum(rolled, fits)[possible]
        low[row] = high[row] = place
        pressed[row] = True
    return ExpectedCreases(edges, press_depth, low, high, pressed, refused)


def stop_distance(edges: Edges, board: Board, wheel: CreaseWheel, chosen: F64) -> F64:
    """Return the distance from the free end of each of n straight creases at which the wheel stops,
    (n,) mm: half of its contact length, and the board's end clearance.

    ``chosen`` (n,) mm are the depths that the user has chosen, NaN for the depth of the board.
    """
    depth = with_chosen(depth_towards(edges.chord, board), chosen)
    contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    return np.asarray(contact + board.end_clearance)


def _continued_ends(edges: Edges, all_creases: Edges) -> Bool:
    """Return the mask of the 2n ends of n edges at which a crease continues, (2n,).

    An end is continued if an edge of ``all_creases`` lies less than ``TOUCH_DISTANCE`` from it, has
    the direction of the end at the nearest point, and is there more than ``TOUCH_DISTANCE`` long in
    this direction.  End 2i is the start of edge i, and end 2i + 1 is its end.
    """
    met = all_creases.touched_by_points(edges.ends, TOUCH_DISTANCE)
    end, curve = met.curve, all_creases.curve[met.edge]
    place = np.clip(met.place.mean(axis=1), 0.0, curve[:, 5])
    turn = angle_between(azimuth_at(curve, place), edges.outward[end])
    rest = np.where(turn < 90.0, curve[:, 5] - place, place)
    distance = np.hypot(*(point_at(curve, place) - edges.ends[end]).T)
    continues = (
        (np.minimum(turn, 180.0 - turn) <= STRAIGHT_ANGLE)
        & (distance < TOUCH_DISTANCE - LIMIT_SLACK)
        & (rest > TOUCH_DISTANCE + LIMIT_SLACK)
    )
    result = np.zeros(len(edges.ends), np.bool_)
    result[end[continues]] = True
    return result


@dataclass(frozen=True, eq=False, slots=True)
class KnifeEnds:
    """The points at which a knife should stop, one for each of the 2n ends of n edges."""

    stop: F64  #: (2n, 2) mm in sheet coordinates, NaN if the knife does not stop
    ahead: F64  #: (2n,) degrees, direction in which the knife arrives at the stop
    free: Bool  #: (2n,) the end lies inside a panel
    meets: Bool  #: (2n,) the end lies on another through cut
    overrun: F64  #: (2n,) mm, planned overrun of the tip past the end
    setback: F64  #: (2n,) mm along the path from the stop to a free end, 0 for other ends
    #: (n,) the free end of the stub on which each edge lies, -1 for none; the tip can cut a stub
    #: from this end, but not towards it
    stub_end: I64
    paths: EdgePaths


def knife_ends(
    edges: Edges,
    cuts: Edges,
    lead: float,
    overrun: float,
    ring: Bool | None = None,
    swivel: float = 180.0,
) -> KnifeEnds:
    """Return the planned stops of the tip at the 2n ends of n edges that a knife cuts.

    Parameters
    ----------
    edges
        The n cuts or half-cuts.
    cuts
        Through cuts on which an end may lie.
    lead : mm
        Length by which the blade cuts the top face ahead of its tip.  The tip stops before an end
        inside a panel by this length.
    overrun : mm
        Length by which the tip passes an end that meets a cut, if waste lies ahead of this end.
    ring : (n,)
        Mask of the edges of closed contours, which are cut without a stop; None for no edge.
    swivel : degrees
        The knife is lifted at sharper corners.  A stub is the part of a path from its last such
        corner to a free end, if it is not longer than ``lead``: the tip stops at the corner.
    """
    count = len(edges)
    link, _ = link_ends(edges, 180.0, ring)
    paths = edge_paths(edges, link)
    overlaps = cuts.touched_by_points(edges.ends, TOUCH_DISTANCE)
    other = np.flatnonzero(edges.row[overlaps.curve // 2] != cuts.row[overlaps.edge])
    end, cut = overlaps.curve[other], overlaps.edge[other].astype(np.int64)
    # A cut that ends here from the same side is a duplicate.
    twin = 2 * cut + (overlaps.place[other, 0] >= 0.5 * cuts.curve[cut, 5])
    here = pair_distances(cuts.ends, twin, edges.ends, end.astype(np.int64)) <= JOIN_DISTANCE
    same = angle_between(cuts.outward[twin], edges.outward[end]) <= STRAIGHT_ANGLE
    meets = np.zeros(2 * count, np.bool_)
    meets[end[~(here & same)]] = True
    free = ~meets & (link < 0)
    runs_over = np.zeros(2 * count, np.bool_)
    if overrun > 0.0 and meets.any():
        # A panel ahead of an end must not be cut.
        runs_over = meets & waste_ahead(edges, cuts)
    past = np.where(runs_over, overrun, 0.0)
    stop, over = edges.ends.copy(), np.flatnonzero(runs_over)
    ahead = np.radians(edges.outward[over])
    stop[over] += overrun * np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    stop[~meets & ~free] = np.nan
    arrival = edges.outward.copy()
    # Go back by the lead from a free end along its path, over several edges if necessary.
    free_ends = np.flatnonzero(free)
    if len(free_ends):
        edge = free_ends // 2
        path = paths.path[edge]
        at_last = paths.last[path] == free_ends
        position = np.where(at_last, paths.length[path] - lead, lead)
        row, place = paths.locate(path, np.clip(position, 0.0, paths.length[path]), edges.curve)
        stop[free_ends] = point_at(edges.curve[row], place)
        turned = np.where(at_last == paths.flipped[row], 180.0, 0.0)
        arrival[free_ends] = azimuth_at(edges.curve[row], place) + turned
    setback = np.where(free, lead, 0.0)
    stub, corner, left = _stubs(edges, link, paths, swivel, lead)
    inside = free[stub]
    stub, corner, left = stub[inside], corner[inside], left[inside]
    setback[stub] = left
    stop[stub], arrival[stub] = edges.ends[corner], edges.outward[corner]
    stub_end = _edges_on_stubs(edges, paths, stub, left)
    return KnifeEnds(stop, arrival, free, meets, past, setback, stub_end, paths)


def _stubs(
    edges: Edges, link: I64, paths: EdgePaths, swivel: float, lead: float
) -> tuple[I64, I64, F64]:
    """Return the k ends of paths behind whose last sharp corner the blade has no room.

    Returns the end of the edge at which each of these paths ends, (k,); the end of an edge at which
    the tip reaches the corner, (k,); and the length of the path from there to its end, (k,) mm.

    ``link`` (2n,): index of the end to which each end of the n edges is linked, -1 for none.
    ``paths``: paths of the edges with these links.
    ``swivel`` degrees: the path turns by more at a sharp corner.
    ``lead`` mm: a path that is longer, but not from its last corner to its end, has no room.
    """
    here = np.flatnonzero(link >= 0)
    turn = angle_between(edges.outward[here], edges.outward[link[here]] + 180.0)
    here = here[turn > swivel + _ANGLE_SLACK]
    path = paths.path[here // 2]
    is_candidate = (paths.first[path] >= 0) & (paths.length[path] > lead + LIMIT_SLACK)
    here, path = here[is_candidate], path[is_candidate]
    # A path leaves an edge at its end, or at its start if the edge is traversed backwards.
    leaves = (here % 2 == 1) != paths.flipped[here // 2]
    reached = paths.begin[here // 2] + np.where(leaves, edges.curve[here // 2, 5], 0.0)
    left = np.where(leaves, paths.length[path] - reached, reached)
    end = np.where(leaves, paths.last[path], paths.first[path])
    order = np.lexsort((left, end))
    order = order[left[order] <= lead + LIMIT_SLACK]
    end, nearest = np.unique(end[order], return_index=True)
    return end, here[order[nearest]], left[order[nearest]]


def _edges_on_stubs(edges: Edges, paths: EdgePaths, end: I64, size: F64) -> I64:
    """Return the end of the stub on which each of n edges lies, (n,), -1 for none.

    ``end``, ``size`` (k,) and (k,) mm: ends of edges at which k stubs end, and their lengths.
    """
    path = paths.path[end // 2]
    at_last = paths.last[path] == end
    head, tail = np.zeros((2, len(paths.length)))
    head[path[~at_last]], tail[path[at_last]] = size[~at_last], size[at_last]
    middle = paths.begin + edges.curve[:, 5] / 2.0
    on_head = middle < head[paths.path]
    on_tail = middle > (paths.length - tail)[paths.path]
    return np.where(on_head, paths.first[paths.path], np.where(on_tail, paths.last[paths.path], -1))


def groove_continues(edges: Edges) -> Bool:
    """Return the mask of the 2n ends of n V-grooves at which a collinear groove continues, (2n,).

    End 2i is the start of groove i, and end 2i + 1 is its end.
    """
    a, b = edges.near_ends(JOIN_DISTANCE)
    continues = (a // 2 != b // 2) & (
        angle_between(edges.outward[a], edges.outward[b] + 180.0) <= _COLLINEAR_ANGLE
    )
    result = np.zeros(len(edges.ends), np.bool_)
    result[a[continues]] = True
    return result
