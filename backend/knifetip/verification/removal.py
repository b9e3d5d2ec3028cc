"""Removal: what a cutter takes away, a disc of radius r swept along its way, against the parts.

    Edges (closed cuts), Ways, Station -> deviation, overcut, uncut and unreached of every edge

The disc must touch every edge from the side of the waste, and may come no nearer.  So its centre
must run along the edge's own equidistant wherever that is r from everything else; where it is not,
as in a concave corner or a narrow place, nothing can be asked: that length is told as
``unreached``.  Convex corners may be rounded, cut square or anything between.

A cutter that gives way by δx, δy under load is led r - δ from the edge: the centre stands at
P + ((r - δx) n_x, (r - δy) n_y), n towards the waste, and round a convex corner on an ellipse.

Source: the radius paper, equations 1-9; the corner's reach is our derivation.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.machine import Station
from knifetip.model.tool import Cutter
from knifetip.verification.bench import CATCH, DEPTH, Bench
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.findings import MOST
from knifetip.verification.intent import Edges
from knifetip.verification.kinematics import lines, off_line, point_at
from knifetip.verification.outline import Outline, inside, outline
from knifetip.verification.overlap import leftover, overlaps

#: Chords of an equidistant that is no circle stay within this of it (mm).
_CHORD: Final = 1e-4
#: Numbers that differ by less are one number (mm).
_SAME: Final = 1e-9
#: Programs print to half of this (mm).
PRINT: Final = 1e-4


@dataclass(frozen=True, eq=False, slots=True)
class Ways:
    """n ways of the cutter's centre in the board, as in kinematics.Work."""

    curve: F64
    z: F64
    track: I64
    line: I32
    blend: F64

    def taken(self, rows: I64 | Bool) -> Ways:
        """Return some of them."""
        return Ways(
            self.curve[rows], self.z[rows], self.track[rows], self.line[rows], self.blend[rows]
        )


@dataclass(frozen=True, eq=False, slots=True)
class Equidistants:
    """Where the centre should run: k pieces, each beside a stretch of one edge."""

    curve: F64  #: (k, 6)
    edge: I64  #: (k,)
    place: F64  #: (k, 2) mm along the edge at both ends of the piece

    def on_edge(self, piece: I32, place: F64) -> tuple[F64, F64]:
        """Return from where to where along its edge (mm) a stretch, (n, 2) mm, of a piece is."""
        share = place / np.maximum(self.curve[piece, 5], _SAME)[:, None]
        first, last = self.place[piece, 0], self.place[piece, 1]
        at = first[:, None] + (last - first)[:, None] * share
        return at.min(axis=1), at.max(axis=1)


def judge_removal(bench: Bench, edges: Edges, ways: Ways, station: Station, slack: float) -> None:
    """Judge what a cutter removes.

    Parameters
    ----------
    edges
        The cuts.
    slack : mm
        Shorter gaps are none.
    """
    tool = station.tool
    assert isinstance(tool, Cutter)
    give = next((held for held in bench.board.deflection if held.tool == station.name), None)
    reach = np.array([tool.radius, tool.radius]) - ((give.x, give.y) if give else 0.0)
    _Removal(bench, edges, ways, tool, reach, slack).run()


