"""passes: find the passes of a toolpath, and write them in a new order.

A pass is a run of moves between two rapids.  The passes with one track number form one track, for
example the two sides of a V-groove.
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    U8_1,
    Bool_1,
    OutF64_2,
    kernel,
)
from knifetip.model.toolpath import Motion, Toolpath

#: ``Motion`` values for the kernels.
_RAPID: Final = int(Motion.RAPID)
_PLUNGE: Final = int(Motion.PLUNGE)
_LIFT: Final = int(Motion.LIFT)
#: Motion of each kind of move when it is run backwards.
_REVERSED: Final = np.arange(len(Motion), dtype=np.uint8)
_REVERSED[[Motion.LIFT, Motion.LEAD_IN, Motion.LEAD_OUT]] = (
    Motion.PLUNGE,
    Motion.LEAD_OUT,
    Motion.LEAD_IN,
)


class Moves(NamedTuple):
    """n moves: columns of a ``Toolpath`` that change with the order of the passes."""

    pose: F64_2  #: (n + 1, 4) poses before and after each move
    bulge: F64_1  #: (n,) tan(sweep / 4) of the move in XY
    motion: U8_1  #: (n,) ``Motion``
    feed: F64_1  #: (n,) feed, 0 for rapids
    source: I32_1  #: (n,) row of the edge in the dieline, -1 between edges
    track: I32_1  #: (n,) number of the track, -1 between tracks


class Passes(NamedTuple):
    """The p passes of a toolpath, which form t tracks."""

    first: I64_1  #: (p,) row of the first move of each pass
    last: I64_1  #: (p,) row of the last move of each pass
    opens: I64_1  #: (t + 1,) first pass of each track, and p


class PassOrder(NamedTuple):
    """The order in which t tracks are made, and how each of them is made."""

    tracks: I32_1  #: (t,) index of each track, in working order
    from_far_end: Bool_1  #: (t,) whether each of these tracks starts at its far end
    swaps_pairs: bool  #: a track from its far end exchanges its passes in pairs, not all of them
    runs_back: bool  #: the passes of a track from its far end are run backwards


class OrderedMoves(NamedTuple):
    """The m moves of passes in a new order; move 0 of each pass is the rapid to its start."""

    pose: OutF64_2  #: (m, 4) pose after each move
    bulge: F64_1  #: (m,)
    motion: U8_1  #: (m,)
    feed: F64_1  #: (m,)
    source: I32_1  #: (m,)
    track: I32_1  #: (m,) track in the new order, counted from 0; -1 for the rapid before a track
    begin: I64_1  #: (p + 1,) first move of each pass, and m


def columns_of(toolpath: Toolpath) -> Moves:
    """Return the columns of a toolpath that change with the order of its passes."""
    return Moves(
        np.ascontiguousarray(toolpath.pose),
        np.ascontiguousarray(toolpath.bulge),
        np.ascontiguousarray(toolpath.motion),
        np.ascontiguousarray(toolpath.feed),
        np.ascontiguousarray(toolpath.source),
        np.ascontiguousarray(toolpath.track),
    )


@kernel
def find_passes(motion: U8_1, track: I32_1) -> Any:
    """Return the passes of n moves, as ``Passes``.

    Rapids between passes, and other moves without a track, belong to no pass.

    Parameters
    ----------
    motion, track : (n,)
        ``Motion`` of each move, and number of its track, -1 for none.
    """
    first, last = np.empty(len(motion), np.int64), np.empty(len(motion), np.int64)
    opens = np.empty(len(motion) + 1, np.int64)
    passes = tracks = 0
    for row in range(len(motion)):
        if track[row] < 0 or motion[row] == _RAPID:
            continue
        if passes == 0 or last[passes - 1] != row - 1 or track[row - 1] != track[row]:
            if passes == 0 or track[first[passes - 1]] != track[row]:
                opens[tracks] = passes
                tracks += 1
            first[passes] = row
            passes += 1
        last[passes - 1] = row
    opens[tracks] = passes
    return Passes(first[:passes].copy(), last[:passes].copy(), opens[: tracks + 1].copy())


@kernel
def order_passes(moves: Moves, passes: Passes, order: PassOrder, rotation: float) -> Any:
    """Return the moves of all passes in a new order, as ``OrderedMoves``.

    Parameters
    ----------
    moves, passes
        The moves before, and their passes.
    order
        The new order of the tracks.
    rotation : degrees
        Rotation of C by which the poses of a pass that is run backwards differ.
    """
    count = 0
    for number in range(len(passes.first)):
        count += passes.last[number] - passes.first[number] + 2
    pose, bulge, feed = np.empty((count, 4)), np.empty(count), np.empty(count)
    motion = np.empty(count, np.uint8)
    source, track = np.empty(count, np.int32), np.empty(count, np.int32)
    begin = np.empty(len(passes.first) + 1, np.int64)
    used = done = 0
    for position in range(len(order.tracks)):
        opens = passes.opens[order.tracks[position]]
        size = passes.opens[order.tracks[position] + 1] - opens
        far = order.from_far_end[position]
        back = far and order.runs_back
        for ordinal in range(size):
            other = ordinal ^ 1 if order.swaps_pairs else size - 1 - ordinal
            number = opens + (other if far else ordinal)
            first, last = passes.first[number], passes.last[number]
            begin[done] = used
            done += 1
            for step in range(last - first + 2):
                end = last + 1 - step if back else first + step
                for axis in range(4):
                    pose[used, axis] = moves.pose[end, axis]
                pose[used, 3] += rotation if back else 0.0
                if step == 0:
                    bulge[used], feed[used], motion[used] = 0.0, 0.0, _RAPID
                    source[used], track[used] = -1, -1 if ordinal == 0 else position
                    used += 1
                    continue
                row = end if back else end - 1
                kind = moves.motion[row]
                # On a reversed pass only the last plunge leaves the board: the others are steps
                # within it.
                if back and kind == _PLUNGE and step == last - first + 1:
                    motion[used] = _LIFT
                else:
                    motion[used] = _REVERSED[kind] if back else kind
                bulge[used] = -moves.bulge[row] if back else moves.bulge[row]
                feed[used], source[used] = moves.feed[row], moves.source[row]
                track[used] = position
                used += 1
    begin[done] = used
    return OrderedMoves(pose, bulge, motion, feed, source, track, begin)


@kernel
def heading_ranges(pose: F64_2, begin: I64_1) -> Any:
    """Return the first, last, smallest and largest heading of each of p passes, (4, p) degrees.

    ``pose`` (m, 4) are the poses after each move, and ``begin`` (p + 1,) the first move of each
    pass, and m.
    """
    headings = np.empty((4, len(begin) - 1))
    for number in range(len(begin) - 1):
        first, stop = begin[number], begin[number + 1]
        least = largest = pose[first, 3]
        for row in range(first + 1, stop):
            least, largest = min(least, pose[row, 3]), max(largest, pose[row, 3])
        headings[0, number], headings[1, number] = pose[first, 3], pose[stop - 1, 3]
        headings[2, number], headings[3, number] = least, largest
    return headings


@kernel
def turn_passes(pose: OutF64_2, begin: I64_1, shift: F64_1) -> None:
    """Add the angle ``shift`` (p,), in degrees, of each of p passes to its headings, in place.

    ``pose`` (m, 4) are the poses after each move, and ``begin`` (p + 1,) the first move of each
    pass, and m.
    """
    for number in range(len(shift)):
        for row in range(begin[number], begin[number + 1]):
            pose[row, 3] += shift[number]


@kernel
def rows_that_move(pose: F64_2, turns: I64_1) -> Any:
    """Return the rows of a toolpath without the lifts and plunges beside turns that do not move.

    ``pose`` (n + 1, 4) are the poses before and after each of the n rows, and ``turns`` the rows of
    rapids that each have a lift before them and a plunge after them.
    """
    moves = np.ones(len(pose) - 1, np.bool_)
    for turn in turns:
        for row in (turn - 1, turn + 1):
            same = True
            for axis in range(4):
                same = same and pose[row + 1, axis] == pose[row, axis]
            moves[row] = not same
    return np.flatnonzero(moves)
