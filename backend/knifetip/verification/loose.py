"""loose: is anything worked on a piece of board that the cuts before have already set free?

    Bench, Work -> findings

The cuts are split where they meet, and contours are closed where ends of cuts lie within ``GAP`` of
another cut.  Each piece of a cut is done with the line of the program that completes it.  Two faces
beside a piece hang together until it is done, so a face is held by the sheet until

    free(face) = max over all ways from the face to the outside of min over the pieces on it of done

which joining the faces in the order of ``done``, the latest first, gives for all of them at once.
What is worked in a face after that line is worked on a loose piece.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from typing import Any, Final

import numpy as np

from knifetip.kernels import F64_1, F64_2, I64_1, I64_2, Bool_1, kernel
from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.verification.bench import DEPTH, Bench
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.equidistants import equidistants
from knifetip.verification.findings import MOST
from knifetip.verification.intent import (
    JOINED,
    TOUCHING,
    Edges,
    chains,
    drawn_once,
    joints,
    pairs_within,
)
from knifetip.verification.kinematics import Work, azimuth_at, lines, point_at
from knifetip.verification.outline import outline, walks
from knifetip.verification.overlap import cells_of, laid_out, overlaps
from knifetip.verification.stretches import added
from knifetip.verification.tools import Trade, expected

#: An end of a cut so near to another cut closes a contour with it; so much of a cut may be left and
#: it holds nothing (mm).  A little less than what is planned for.
GAP: Final = 2.0
#: The way along a chain of cuts is so many times as long as the gap that closes it, at least.
_ROUND: Final = 3.0
#: Edges of these types are not worked.
_NO_WORK: Final = (LineType.UNCLASSIFIED, LineType.IGNORED)
#: A walk that sweeps less than this encloses nothing (mm²).
_NOTHING: Final = 1e-6
#: The ray that looks for what lies beside a point is so much higher than the point (mm): vertices
#: are drawn at equal heights.
_ASIDE: Final = 0.317 * JOINED
#: A stretch on an edge that is shorter than this only crosses the edge (mm).
_LONG: Final = 0.1
#: Beside a corner of 28° a cutter leaves so many times its radius of either edge untouched.
_CORNER: Final = 4.0
#: Where along other work it is looked at, in shares.
_PROBES: Final = (0.1, 0.5, 0.9)


@dataclass(frozen=True, eq=False, slots=True)
class _Net:
    """What n cuts enclose: p pieces, the last of them links, and f faces; face 0 is outside."""

    curve: F64  #: (p, 6)
    edge: I64  #: (p,) the cut, -1 for a link
    begin: F64  #: (p,) mm along the cut
    face: I64  #: (p, 2) on the left and on the right; of a twin in any order
    count: int  #: f
    alone: I64  #: (q,) the pieces but for those that lie on an earlier one

    def located(self, points: F64) -> I64:
        """Return the face that each point, (m, 2) mm, lies in."""
        alone = self.alone
        met, rising = _left_of(points, np.full(len(points), -1), self.curve[alone], alone)
        side = self.face[alone[met], np.where(rising, 1, 0)]
        result: I64 = np.where(met < 0, 0, side)
        return result


@dataclass(frozen=True, eq=False, slots=True)
class _Stretches:
    """Where cuts are worked, by edge and then by line."""

    edge: I64  #: (k,)
    low: F64  #: (k,) mm along the edge
    high: F64  #: (k,)
    line: I64  #: (k,)
    through: Bool  #: (k,)
    way: I64  #: (k,) row of the work
    reach: float  #: mm, the radius of the widest cutter, 0 for knives


def judge_order(bench: Bench, work: Work) -> None:
    """Judge whether everything inside a contour is worked before the contour is complete."""
    cuts, _, _ = drawn_once(bench.edges.of(LineType.CUT))
    if len(cuts) == 0 or len(work.z) == 0:
        return
    net = _net(cuts)
    done = _worked(bench, work, cuts)
    complete = _completed(
        net.edge, net.begin, net.begin + net.curve[:, 5], done.edge, done.low, done.high,
        np.where(done.through, done.line, -1), len(cuts), done.reach,
    )  # fmt: skip
    order = np.argsort(-complete, kind="stable")
    free = _freed(order, complete, net.face, net.count)
    _judge_cuts(bench, cuts, net, done, free)
    _judge_others(bench, cuts, net, work, done, free)


def _judge_cuts(bench: Bench, cuts: Edges, net: _Net, done: _Stretches, free: F64) -> None:
    """Judge the work on cuts: of the pieces of each stretch the one that is held longest.

    A line drawn across others is made in one go, and may lie in board that is held and in board
    that is loose; pieces shorter than ``GAP`` do not hold it.
    """
    pieces = np.flatnonzero(net.edge >= 0)
    first = np.searchsorted(net.edge[pieces], np.arange(len(cuts) + 1))
    held = free[net.face[pieces]].max(axis=1)
    begin = net.begin[pieces]
    until = _held_until(
        done.edge, done.low, done.high, first, begin, begin + net.curve[pieces, 5], held
    )
    late = done.line > until
    if done.reach == 0.0:
        # A knife runs on over its end, into a cut that may be made already.
        late &= _fresh(done.edge, done.low, done.high)
    some = np.flatnonzero(late)
    for k in some[np.unique(done.edge[some], return_index=True)[1]][:MOST]:
        edge = int(done.edge[k])
        place = point_at(
            cuts.curve[edge : edge + 1], np.array([0.5 * (done.low[k] + done.high[k])])
        )
        _found(bench, int(cuts.row[edge]), place[0], int(done.line[k]), int(until[k]))


def _judge_others(
    bench: Bench, cuts: Edges, net: _Net, work: Work, done: _Stretches, free: F64
) -> None:
    """Judge what is worked on other edges: creases, grooves, half-cuts, perforations."""
    some = work.line > free.min()
    some[done.way] = False
    rows = np.flatnonzero(some)
    kinds = (kind for kind in LineType if kind not in (LineType.CUT, *_NO_WORK))
    edges = bench.edges.of(*kinds)
    near = overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], TOUCHING
    )
    # What only crosses an edge is no work on it; a wheel that presses one place goes nowhere.
    size = np.diff(near.along)[:, 0]
    long = np.flatnonzero(near.best & (size >= np.minimum(_LONG, work.curve[rows[near.curve], 5])))
    way, along = rows[near.curve[long]], near.along[long]
    until = np.full(len(long), math.inf)
    place = np.zeros((len(long), 2))
    for share in _PROBES:
        points = point_at(work.curve[way], along @ (1.0 - share, share))
        on = overlaps(
            lines(points, points), cuts.curve, np.zeros(len(cuts)), cuts.curve[:, 5], TOUCHING
        )
        held = free[net.located(points)]
        held[on.curve] = math.inf
        sooner = held < until
        until[sooner], place[sooner] = held[sooner], points[sooner]
    late = np.flatnonzero(work.line[way] > until)
    late = late[np.unique(way[late], return_index=True)[1]]
    for k in late[:MOST]:
        row = int(edges.row[near.edge[long[k]]])
        _found(bench, row, place[k], int(work.line[way[k]]), int(until[k]))


def _found(bench: Bench, edge: int, place: F64, line: int, closed: int) -> None:
    bench.found.add(
        "order",
        Message("verify.loose-piece", x=place[0], y=place[1], line=closed),
        0.0,
        edge=edge,
        line=line,
    )


# -- when each cut is worked ---------------------------------------------------------------------


def _worked(bench: Bench, work: Work, cuts: Edges) -> _Stretches:
    """Return where along the cuts there is work: a knife's on the line, a cutter's beside it."""
    size = cuts.curve[:, 5]
    knife = np.flatnonzero(work.trade == Trade.CUT)
    near = overlaps(work.curve[knife], cuts.curve, np.zeros(len(cuts)), size, bench.tolerance)
    keep = near.best
    columns: list[tuple[I32 | I64, F64, F64, I64, Bool]] = [
        (near.edge[keep], near.place[keep].min(axis=1), near.place[keep].max(axis=1),
         knife[near.curve[keep]], np.ones(int(keep.sum()), np.bool_)),
    ]  # fmt: skip
    mill = work.trade == Trade.MILL
    bounds = outline(cuts) if mill.any() else None
    widest = 0.0
    for index in np.unique(work.station[mill]):
        held = bench.machine.stations[int(index)]
        assert bounds is not None
        tool = expected(held.tool)
        assert tool.disc is not None
        give = next((one for one in bench.board.deflection if one.tool == held.name), None)
        reach = np.full(2, tool.disc.radius) - ((give.x, give.y) if give else 0.0)
        widest = max(widest, float(reach.max()))
        beside = equidistants(bounds, reach)
        rows = np.flatnonzero(mill & (work.station == index))
        length = beside.curve[:, 5]
        near = overlaps(
            work.curve[rows], beside.curve, np.zeros(len(length)), length, bench.tolerance
        )
        low, high = beside.on_edge(near.edge, near.place)
        deep = bench.board.caliper - work.z[rows[near.curve]]
        planned = tool.through_depth(bench.board.caliper, bench.machine.into_mat)
        through = deep >= planned - DEPTH
        columns.append((beside.edge[near.edge], low, high, rows[near.curve], through))
    edge, low, high, way, through = (np.concatenate(one) for one in zip(*columns, strict=True))
    # What only crosses a cut, or touches its end, is no work on it.
    long = np.flatnonzero(high - low >= np.minimum(_LONG, 0.5 * size[edge]))
    long = long[np.lexsort((work.line[way[long]], edge[long]))]
    way = way[long].astype(np.int64)
    return _Stretches(
        edge[long].astype(np.int64), low[long], high[long], work.line[way].astype(np.int64),
        through[long], way, widest,
    )  # fmt: skip


@kernel
def _completed(
    owner: I64_1, begin: F64_1, end: F64_1, edge: I64_1, low: F64_1, high: F64_1,
    line: I64_1, count: int, reach: float,
) -> Any:  # fmt: skip
    """Return the line that completes each piece, infinite for none; before all others for links.

    A cutter does not come to all of a piece beside an inner corner, and to none of a short one, and
    passes round both: what is left so is no hold.
    """
    first = np.searchsorted(edge, np.arange(count + 1))
    complete = np.full(len(owner), 0.0 if reach > 0.0 else math.inf)
    for p in range(len(owner)):
        if owner[p] < 0:
            complete[p] = -1.0
            continue
        a, b = begin[p], end[p]
        most = _CORNER * reach if reach > 0.0 else min(GAP, 0.5 * (b - a))
        covered = np.empty((first[owner[p] + 1] - first[owner[p]] + 1, 2))
        many = 0
        for k in range(first[owner[p]], first[owner[p] + 1]):
            left, right = max(low[k], a), min(high[k], b)
            if right <= left:
                continue
            complete[p] = math.inf
            if line[k] < 0:
                continue
            many, _ = added(covered, many, left, right)
            bare, at = 0.0, a
            for j in range(many):
                bare = max(bare, covered[j, 0] - at)
                at = covered[j, 1]
            if max(bare, b - at) <= most:
                complete[p] = line[k]
                break
    return complete


@kernel
def _fresh(edge: I64_1, low: F64_1, high: F64_1) -> Any:
    """Return which stretches, by edge and then by line, are new for half of their length."""
    fresh = np.zeros(len(edge), np.bool_)
    begin = 0
    while begin < len(edge):
        end = begin
        while end < len(edge) and edge[end] == edge[begin]:
            end += 1
        covered = np.empty((end - begin + 1, 2))
        many = 0
        for k in range(begin, end):
            many, gained = added(covered, many, low[k], high[k])
            fresh[k] = gained >= 0.5 * (high[k] - low[k])
        begin = end
    return fresh


@kernel
def _held_until(
    edge: I64_1, low: F64_1, high: F64_1, first: I64_1, begin: F64_1, end: F64_1, held: F64_1
) -> Any:
    """Return until which line each stretch is held: by a short piece only if it has no other."""
    until = np.full(len(edge), -1.0)
    for k in range(len(edge)):
        for least in (GAP, 0.0):
            for p in range(first[edge[k]], first[edge[k] + 1]):
                shared = min(high[k], end[p]) - max(low[k], begin[p])
                if shared >= min(_LONG, 0.5 * (end[p] - begin[p])) and end[p] - begin[p] > least:
                    until[k] = max(until[k], held[p])
            if until[k] >= 0.0:
                break
        if until[k] < 0.0:
            until[k] = math.inf
    return until


# -- what the cuts enclose -----------------------------------------------------------------------


def _net(cuts: Edges) -> _Net:
    links = _links(cuts)
    curve = np.concatenate([cuts.curve, links])
    piece, edge, begin = _split(curve)
    edge = np.where(edge < len(cuts), edge, -1)
    nothing, zero = np.zeros(len(piece), np.int32), np.zeros(len(piece))
    ends = np.stack([point_at(piece, zero), point_at(piece, piece[:, 5])], axis=1)
    outward = np.stack([azimuth_at(piece, zero) + 180.0, azimuth_at(piece, piece[:, 5])], axis=1)
    row = np.arange(len(piece), dtype=np.int32)
    alone, twin, first = drawn_once(
        Edges(row, piece, nothing, ends.reshape(-1, 2), outward.ravel(), zero)
    )
    cycle, swept, component = walks(alone)
    face = np.empty((len(piece), 2), np.int64)
    face[alone.row], count = _nested(alone.curve, cycle.reshape(-1, 2), swept < _NOTHING, component)
    face[twin] = face[first]
    return _Net(piece, edge, begin, face, count, alone.row.astype(np.int64))


def _links(cuts: Edges) -> F64:
    """Return the lines that close gaps: from loose ends to the nearest cut, and to each other.

    Of two loose ends with a third between them, nearer to both, the third is linked to both.
    """
    a, b = pairs_within(cuts.ends, cuts.ends, JOINED)
    size, nothing = cuts.curve[:, 5], np.zeros(len(cuts))
    at = overlaps(lines(cuts.ends, cuts.ends), cuts.curve, nothing, size, JOINED)
    loose = np.ones(len(cuts.ends), np.bool_)
    loose[a[a // 2 != b // 2]] = False
    loose[at.curve[at.curve // 2 != at.edge]] = False
    tips = np.flatnonzero(loose)
    points = cuts.ends[tips]
    near = overlaps(lines(points, points), cuts.curve, nothing, size, GAP)
    tip, edge, place = near.curve.astype(np.int64), near.edge.astype(np.int64), near.place[:, 0]
    one, other = pairs_within(points, points, GAP)
    kept = one != other
    one, other = one[kept], other[kept]
    kept = np.argsort(one, kind="stable")
    one, other = one[kept], other[kept]
    kept = _next_to(one, other, points, np.searchsorted(one, np.arange(len(tips) + 1)))
    one, other = one[kept], other[kept]
    target = point_at(cuts.curve[edge], place)
    for side in range(2):
        there = np.hypot(*(target - cuts.ends[2 * edge + side]).T) <= JOINED
        target[there] = cuts.ends[2 * edge[there] + side]
    target = np.concatenate([target, points[other]])
    ends_at = np.where(tips[other] % 2 == 0, 0.0, size[tips[other] // 2])
    tip = np.concatenate([tip, one])
    edge = np.concatenate([edge, tips[other] // 2])
    place = np.concatenate([place, ends_at])
    to_end = np.repeat([False, True], [len(near.curve), len(one)])
    gap = np.hypot(*(target - points[tip]).T)
    # Along a chain an end is no gap away from where it comes from.
    strung = chains(cuts, joints(cuts))
    own = tips[tip] // 2
    inner = strung.begin[edge] + np.where(strung.flipped[edge], size[edge] - place, place)
    begins = strung.first[strung.path[own]] == tips[tip]
    along = np.where(begins, inner, strung.length[strung.path[own]] - inner)
    apart = (strung.path[edge] != strung.path[own]) | (along >= _ROUND * gap)
    keep = np.flatnonzero((gap > JOINED) & (gap <= GAP) & apart & (to_end | (edge != own)))
    keep = keep[np.lexsort((gap[keep], to_end[keep], tip[keep]))]
    new = np.append(True, np.diff(tip[keep]) != 0)[: len(keep)]
    keep = keep[to_end[keep] | new]
    both = np.concatenate([points[tip[keep]], target[keep]], axis=1)
    swap = (both[:, 0] > both[:, 2]) | ((both[:, 0] == both[:, 2]) & (both[:, 1] > both[:, 3]))
    both[swap] = both[swap][:, [2, 3, 0, 1]]
    both = np.unique(both, axis=0)
    return lines(both[:, :2], both[:, 2:])


@kernel
def _next_to(one: I64_1, other: I64_1, points: F64_2, first: I64_1) -> Any:
    """Return of pairs of points, (k,), which have no third one in the lens between them."""
    kept = np.ones(len(one), np.bool_)
    for k in range(len(one)):
        ax, ay = points[one[k], 0], points[one[k], 1]
        bx, by = points[other[k], 0], points[other[k], 1]
        apart = (ax - bx) ** 2 + (ay - by) ** 2
        for place in range(first[one[k]], first[one[k] + 1]):
            x, y = points[other[place], 0], points[other[place], 1]
            if max((x - ax) ** 2 + (y - ay) ** 2, (x - bx) ** 2 + (y - by) ** 2) < apart:
                kept[k] = False
                break
    return kept


def _split(curve: F64) -> tuple[F64, I64, F64]:
    """Return curves split where others end on them or cross them: piece, curve, where it begins."""
    size, nothing = curve[:, 5], np.zeros(len(curve))
    ends = np.stack([point_at(curve, nothing), point_at(curve, size)], axis=1).reshape(-1, 2)
    on = overlaps(lines(ends, ends), curve, nothing, size, JOINED)
    inner = (on.place[:, 0] > JOINED) & (on.place[:, 0] < size[on.edge] - JOINED)
    cross = overlaps(curve, curve, nothing, size, JOINED)
    # Where one of two ends lies on the other they meet there, and do not cross.
    low, high = cross.place.min(axis=1), cross.place.max(axis=1)
    whole = (cross.along[:, 0] > JOINED) & (cross.along[:, 1] < size[cross.curve] - JOINED)
    whole &= (low > JOINED) & (high < size[cross.edge] - JOINED)
    which = np.concatenate([np.arange(len(curve)), on.edge[inner], cross.edge[whole]])
    at = np.concatenate([nothing, on.place[inner, 0], (0.5 * (low + high))[whole]])
    order = np.lexsort((at, which))
    which, at = which[order].astype(np.int64), at[order]
    last = np.append(which[1:] != which[:-1], True)[: len(which)]
    until = np.where(last, size[which], np.append(at[1:], 0.0)[: len(at)])
    some = (until - at > JOINED) | (last & (at == 0.0))
    which, at, until = which[some], at[some], until[some]
    piece = curve[which].copy()
    straight = piece[:, 0] == 0.0
    moved = point_at(piece, at)
    piece[straight, 1:3] = moved[straight]
    turned = piece[:, 0] * at / np.where(straight, 1.0, piece[:, 3])
    piece[~straight, 4] += turned[~straight]
    piece[:, 5] = until - at
    return piece, which, at


def _nested(curve: F64, cycle: I64, outside: Bool, component: I64) -> tuple[I64, int]:
    """Return the face on either side of each piece, 0 outside of all, and how many there are."""
    count = int(component.max()) + 1
    # The leftmost point of each component, at the side of a circle or at an end.
    start, end = point_at(curve, np.zeros(len(curve))), point_at(curve, curve[:, 5])
    side = curve[:, 1:3] - np.stack([curve[:, 3], np.zeros(len(curve))], axis=1)
    turn = (math.pi - curve[:, 4]) * curve[:, 0] % (2.0 * math.pi)
    reaches = (curve[:, 0] != 0.0) & (turn * curve[:, 3] <= curve[:, 5])
    points = np.stack([start, end, np.where(reaches[:, None], side, start)], axis=1)
    leftmost = points[np.arange(len(curve)), points[:, :, 0].argmin(axis=1)]
    order = np.lexsort((leftmost[:, 0], component))
    probe = leftmost[order[np.searchsorted(component[order], np.arange(count))]]
    met, rising = _left_of(probe, np.arange(count), curve, component)
    beside = np.where(met < 0, -1, cycle[met, np.where(rising, 1, 0)])
    # What is met lies farther to the left, so its own surroundings are found before.
    name = np.where(outside, 0, np.cumsum(~outside))
    of = np.zeros(len(outside), np.int64)
    of[cycle] = component[:, None]
    around = _around(np.argsort(probe[:, 0], kind="stable"), beside, outside, of, name)
    face: I64 = np.where(outside, around[of], name)[cycle]
    return face, int((~outside).sum()) + 1


@kernel
def _around(order: I64_1, beside: I64_1, outside: Bool_1, of: I64_1, name: I64_1) -> Any:
    """Return the face round each component, from the walk that lies beside it."""
    around = np.zeros(len(order), np.int64)
    for c in order:
        walk = beside[c]
        if walk >= 0:
            around[c] = around[of[walk]] if outside[walk] else name[walk]
    return around


def _left_of(points: F64, own: I64, curve: F64, owner: I64) -> tuple[I64, Bool]:
    """Return the first curve to the left of each point, -1 for none, and if it rises there.

    Parameters
    ----------
    own : (m,)
        The owner whose curves do not count for each point.
    owner : (n,)
        Of each curve.
    """
    corner, size, shape = laid_out(curve, 0.0)
    met, rising = _looked_left(
        points + np.array([0.0, _ASIDE]), own, curve, owner, corner, size, shape[0], shape[1]
    )
    return met, rising


@kernel(checks_division=True)
def _looked_left(
    points: F64_2,
    own: I64_1,
    curve: F64_2,
    owner: I64_1,
    corner: F64_1,
    size: float,
    wide: int,
    tall: int,
) -> Any:
    first = np.zeros(wide * tall + 1, np.int64)
    seen = np.full(wide * tall, -1, np.int64)
    cells = np.empty(1024, np.int64)
    listed = np.empty(0, np.int32)
    for writes in range(2):
        for i in range(len(curve)):
            cells, many = cells_of(curve[i], 1e-6, corner, size, wide, tall, cells)
            for k in range(many):
                cell = cells[k]
                if seen[cell] == 2 * i + writes:
                    continue
                seen[cell] = 2 * i + writes
                if writes:
                    first[cell] -= 1
                    listed[first[cell]] = i
                else:
                    first[cell] += 1
        if not writes:
            for cell in range(wide * tall):
                first[cell + 1] += first[cell]
            listed = np.empty(first[wide * tall], np.int32)
    met = np.full(len(points), -1, np.int64)
    rising = np.zeros(len(points), np.bool_)
    for p in range(len(points)):
        x, y = points[p, 0], points[p, 1]
        row = math.floor((y - corner[1]) / size)
        if row < 0 or row >= tall:
            continue
        column = min(math.floor((x - corner[0]) / size), wide - 1)
        best = -math.inf
        while column >= 0:
            cell = column * tall + row
            for k in range(first[cell], first[cell + 1]):
                i = listed[k]
                if owner[i] == own[p] and own[p] >= 0:
                    continue
                at, up = _met(curve[i], x, y)
                if at > best:
                    best, met[p], rising[p] = at, i, up
            if met[p] >= 0 and best >= corner[0] + column * size:
                break
            column -= 1
    return met, rising


@kernel(checks_division=True)
def _met(curve: F64_1, x: float, y: float) -> Any:
    """Return where a curve is met first to the left of a point, and whether it rises there."""
    best, up = -math.inf, False
    if curve[0] == 0.0:
        y1 = curve[2] + curve[4] * curve[5]
        if (curve[2] > y) != (y1 > y):
            at = curve[1] + (y - curve[2]) / curve[4] * curve[3]
            if at < x:
                best, up = at, curve[4] > 0.0
        return best, up
    rise = curve[3] * curve[3] - (y - curve[2]) ** 2
    if rise <= 0.0:
        return best, up
    half = math.sqrt(rise)
    for sign in (-1.0, 1.0):
        at = curve[1] + sign * half
        turn = (math.atan2(y - curve[2], sign * half) - curve[4]) * curve[0] % (2.0 * math.pi)
        if best < at < x and turn * curve[3] <= curve[5]:
            # Anticlockwise the right half of a circle rises.
            best, up = at, sign * curve[0] > 0.0
    return best, up


@kernel
def _freed(order: I64_1, complete: F64_1, face: I64_2, count: int) -> Any:
    """Return the line after which each face is loose, infinite for those that stay held.

    ``order`` has the pieces that are done last first.
    """
    free = np.full(count, math.inf)
    parent = np.arange(count)
    onward = np.arange(count)
    for p in order:
        if complete[p] <= 0.0:
            # What only links part from the rest, or pieces that no cutter reaches, is too small.
            break
        a, b = face[p, 0], face[p, 1]
        while parent[a] != a:
            parent[a] = parent[parent[a]]
            a = parent[a]
        while parent[b] != b:
            parent[b] = parent[parent[b]]
            b = parent[b]
        if a == b:
            continue
        if b == 0:
            a, b = b, a
        if a == 0:
            # The faces of b, a ring of them, are held until now.
            each = b
            while True:
                free[each] = complete[p]
                each = onward[each]
                if each == b:
                    break
        onward[a], onward[b] = onward[b], onward[a]
        parent[b] = a
    return free