class _Removal:
    """One cutter's ways against all cuts."""

    def __init__(
        self, bench: Bench, edges: Edges, ways: Ways, tool: Cutter, reach: F64, slack: float
    ) -> None:
        self.bench, self.edges, self.ways, self.tool = bench, edges, ways, tool
        self.reach, self.slack, self.tolerance = reach, slack, bench.tolerance
        self.bounds: Outline = outline(edges)
        self.size = edges.curve[:, 5]
        self.rounds = np.where(np.isfinite(ways.blend), ways.blend, 0.0)

    def run(self) -> None:
        deep = self.bench.board.caliper - self.ways.z
        planned = self.bench.board.caliper + self.bench.machine.into_mat
        wrong = deep - planned
        if self.tool.step == 0.0:
            wrong = np.abs(wrong)
        for row in np.flatnonzero(wrong > DEPTH)[:MOST]:
            self._finding(
                "depth",
                -1,
                f"the cutter goes {deep[row]:.3f} mm below the top of the board, where "
                f"{planned:.3f} mm is planned.",
                float(wrong[row]),
                row,
            )
        through = deep >= planned - DEPTH
        pieces = self._equidistants()
        gap_edge, begin, end = self._untouched(pieces, through)
        self._uncut(pieces, gap_edge, begin, end)
        self._too_near()
        self._astray()

    def _finding(self, kind: str, edge: int, text: str, measure: float, row: int = -1) -> None:
        where = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.ways.line[row]) if row >= 0 else -1
        place = f"Cutter, edge {where}: " if where >= 0 else "Cutter: "
        told = f" Line {line}." if line >= 0 else ""
        self.bench.found.add(kind, place + text + told, measure, edge=where, line=line)

    # -- the edges -------------------------------------------------------------------------------

    def _equidistants(self) -> Equidistants:
        """Return the way of the centre beside every edge; an open cut is followed on its line."""
        curve = self.edges.curve
        waste = np.where(self.bounds.board_left, -1.0, 1.0) * self.bounds.closing
        straight = np.flatnonzero(curve[:, 0] == 0.0)
        moved = curve.copy()
        u = curve[straight, 3:5]
        n = np.stack([-u[:, 1], u[:, 0]], axis=1) * waste[straight, None]
        moved[straight, 1:3] += n * self.reach
        edge = np.arange(len(curve))
        place = np.stack([np.zeros(len(curve)), self.size], axis=1)
        bent = np.flatnonzero(curve[:, 0] != 0.0)
        # To its left an arc to the left has its centre.
        grows = -curve[bent, 0] * waste[bent]
        if self.reach[0] == self.reach[1]:
            radius = curve[bent, 3] + grows * self.reach[0]
            moved[bent, 3] = radius
            moved[bent, 5] *= radius / curve[bent, 3]
            fits = np.ones(len(curve), np.bool_)
            # No disc fits into an arc that is tighter than itself.
            fits[bent[radius <= _SAME]] = False
            return Equidistants(moved[fits], edge[fits], place[fits])
        pieces = [Equidistants(moved[straight], edge[straight], place[straight])]
        for row, sign in zip(bent, grows, strict=True):
            pieces.append(self._elliptic(int(row), float(sign)))
        return Equidistants(
            np.concatenate([piece.curve for piece in pieces]),
            np.concatenate([piece.edge for piece in pieces]),
            np.concatenate([piece.place for piece in pieces]),
        )

    def _elliptic(self, row: int, grows: float) -> Equidistants:
        """Return chords of the ellipse that runs beside an arc where δx and δy differ."""
        curve = self.edges.curve[row]
        axes = curve[3] + grows * self.reach
        sweep = curve[5] / curve[3]
        count = max(1, int(np.ceil(sweep * np.sqrt(max(axes.max(), 1.0) / (8.0 * _CHORD)))))
        at = np.linspace(0.0, curve[5], count + 1)
        angle = curve[4] + curve[0] * at / curve[3]
        points = curve[1:3] + axes * np.stack([np.cos(angle), np.sin(angle)], axis=1)
        fits = slice(0, count if (axes > _SAME).all() else 0)
        return Equidistants(
            lines(points[:-1], points[1:])[fits],
            np.full(count, row)[fits],
            np.stack([at[:-1], at[1:]], axis=1)[fits],
        )

    def _untouched(self, pieces: Equidistants, through: Bool) -> tuple[I64, F64, F64]:
        """Return the stretches of edges beside which no centre has run: edge, from, to (mm)."""
        ways = self.ways.taken(through)
        rounds = ways.blend
        length = pieces.curve[:, 5]
        rows = overlaps(ways.curve, pieces.curve, np.zeros(len(length)), length, self.tolerance)
        edge = pieces.edge[rows.edge]
        figure = rows.distance + rounds[rows.curve]
        # What comes from farther off, or goes there, leads in or out.
        runs = rows.best & (rows.distance < 0.99 * self.tolerance)
        shown = np.where(np.isfinite(figure), figure, rows.distance)[runs]
        np.maximum.at(self.bench.figures.deviation, self.edges.row[edge[runs]], shown)
        low, high = pieces.on_edge(rows.edge, rows.place)
        first, last = pieces.on_edge(rows.edge, rows.place[:, [0, 0]])[0], rows.place[:, [1, 1]]
        for side, at in ((0, first), (1, pieces.on_edge(rows.edge, last)[0])):
            off = off_line(ways.curve[rows.curve], rows.along[:, side], pieces.curve[rows.edge])
            self.bench.samples.append(
                (self.edges.row[edge[runs]], (at / self.size[edge])[runs], off[runs])
            )
        along = np.abs(np.diff(rows.place)[:, 0]) > self.tolerance
        for row in np.flatnonzero(runs & along & (figure > self.tolerance + 1e-9))[:MOST]:
            self.bench.found.add(
                "deviation",
                f"Cutter, edge {self.edges.row[edge[row]]}: the centre is {rows.distance[row]:.4f} "
                f"mm off its way and the controller may round {rounds[rows.curve[row]]:.4f} mm "
                f"more; the tolerance is {self.tolerance:g} mm. Line {ways.line[rows.curve[row]]}.",
                float(figure[row]) if np.isfinite(figure[row]) else float(rows.distance[row]),
                edge=int(self.edges.row[edge[row]]),
                line=int(ways.line[rows.curve[row]]),
            )
        # An open cut may begin and end its disc at the ends of the line.
        short = np.where(self.bounds.closing, 0.0, self.tool.radius)
        every = np.arange(len(self.edges))
        return gaps(
            np.concatenate([edge, every, every]),
            np.concatenate([low, np.zeros(len(every)), self.size - short]),
            np.concatenate([high, np.minimum(short, self.size), self.size]),
            self.size,
        )

    def _uncut(self, pieces: Equidistants, edge: I64, begin: F64, end: F64) -> None:
        """Judge what is not touched: either nothing could touch it, or it is left uncut."""
        blocked_edge, low, high = self._blocked(pieces)
        # What is left of the gaps when the blocked stretches are filled in too.
        touched_edge, first, last = gaps(edge, begin, end, self.size)
        left_edge, left_begin, left_end = gaps(
            np.concatenate([blocked_edge, touched_edge]),
            np.concatenate([low, first]),
            np.concatenate([high, last]),
            self.size,
        )
        missed = left_end - left_begin
        figures, row = self.bench.figures, self.edges.row
        np.add.at(figures.unreached, row[edge], end - begin)
        np.subtract.at(figures.unreached, row[left_edge], missed)
        bare = missed > self.slack
        np.add.at(figures.uncut, row[left_edge[bare]], missed[bare])
        for k in np.flatnonzero(bare)[:MOST]:
            self._finding(
                "uncut",
                int(left_edge[k]),
                f"{missed[k]:.3f} mm of it are not cut, beginning {left_begin[k]:.3f} mm from its "
                "start.",
                float(missed[k]),
            )

    def _blocked(self, pieces: Equidistants) -> tuple[I64, F64, F64]:
        """Return the stretches of edges beside which the disc would cut another: edge, from, to."""
        closing = np.flatnonzero(self.bounds.closing)
        curve = self.edges.curve[closing]
        near = float(self.reach.min())
        # Where a cutter gives way more along one axis, a corner is reached by that less.
        wide = float(self.reach.max()) + self.tolerance
        rows = overlaps(pieces.curve, curve, np.zeros(len(curve)), curve[:, 5], wide)
        own = pieces.edge[rows.curve]
        other = own != closing[rows.edge]
        low, high = pieces.on_edge(rows.curve[other], rows.along[other])
        edge = [own[other]]
        lows, highs = [low], [high]
        # Corners that stand out into the waste block too.
        corner = self.edges.ends[np.repeat(self.bounds.closing, 2)]
        met = overlaps(
            lines(corner, corner),
            pieces.curve,
            np.zeros(len(pieces.curve)),
            pieces.curve[:, 5],
            near,
        )
        begin, end = within(pieces.curve[met.edge], corner[met.curve], near - 0.5 * self.tolerance)
        some = end > begin
        low, high = pieces.on_edge(met.edge[some], np.stack([begin[some], end[some]], axis=1))
        edge.append(pieces.edge[met.edge[some]])
        lows.append(low)
        highs.append(high)
        # Where there is no equidistant nothing can be touched.
        missing = np.setdiff1d(np.arange(len(self.edges)), pieces.edge)
        edge.append(missing)
        lows.append(np.zeros(len(missing)))
        highs.append(self.size[missing])
        return np.concatenate(edge), np.concatenate(lows), np.concatenate(highs)

    # -- the ways --------------------------------------------------------------------------------

    def _too_near(self) -> None:
        """Judge whether the disc has cut into a part."""
        closing = np.flatnonzero(self.bounds.closing)
        curve = self.edges.curve[closing]
        widest = float(self.reach.max())
        rows = overlaps(self.ways.curve, curve, np.zeros(len(curve)), curve[:, 5], widest)
        way, edge = rows.curve, rows.edge
        # Beside an open cut both sides lose half of the disc, at the outline too.
        along = self._on_open_cuts()
        into = np.zeros(len(way))
        for at in _nearest(self.ways.curve[way], rows.along, curve[edge], self._round):
            into = np.maximum(into, self._into(point_at(self.ways.curve[way], at), curve[edge]))
        self._overcut(closing[edge], way, np.where(along[way], 0.0, into))

        corner = self.edges.ends[np.repeat(self.bounds.closing, 2)]
        met = overlaps(
            lines(corner, corner),
            self.ways.curve,
            np.zeros(len(self.ways.z)),
            self.ways.curve[:, 5],
            widest,
        )
        touched = met.edge
        near = np.full(len(touched), np.inf)
        for share in np.linspace(0.0, 1.0, 2 if self._round else 33):
            off = point_at(self.ways.curve[touched], share * self.ways.curve[touched, 5])
            near = np.minimum(near, np.hypot(*((off - corner[met.curve]) / self.reach).T))
        foot = self._foot(self.ways.curve[touched], corner[met.curve])
        off = point_at(self.ways.curve[touched], foot)
        near = np.minimum(near, np.hypot(*((off - corner[met.curve]) / self.reach).T))
        into = np.where(along[touched], 0.0, (1.0 - near) * float(self.reach.min()))
        at_corner = np.repeat(closing, 2)[met.curve]
        self._overcut(at_corner, touched, into)

    def _on_open_cuts(self) -> Bool:
        """Return which ways follow a cut that encloses nothing."""
        own = self.edges.curve[~self.bounds.closing]
        rows = overlaps(self.ways.curve, own, np.zeros(len(own)), own[:, 5], self.tolerance)
        size = np.diff(rows.along)[:, 0] >= 0.5 * self.ways.curve[rows.curve, 5]
        result = np.zeros(len(self.ways.z), np.bool_)
        result[rows.curve[size]] = True
        return result

    @property
    def _round(self) -> bool:
        return bool(self.reach[0] == self.reach[1])

    def _foot(self, curve: F64, point: F64) -> F64:
        """Return where on curves they come nearest to points, told in half-axes (mm along)."""
        weight = 1.0 / self.reach**2
        to = point - curve[:, 1:3]
        straight = curve[:, 0] == 0.0
        u = curve[:, 3:5]
        line = (weight * to * u).sum(axis=1) / np.where(
            straight, np.maximum((weight * u * u).sum(axis=1), _SAME), 1.0
        )
        turned = curve[:, 0] * (np.arctan2(to[:, 1], to[:, 0]) - curve[:, 4])
        middle = 0.5 * curve[:, 5] / np.where(straight, 1.0, curve[:, 3])
        turned = (turned - middle + np.pi) % (2.0 * np.pi) - np.pi + middle
        at = np.where(straight, line, turned * curve[:, 3])
        result: F64 = np.clip(at, 0.0, curve[:, 5])
        return result

    def _into(self, points: F64, edge: F64) -> F64:
        """Return how far a disc at points reaches past edges (mm), as far as it gives way."""
        to = points - edge[:, 1:3]
        straight = edge[:, 0] == 0.0
        normal = np.where(straight[:, None], edge[:, [4, 3]] * (-1.0, 1.0), 0.0)
        off = np.abs((normal * to).sum(axis=1))
        flat = (normal**2 * self.reach).sum(axis=1) - off
        # Beside an arc the centre's way is an ellipse with these half-axes.
        away = np.hypot(*to.T)
        outer = away >= edge[:, 3]
        axes = edge[:, 3, None] + np.where(outer, 1.0, -1.0)[:, None] * self.reach
        scaled = np.hypot(*(to / np.where(np.abs(axes) > _SAME, axes, _SAME)).T)
        size = np.abs(axes).min(axis=1)
        bent = np.where(outer, 1.0 - scaled, scaled - 1.0) * size
        # A disc wider than the arc that it is in.
        bent = np.where(~outer & (axes <= _SAME).any(axis=1), self.reach.max(), bent)
        result: F64 = np.where(straight, flat, bent)
        return result

    def _overcut(self, edge: I64, way: I32 | I64, into: F64) -> None:
        into = np.where(into > _SAME, into, 0.0)
        figure = into + np.where(into > 0.0, self.rounds[way], 0.0)
        row = self.edges.row[edge]
        np.maximum.at(self.bench.figures.overcut, row, np.where(into > PRINT, into, 0.0))
        bad = np.flatnonzero(figure > self.tolerance + PRINT)
        # Of one way at one edge the worst is told.
        bad = bad[np.argsort(-into[bad], kind="stable")]
        told = np.unique(np.stack([edge[bad], way[bad]], axis=1), axis=0, return_index=True)[1]
        for k in bad[np.sort(told)][:MOST]:
            self._finding(
                "overcut",
                int(edge[k]),
                f"the cutter takes {into[k]:.3f} mm off the part.",
                float(into[k]),
                int(way[k]),
            )

    def _astray(self) -> None:
        """Judge work in the middle of a part, and work far from every edge."""
        ways = self.ways
        first = np.unique(ways.track, return_index=True)[1]
        middle = 0.5 * ways.curve[first, 5]
        depth = inside(point_at(ways.curve[first], middle), self.bounds)
        slits = np.zeros(int(ways.track.max(initial=-1)) + 1, np.bool_)
        slits[ways.track[self._on_open_cuts()]] = True
        for row in first[(depth % 2 == 1) & ~slits[ways.track[first]]][:MOST]:
            x, y = point_at(ways.curve[row : row + 1], np.zeros(1))[0]
            self._finding(
                "stray",
                -1,
                f"the cutter works at X{x:.3f} Y{y:.3f} of the sheet, inside a part.",
                float(ways.curve[row, 5]),
                int(row),
            )
        far = 2.0 * self.tool.radius + max(self.tool.set_up, CATCH)
        near = overlaps(ways.curve, self.edges.curve, np.zeros(len(self.edges)), self.size, far)
        ends = overlaps(
            lines(self.edges.ends, self.edges.ends),
            ways.curve,
            np.zeros(len(ways.z)),
            ways.curve[:, 5],
            far,
        )
        near_corner = np.zeros(len(ways.z), np.bool_)
        near_corner[ends.edge] = True
        which, spans = leftover(near, ways.curve)
        lost = (np.diff(spans)[:, 0] > self.slack) & ~near_corner[which]
        for k in np.flatnonzero(lost)[:MOST]:
            x, y = point_at(ways.curve[which[k : k + 1]], spans[k, :1])[0]
            self._finding(
                "stray",
                -1,
                f"the cutter works at X{x:.3f} Y{y:.3f} of the sheet, where no edge asks for it.",
                float(spans[k, 1] - spans[k, 0]),
                int(which[k]),
            )


