"""Intent: what each edge asks for: the depth, where the tip begins and stops, what it may run over.

    Dieline, placement -> Edges (curves on the sheet) -> Creases, KnifeEnds, grooves that go on

The rules are the trade's, told again from the board's and the tools' records:

* a wheel of radius R pressed in by δ touches ± s, s² = δ(2R − δ); at an end where no other crease
  goes on it stops s and the board's end clearance early; what is too short for that is pressed in
  one place at the depth whose contact fits;
* a blade slanted by α is at the top face ahead of its tip by h tan α.  A cut that ends inside a
  panel stops where the top face ends; one that ends on another cut, or on its own start, runs on.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.errors import GeometryError
from knifetip.kernels import F64_1, I64_1, kernel
from knifetip.model.board import Board
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.tool import CreaseWheel
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.kinematics import arcs, azimuth_at, lines, point_at
from knifetip.verification.overlap import overlaps
from knifetip.verification.tools import Trade

#: Ends nearer than this are one path (mm).
JOINED: Final = 0.002
#: Ends nearer than this were meant to touch (mm).
TOUCHING: Final = 0.05
#: Straighter than this is straight on (degrees).
STRAIGHT: Final = 1.0
#: Edges that are one so far from their common end are drawn over each other (mm).
OVER: Final = 2.0
#: So far ahead of its end a crease is looked for that goes on (mm).
PROBE: Final = 0.5
#: Grooves that differ less in direction are one groove (degrees).
ONE_LINE: Final = 0.005
#: More pairs of ends at one place are no dieline.
CROWD: Final = 20_000_000
#: A bulge below this is a straight line.
_BULGE: Final = 1e-9

#: The line types that each trade may work.
WORKED: Final[dict[Trade, tuple[LineType, ...]]] = {
    Trade.CUT: (LineType.CUT, LineType.PERFORATION, LineType.COMBI),
    Trade.HALF_CUT: (LineType.HALF_CUT,),
    Trade.CREASE: (LineType.CREASE, LineType.COMBI),
    Trade.GROOVE: (LineType.V_GROOVE,),
    Trade.MILL: (LineType.CUT,),
}


@dataclass(frozen=True, eq=False, slots=True)
class Edges:
    """n edges on the sheet."""

    row: I32  #: (n,) row in Dieline
    curve: F64  #: (n, 6) as in kinematics.Work
    line_type: I32  #: (n,)
    ends: F64  #: (2n, 2) mm, start and end of each edge in turn
    outward: F64  #: (2n,) degrees, the direction in which each edge leaves its ends
    chord: F64  #: (n,) degrees, from start to end

    def __len__(self) -> int:
        return len(self.row)

    def of(self, *types: LineType) -> Edges:
        """Return the edges of these line types."""
        return self.taken(np.flatnonzero(np.isin(self.line_type, types)))

    def taken(self, where: I64) -> Edges:
        """Return some of the edges, by row."""
        twice = np.stack([2 * where, 2 * where + 1], axis=1).ravel()
        return Edges(
            self.row[where],
            self.curve[where],
            self.line_type[where],
            self.ends[twice],
            self.outward[twice],
            self.chord[where],
        )


def on_sheet(dieline: Dieline, placement: tuple[float, float]) -> Edges:
    """Return the dieline's edges with length, moved to where the sheet has them.

    Raises
    ------
    GeometryError
        The placement or an edge has a coordinate that is not a number.
    """
    bad = ~(np.isfinite(dieline.ends).all(axis=(1, 2)) & np.isfinite(dieline.bulge))
    if bad.any() or not np.isfinite(placement).all():
        what = f"Edge {int(np.argmax(bad))}" if bad.any() else "The placement"
        raise GeometryError("input.not-finite", what=what)
    start = dieline.ends[:, 0] + placement
    end = dieline.ends[:, 1] + placement
    row = np.flatnonzero(np.hypot(*(end - start).T) > 0.0).astype(np.int32)
    start, end, bulge = start[row], end[row], dieline.bulge[row]
    curve = lines(start, end)
    bent = np.abs(bulge) >= _BULGE
    chord = end[bent] - start[bent]
    b = bulge[bent]
    # The centre lies (1 - b²) / 4b chords to the left of the chord's middle.
    left = np.stack([-chord[:, 1], chord[:, 0]], axis=1)
    centre = (start[bent] + end[bent]) / 2.0 + left * ((1.0 - b * b) / (4.0 * b))[:, None]
    curve[bent] = arcs(centre, start[bent], 4.0 * np.arctan(b))
    at_start = azimuth_at(curve, np.zeros(len(row)))
    at_end = azimuth_at(curve, curve[:, 5])
    return Edges(
        row=row,
        curve=curve,
        line_type=dieline.line_type[row].astype(np.int32),
        ends=np.stack([start, end], axis=1).reshape(-1, 2),
        outward=np.stack([at_start + 180.0, at_end], axis=1).ravel(),
        chord=np.degrees(np.arctan2(*(end - start).T[::-1])),
    )


def drawn_once(edges: Edges) -> tuple[Edges, I32, I32]:
    """Return the edges without those drawn again over another of their type.

    Returns
    -------
    edges, rows of what is left out, rows of what stays for each of those
    """
    a, b = pairs_within(edges.ends, edges.ends, JOINED)
    same = (a % 2 == 0) & (a // 2 > b // 2)
    # Which end of the other lies at the start, and whether its other end lies at the end too.
    first, other = a[same] // 2, b[same]
    away = edges.ends[2 * first + 1] - edges.ends[other ^ 1]
    middle = [point_at(edges.curve[row], 0.5 * edges.curve[row, 5]) for row in (first, other // 2)]
    twins = (
        (np.hypot(*away.T) <= JOINED)
        & (np.hypot(*(middle[0] - middle[1]).T) <= JOINED)
        & (edges.line_type[first] == edges.line_type[other // 2])
    )
    stays = np.arange(len(edges))
    np.minimum.at(stays, first[twins], other[twins] // 2)
    # The one that stays may itself be drawn over an earlier one.
    while (stays[stays] != stays).any():
        stays = stays[stays]
    twin = np.flatnonzero(stays != np.arange(len(edges)))
    left = edges.taken(np.flatnonzero(stays == np.arange(len(edges))))
    return left, edges.row[twin], edges.row[stays[twin]]


def pairs_within(points: F64, others: F64, distance: float) -> tuple[I64, I64]:
    """Return the pairs of points, (n, 2) and (m, 2) mm, within a distance of each other."""
    if len(points) == 0 or len(others) == 0:
        return np.zeros(0, np.int64), np.zeros(0, np.int64)
    low = np.minimum(points.min(axis=0), others.min(axis=0)) - distance
    cell = np.floor((others - low) / distance).astype(np.int64)
    mine = np.floor((points - low) / distance).astype(np.int64)
    high = int(max(cell[:, 1].max(), mine[:, 1].max())) + 2
    key = cell[:, 0] * high + cell[:, 1]
    order = np.argsort(key, kind="stable")
    key = key[order]
    found_a, found_b = [], []
    for column in (-1, 0, 1):
        # The three cells of a column lie next to each other in the keys.
        wanted = (mine[:, 0] + column) * high + mine[:, 1]
        first = np.searchsorted(key, wanted - 1)
        many = np.searchsorted(key, wanted + 2) - first
        if many.sum() > CROWD:
            raise GeometryError("edge.too-crowded", limit=CROWD, distance=distance)
        a = np.repeat(np.arange(len(points)), many)
        b = np.arange(len(a)) - np.repeat(np.cumsum(many) - many - first, many)
        found_a.append(a)
        found_b.append(order[b])
    a, b = np.concatenate(found_a), np.concatenate(found_b)
    near = np.hypot(*(points[a] - others[b]).T) <= distance
    return a[near], b[near]


def apart(one: F64, other: F64, turn: float = 360.0) -> F64:
    """Return the smaller angle between directions (degrees)."""
    half = turn / 2.0
    result: F64 = np.abs((one - other + half) % turn - half)
    return result


def _links(edges: Edges, kink: float, ring: Bool | None = None) -> tuple[I64, Bool]:
    """Return which end each end is joined to, -1 for none, and whether another goes straight on.

    Two ends that are alone are joined where they turn by no more than ``kink`` degrees; where
    more meet, those that run straight through each other are, if neither has a second candidate.
    Where two edges of a ``ring``, (n,), meet they go on as each other, whatever else ends there.
    """
    count = len(edges.ends)
    a, b = pairs_within(edges.ends, edges.ends, TOUCHING)
    keep = a // 2 != b // 2
    a, b = a[keep], b[keep]
    turn = apart(edges.outward[a], edges.outward[b] + 180.0)
    goes_on = np.zeros(count, np.bool_)
    goes_on[a[turn <= STRAIGHT]] = True
    joined = np.hypot(*(edges.ends[a] - edges.ends[b]).T) <= JOINED
    # One drawn over the other does not come back along it.
    joined &= ~((turn >= 180.0 - STRAIGHT) & _over(edges, a, b))
    a, b, turn = a[joined], b[joined], turn[joined]
    if ring is not None:
        both = ring[a // 2] & ring[b // 2]
        rung = np.bincount(a[both], minlength=count) == 1
        both &= rung[a] & rung[b]
        taken = np.zeros(count, np.bool_)
        taken[a[both]] = True
        keep = both | ~(taken[a] | taken[b])
        a, b, turn = a[keep], b[keep], np.where(both, 0.0, turn)[keep]
    crowd = np.bincount(a, minlength=count)
    fits = np.where((crowd[a] == 1) & (crowd[b] == 1), turn <= kink + 1e-9, turn <= STRAIGHT)
    a, b = a[fits], b[fits]
    single = np.bincount(a, minlength=count) == 1
    link = np.full(count, -1, np.int64)
    mutual = single[a] & single[b]
    link[a[mutual]] = b[mutual]
    return link, goes_on


def _over(edges: Edges, a: I64, b: I64) -> Bool:
    """Return whether the edges of pairs of ends that lie together are drawn over each other."""
    size = np.minimum(edges.curve[a // 2, 5], edges.curve[b // 2, 5])
    inward = np.minimum(size, OVER)
    points = [
        point_at(curve, np.where(end % 2 == 0, inward, curve[:, 5] - inward))
        for end, curve in ((a, edges.curve[a // 2]), (b, edges.curve[b // 2]))
    ]
    result: Bool = np.hypot(*(points[0] - points[1]).T) <= JOINED
    return result


@dataclass(frozen=True, eq=False, slots=True)
class Chains:
    """n edges strung on c paths."""

    path: I64  #: (n,) the path of each edge
    begin: F64  #: (n,) mm from the path's first end to where the edge begins on it
    flipped: Bool  #: (n,) the path runs from the edge's end to its start
    length: F64  #: (c,) mm
    first: I64  #: (c,) end at which the path begins, -1 where it is closed
    last: I64  #: (c,) end at which it ends

    def stretch(self, low: F64, high: F64, curve: F64) -> tuple[F64, F64]:
        """Return for each edge which part of it, in its own mm, lies between two places.

        Parameters
        ----------
        low, high : (c,) mm from the first end of each path
        """
        size = curve[:, 5]
        near = np.clip(low[self.path] - self.begin, 0.0, None)
        far = np.minimum(high[self.path] - self.begin, size)
        own_low = np.where(self.flipped, size - far, near)
        own_high = np.where(self.flipped, size - near, far)
        return own_low, own_high

    def find(self, path: I64, at: F64, curve: F64) -> tuple[I64, F64]:
        """Return the edge, and the place in its own mm, at a distance along paths."""
        order = np.lexsort((self.begin, self.path))
        widest = float(self.length.max(initial=0.0)) + 1.0
        key = self.path[order] * widest + self.begin[order]
        rows = order[np.searchsorted(key, path * widest + at, side="right") - 1]
        along = np.clip(at - self.begin[rows], 0.0, curve[rows, 5])
        return rows, np.where(self.flipped[rows], curve[rows, 5] - along, along)


def joints(edges: Edges) -> I64:
    """Return the end that each end is joined to, (2n,), -1 for none: alone, at any angle."""
    return _links(edges, 180.0)[0]


def straight_on(edges: Edges) -> Bool:
    """Return for the ends of edges, (2n,), whether another one goes straight on."""
    return _links(edges, STRAIGHT)[1]


def chains(edges: Edges, link: I64) -> Chains:
    """Return the paths that linked ends make."""
    path, begin, flipped, length, first, last, count = _strung(link, edges.curve[:, 5].copy())
    return Chains(path, begin, flipped, length[:count], first[:count], last[:count])


@kernel
def _strung(link: I64_1, size: F64_1) -> Any:
    count = len(size)
    path = np.full(count, -1, np.int64)
    begin = np.zeros(count)
    flipped = np.zeros(count, np.bool_)
    length = np.zeros(count)
    first = np.full(count, -1, np.int64)
    last = np.full(count, -1, np.int64)
    paths = 0
    for edge in range(count):
        if path[edge] >= 0:
            continue
        tail = 2 * edge
        closed = False
        while link[tail] >= 0:
            tail = link[tail] ^ 1
            if tail == 2 * edge:
                closed = True
                break
        if not closed:
            first[paths] = tail
        at = 0.0
        while tail >= 0 and path[tail // 2] < 0:
            path[tail // 2] = paths
            begin[tail // 2] = at
            flipped[tail // 2] = tail % 2 == 1
            at += size[tail // 2]
            if not closed:
                last[paths] = tail ^ 1
            tail = link[tail ^ 1]
        length[paths] = at
        paths += 1
    return path, begin, flipped, length, first, last, paths


@dataclass(frozen=True, eq=False, slots=True)
class Creases:
    """What n creases ask of the wheel."""

    edges: Edges
    depth: F64  #: (n,) mm below the top face, of the tip
    low: F64  #: (n,) mm along the edge where the tip may begin
    high: F64  #: (n,) mm, below ``low`` where the tip has no business
    pressed: Bool  #: (n,) the tip comes down in one place
    refused: Bool  #: (n,) too short, and the board wants none pressed


def creases(
    edges: Edges,
    board: Board,
    wheel: CreaseWheel,
    around: Edges | None = None,
    parts: Bool | None = None,
) -> Creases:
    """Return where the wheel's lowest point goes, and how deep, for creases and combi lines.

    Parameters
    ----------
    around
        All creases, those of other wheels too: where one of them goes on, no end is free.
    parts : (2n,)
        The ends at which a cut runs through a crease: they are free.
    """
    across = np.radians(edges.chord - board.grain)
    depth = board.crease_along + (board.crease_across - board.crease_along) * np.sin(across) ** 2
    contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
    link, goes_on = _links(edges, STRAIGHT)
    goes_on |= _onward(edges, edges if around is None else around)
    if parts is not None:
        goes_on[parts] = False
        link[parts] = -1
        link[(link >= 0) & parts[link]] = -1
    paths = chains(edges, link)
    open_ = paths.first >= 0
    free = [open_ & ~goes_on[np.maximum(end, 0)] for end in (paths.first, paths.last)]
    back = [
        np.where(at_end, contact[np.maximum(end, 0) // 2] + board.end_clearance, 0.0)
        for at_end, end in zip(free, (paths.first, paths.last), strict=True)
    ]
    begin, finish = back[0], paths.length - back[1]
    short = finish - begin <= 1e-5
    low, high = paths.stretch(begin, finish, edges.curve)
    low[short[paths.path]], high[short[paths.path]] = 0.0, -1.0

    pressed = np.zeros(len(edges), np.bool_)
    refused = np.zeros(len(edges), np.bool_)
    which = np.flatnonzero(short)
    if len(which):
        both = free[0][which] & free[1][which]
        size = paths.length[which]
        at = np.where(both, size / 2.0, np.where(free[0][which], size, 0.0))
        half = np.where(both, size / 2.0, size) - board.end_clearance
        row, place = paths.find(which, at, edges.curve)
        reach = np.clip(half, 0.0, wheel.radius)
        fits = wheel.radius - np.sqrt(wheel.radius**2 - reach**2)
        depth[row] = np.minimum(depth[row], fits)
        low[row] = high[row] = place
        pressed[row] = True
        refused[row] = (board.short_crease != "press") | (half <= 0.0)
    return Creases(edges, depth, low, high, pressed, refused)


def _onward(edges: Edges, around: Edges) -> Bool:
    """Return for the ends of edges, (2n,), whether one of those around lies on from there."""
    ahead = np.radians(edges.outward)
    step = PROBE * np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    probe = lines(edges.ends, edges.ends + step)
    rows = overlaps(probe, around.curve, np.zeros(len(around)), around.curve[:, 5], TOUCHING)
    own = edges.row[rows.curve // 2] == around.row[rows.edge]
    turn = apart(
        edges.outward[rows.curve], azimuth_at(around.curve[rows.edge], rows.place[:, 0]), 180.0
    )
    begins = rows.along[:, 0] <= TOUCHING
    on = ~own & begins & (turn <= STRAIGHT) & (np.diff(rows.along)[:, 0] > 0.5 * PROBE)
    result = np.zeros(len(edges.ends), np.bool_)
    result[rows.curve[on]] = True
    return result


@dataclass(frozen=True, eq=False, slots=True)
class KnifeEnds:
    """Where a knife may stop at the 2n ends of n edges."""

    stop: F64  #: (2n, 2) mm on the sheet
    free: Bool  #: (2n,) the end lies inside a panel
    meets: Bool  #: (2n,) the end lies on another through cut
    paths: Chains


def knife_ends(
    edges: Edges, cuts: Edges, lead: float, overrun: float, ring: Bool | None = None
) -> KnifeEnds:
    """Return where the tip stops at each end of edges that a knife works.

    Parameters
    ----------
    edges
        Cuts or half-cuts.
    cuts
        The through cuts, which an end may meet.
    lead : mm
        How far the top face is cut ahead of the tip: an end inside a panel is cut short by it.
    overrun : mm
        How far the tip runs past an end that meets a cut.
    ring : (n,)
        Edges that are cut all round, past what else ends on them.
    """
    count = len(edges)
    link, _ = _links(edges, 180.0, ring)
    paths = chains(edges, link)
    rows = overlaps(
        lines(edges.ends, edges.ends), cuts.curve, np.zeros(len(cuts)), cuts.curve[:, 5], TOUCHING
    )
    own = edges.row[rows.curve // 2] == cuts.row[rows.edge]
    # One that ends here too, from the same side, is the same cut drawn again.
    near = np.where(rows.place[:, 0] < 0.5 * cuts.curve[rows.edge, 5], 0, 1)
    twin = 2 * rows.edge.astype(np.int64) + near
    here = np.hypot(*(cuts.ends[twin] - edges.ends[rows.curve]).T) <= JOINED
    own |= here & (apart(cuts.outward[twin], edges.outward[rows.curve]) <= STRAIGHT)
    meets = np.zeros(2 * count, np.bool_)
    meets[rows.curve[~own]] = True
    free = ~meets & (link < 0)
    ahead = np.radians(edges.outward)
    stop = edges.ends + overrun * np.stack([np.cos(ahead), np.sin(ahead)], axis=1)
    stop[~meets & ~free] = np.nan
    # Back from a free end along the path, round corners where its last edge is shorter.
    which = np.flatnonzero(free)
    if len(which):
        edge = which // 2
        path = paths.path[edge]
        at_last = paths.last[path] == which
        at = np.where(at_last, paths.length[path] - lead, lead)
        row, place = paths.find(path, np.clip(at, 0.0, paths.length[path]), edges.curve)
        stop[which] = point_at(edges.curve[row], place)
    return KnifeEnds(stop, free, meets, paths)


def run_on(edges: Edges) -> Bool:
    """Return for the ends of V-grooves, (2n,), whether another groove goes on in one line."""
    a, b = pairs_within(edges.ends, edges.ends, JOINED)
    on = (a // 2 != b // 2) & (apart(edges.outward[a], edges.outward[b] + 180.0) <= ONE_LINE)
    result = np.zeros(len(edges.ends), np.bool_)
    result[a[on]] = True
    return result
