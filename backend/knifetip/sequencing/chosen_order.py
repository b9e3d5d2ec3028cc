"""chosen_order: put the tracks of a tool into the order that the user has chosen.

The toolpaths of the operations keep their order; a user chooses the order of the tracks within it.
An order that would change the order of the operations is refused, with the rule that it breaks.
Tracks without a chosen edge keep their places in the short order, and the others share the places
that are left.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from knifetip.errors import PlanError
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.toolpath import Motion, Toolpath
from knifetip.sequencing.order import link_times


@dataclass(frozen=True, eq=False, slots=True)
class ChosenOrder:
    """The k edges whose tracks the user has put in order."""

    rows: tuple[I32, ...]  #: rows of the cleaned dieline that make each edge
    line_type: U8  #: (k,) LineType of each edge

    def ranks(self, source: I32) -> I64:
        """Return the place in the chosen order of each of n rows of the cleaned dieline, (n,).

        A row without a place has the number of places.
        """
        count = len(self.rows)
        edges = np.concatenate(self.rows)
        places = np.repeat(np.arange(count), [len(rows) for rows in self.rows])
        table = np.full(max(int(edges.max()), int(source.max(initial=0))) + 1, count)
        np.minimum.at(table, edges, places)
        return np.where(source < 0, count, table[np.maximum(source, 0)])


def place_order(edges: Sequence[int], drawn: Dieline, cleaned: Cleaned) -> ChosenOrder | None:
    """Return the order that the user has chosen; None if none is chosen.

    Parameters
    ----------
    edges
        Rows of the drawing, in the order in which their tracks are made.  Of an edge that is named
        twice the first place counts.
    drawn, cleaned
        The edges of the drawing and the cleaned edges.

    Raises
    ------
    PlanError
        The drawing has no such edge, or the edge is not made.
    """
    if not edges:
        return None
    parts = cleaned.stretches
    listed = list(dict.fromkeys(edges))
    for row in listed:
        if row >= len(drawn):
            raise PlanError("edge-choice.no-edge", row=row, count=len(drawn))
    made = np.flatnonzero(parts.cleaned >= 0)
    made = made[np.argsort(parts.row[made], kind="stable")]
    first = np.searchsorted(parts.row[made], listed)
    last = np.searchsorted(parts.row[made], listed, side="right")
    rows = tuple(
        np.unique(parts.cleaned[made[begin:end]]) for begin, end in zip(first, last, strict=True)
    )
    for row, found in zip(listed, rows, strict=True):
        if len(found) == 0:
            raise PlanError("order.not-made", edge=row, at_edges=[row])
    return ChosenOrder(rows, drawn.line_type[listed])


def check_stages(chosen: ChosenOrder, work: Sequence[Toolpath]) -> None:
    """Raise ``PlanError`` if a chosen order contradicts the order of the operations.

    ``work`` are the toolpaths of the operations, in working order.
    """
    number = np.repeat(np.arange(len(work)), [len(toolpath) for toolpath in work])
    stage = _first_numbers(np.concatenate([one.source for one in work]), number, chosen)
    broken = _first_decrease(stage)
    if broken is not None:
        late, early = (work[int(stage[place])] for place in broken)
        raise _broken_rule(chosen, broken, late, early)


def check_moves(chosen: ChosenOrder, source: I32) -> None:
    """Raise ``PlanError`` if the moves of a sequenced toolpath do not have the chosen order.

    That is so if several edges of one track have places, and the tool makes them in another order.

    ``source`` (n,) is the row of the cleaned dieline of each move, -1 for none.
    """
    broken = _first_decrease(_first_numbers(source, np.arange(len(source)), chosen))
    if broken is not None:
        edge, other = (int(chosen.rows[place][0]) for place in broken)
        raise PlanError("order.one-track", edge=edge, other=other, at_edges=[edge, other])


def in_chosen_order(order: I32, rank: I64, places: int) -> I32:
    """Return t tracks in the chosen order.

    Parameters
    ----------
    order : (t,)
        The tracks in a short order.
    rank : (t,)
        Place of each track in the chosen order, ``places`` for none.  Such a track keeps its
        position in ``order``; the others share the positions that are left.
    """
    slots = np.flatnonzero(rank[order] < places)
    tracks = order[slots]
    result = order.copy()
    result[slots] = tracks[np.argsort(rank[tracks], kind="stable")]
    return result


def choose_ends(order: I32, entry: F64, leave: F64, origin: F64, pace: F64, period: float) -> Bool:
    """Return which of t tracks start at their far end so that the air moves are short, (t,).

    ``order`` (t,) is the order of the tracks; the mask has one entry per entry of it.  The other
    parameters are those of ``short_order``.

    Notes
    -----
    Dynamic programming: the shortest way to an end of a track is the best of the ways over the two
    ends of the track before it.
    """
    entry, leave = entry[:, order], leave[:, order]
    #: [before, after]: time of the air move to each track
    time = np.array(
        [[link_times(after, before, origin, pace, period) for after in entry] for before in leave]
    )
    count = len(order)
    come_from = np.zeros((count, 2), np.int64)
    total = time[0, :, 0]
    for place in range(1, count):
        ways = total[:, None] + time[:, :, place]
        come_from[place] = ways.argmin(axis=0)
        total = ways.min(axis=0)
    flip = np.zeros(count, np.bool_)
    end = int(total.argmin())
    for place in range(count - 1, -1, -1):
        flip[place] = end
        end = int(come_from[place, end])
    return flip


def _first_numbers(source: I32, number: I64, chosen: ChosenOrder) -> I64:
    """Return the least number of a move along each of the k chosen edges, (k,); -1 for none.

    ``source``, ``number`` (n,): row of the cleaned dieline and number of each move.
    """
    ends = [int(rows.max()) for rows in chosen.rows]
    missing = np.iinfo(np.int64).max
    first = np.full(max(*ends, int(source.max(initial=0))) + 1, missing)
    along = source >= 0
    np.minimum.at(first, source[along], number[along])
    result = np.array([first[rows].min() for rows in chosen.rows])
    return np.where(result == missing, -1, result)


def _first_decrease(numbers: I64) -> tuple[int, int] | None:
    """Return the places of the first two numbers of which the later one is less; None if no number
    is less than one before it.  Negative numbers do not count.
    """
    known = np.flatnonzero(numbers >= 0)
    below = np.flatnonzero(np.diff(numbers[known]) < 0)
    return (int(known[below[0]]), int(known[below[0] + 1])) if len(below) else None


def _broken_rule(
    chosen: ChosenOrder, places: tuple[int, int], late: Toolpath, early: Toolpath
) -> PlanError:
    """Return the error that names the rule which a chosen order breaks.

    ``places``: places of two edges in the order.
    ``late``, ``early``: the operations that make them, of which the second one comes first.
    """
    edge, other = (int(chosen.rows[place][0]) for place in places)
    types = [LineType(int(chosen.line_type[place])).word for place in places]
    at_edges = [edge, other]
    if types[0] != types[1]:
        return PlanError(
            "order.types",
            edge=edge,
            other=other,
            type=types[0],
            other_type=types[1],
            at_edges=at_edges,
        )
    stations = int(late.tool[0]), int(early.tool[0])
    if stations[0] != stations[1]:
        return PlanError(
            "order.tools",
            edge=edge,
            other=other,
            station=stations[0],
            other_station=stations[1],
            at_edges=at_edges,
        )
    code = (
        "order.enclosed"
        if _encloses(chosen.rows[places[0]], late, chosen.rows[places[1]], early)
        else "order.pieces"
    )
    return PlanError(code, edge=edge, other=other, at_edges=at_edges)


def _encloses(rows: I32, toolpath: Toolpath, inner_rows: I32, inner: Toolpath) -> bool:
    """Return whether the track of some edges goes round that of others.

    ``rows``, ``inner_rows``: rows of the cleaned dieline; ``toolpath``, ``inner``: the operations
    that make them.
    """
    low, high = _box_of_track(rows, toolpath)
    inner_low, inner_high = _box_of_track(inner_rows, inner)
    return bool((low <= inner_low).all() and (inner_high <= high).all())


def _box_of_track(rows: I32, toolpath: Toolpath) -> tuple[F64, F64]:
    """Return the lower left and the upper right corner of the first track along some edges, (2,)
    mm each, without its leads.
    """
    found = np.flatnonzero(np.isin(toolpath.source, rows) & (toolpath.track >= 0))
    own = np.flatnonzero(
        (toolpath.track == toolpath.track[found[0]]) & (toolpath.motion == Motion.FEED)
    )
    points = np.concatenate([toolpath.pose[own, :2], toolpath.pose[own + 1, :2]])
    return points.min(axis=0), points.max(axis=0)