def gaps(edge: I64, low: F64, high: F64, size: F64) -> tuple[I64, F64, F64]:
    """Return what stretches leave bare of edges: edge, from, to (mm).

    Parameters
    ----------
    edge, low, high : (n,) index and mm
        Stretches in any order.
    size : (m,) mm
        Length of every edge.
    """
    every = np.arange(len(size))
    edge = np.concatenate([edge, every])
    low, high = np.concatenate([low, size]), np.concatenate([high, size])
    order = np.lexsort((high, low, edge))
    edge, low, high = edge[order], np.maximum(low[order], 0.0), high[order]
    # One running maximum for all edges: each stands on its own step.
    step = edge * (2.0 * float(size.max(initial=0.0)) + 1.0)
    reached = np.maximum.accumulate(np.minimum(high, size[edge]) + step) - step
    before = np.concatenate([[0.0], reached[:-1]])
    new = np.ones(len(edge), np.bool_)
    new[1:] = edge[1:] != edge[:-1]
    before[new] = 0.0
    bare = low - before > _SAME
    return edge[bare].astype(np.int64), before[bare], low[bare]


def within(curve: F64, point: F64, limit: float) -> tuple[F64, F64]:
    """Return from where to where (mm) curves are within a distance of points; to < from if never.

    One stretch is told: an arc of more than half a turn may have another one round its back.
    """
    to = point - curve[:, 1:3]
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    foot = (to * curve[:, 3:5]).sum(axis=1)
    square = limit**2 - np.where(straight, (to**2).sum(axis=1) - foot**2, 0.0)
    away = np.maximum(np.hypot(*to.T), _SAME)
    cosine = (radius**2 + away**2 - limit**2) / (2.0 * radius * away)
    turn = np.arccos(np.clip(cosine, -1.0, 1.0)) * radius
    turned = curve[:, 0] * (np.arctan2(to[:, 1], to[:, 0]) - curve[:, 4])
    middle = 0.5 * curve[:, 5] / radius
    turned = ((turned - middle + np.pi) % (2.0 * np.pi) - np.pi + middle) * radius
    at = np.where(straight, foot, turned)
    half = np.where(straight, np.sqrt(np.maximum(square, 0.0)), turn)
    half = np.where(np.where(straight, square <= 0.0, cosine >= 1.0), -1.0, half)
    low = np.where(half < 0.0, 1.0, np.maximum(at - half, 0.0))
    return low, np.where(half < 0.0, 0.0, np.minimum(at + half, curve[:, 5]))


def _nearest(curve: F64, along: F64, edge: F64, round_: bool) -> Iterator[F64]:
    """Yield places along curves (mm), within stretches, where they may be nearest to edges."""
    low, high = along.T
    yield low
    yield high
    straight, flat = curve[:, 0] == 0.0, edge[:, 0] == 0.0
    to = edge[:, 1:3] - curve[:, 1:3]
    foot = np.where(straight, (to * curve[:, 3:5]).sum(axis=1), 0.0)
    square = np.arctan2(edge[:, 3], -edge[:, 4])
    towards = np.where(flat, square, np.arctan2(to[:, 1], to[:, 0]))
    for half in (0.0, np.pi):
        turned = curve[:, 0] * (towards + half - curve[:, 4]) % (2.0 * np.pi)
        yield np.clip(np.where(straight, foot, turned * curve[:, 3]), low, high)
    if not round_:
        for share in np.linspace(0.0, 1.0, 9)[1:-1]:
            yield low + (high - low) * share
