"""Removal: what a cutter takes away, a disc of radius r swept along its way, against parts.

    Edges (closed cuts), CentrePaths, Station -> deviation, overcut, uncut, unreached of edges

The disc must touch every edge from the side of the waste, and may come no nearer.  So its centre
must run along the edge's own equidistant wherever that is r from everything else; where it is not,
as in a concave corner or a narrow place, nothing can be asked: that length is told as
``unreached``.  Convex corners may be rounded, cut square or anything between.

A cutter that gives way by δx, δy under load is led r - δ from the edge: the centre stands at
P + ((r - δx) n_x, (r - δy) n_y), n towards the waste, and round a convex corner on an ellipse.

Source: the radius paper, equations 1-9; the corner's reach is our derivation.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Station
from knifetip.verification.checks import milling_geometry
from knifetip.verification.checks.bridge_check import check_bridges, order_bridges
from knifetip.verification.checks.check_context import DEPTH_TOLERANCE, NEAR_EDGE, CheckContext
from knifetip.verification.checks.milling_geometry import spans_near_points
from knifetip.verification.checks.pass_depth import too_deep_spans
from knifetip.verification.checks.unreached_areas import unreached_areas
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import left_distance, line_curves, point_at
from knifetip.verification.curves.intervals import EPSILON, uncovered_curves, uncovered_edges
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.cutter_paths import CutterPaths, cutter_paths
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.expectation.expected_work import knife_ends
from knifetip.verification.expectation.outline import CutOutlines, count_enclosing, find_outlines
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import Disc, expected_tool

#: Programs print to half of this (mm).
PRINT_ROUNDING: Final = 1e-4


@dataclass(frozen=True, eq=False, slots=True)
class CentrePaths:
    """n ways of the cutter's centre in the board, as in kinematics.Work."""

    curve: F64
    z: F64
    track: I64
    line: I32
    blend: F64

    def taken(self, rows: I64 | Bool) -> CentrePaths:
        """Return some of them."""
        return CentrePaths(
            self.curve[rows], self.z[rows], self.track[rows], self.line[rows], self.blend[rows]
        )


def check_milling(
    bench: CheckContext, edges: Edges, ways: CentrePaths, station: Station, slack: float
) -> None:
    """Judge what a cutter removes.

    Parameters
    ----------
    edges
        The cuts.
    slack : mm
        Shorter gaps are none.
    """
    tool = expected_tool(station.tool)
    assert tool.disc is not None
    planned = tool.through_depth(bench.board.caliper, bench.machine.into_mat)
    give = next((held for held in bench.board.deflection if held.tool == station.name), None)
    reach = np.array([tool.disc.radius, tool.disc.radius]) - ((give.x, give.y) if give else 0.0)
    _MillingCheck(bench, edges, ways, tool.disc, reach, slack).run(planned)


class _MillingCheck:
    """One cutter's ways against all cuts."""

    def __init__(
        self,
        bench: CheckContext,
        edges: Edges,
        ways: CentrePaths,
        tool: Disc,
        reach: F64,
        slack: float,
    ) -> None:
        self.bench, self.edges, self.ways, self.tool = bench, edges, ways, tool
        self.reach, self.slack, self.tolerance = reach, slack, bench.tolerance
        self.bounds: CutOutlines = find_outlines(edges)
        self.size = edges.curve[:, 5]
        self.rounds = np.where(np.isfinite(ways.blend), ways.blend, 0.0)

    def run(self, planned: float) -> None:
        """Judge the work, which goes ``planned`` mm below the top face."""
        deep = self.bench.board.caliper - self.ways.z
        wrong = deep - planned
        if self.tool.step == 0.0:
            wrong = np.abs(wrong)
        for row in np.flatnonzero(wrong > DEPTH_TOLERANCE)[:MAX_FINDINGS]:
            self._finding(
                "depth",
                -1,
                Message("verify.wrong-depth", tool="cutter", depth=deep[row], planned=planned),
                float(wrong[row]),
                row,
            )
        self._stepped(deep)
        through = deep >= planned - DEPTH_TOLERANCE
        pieces = cutter_paths(self.bounds, self.reach)
        gap_edge, begin, end = self._untouched(pieces, through)
        self._uncut(pieces, gap_edge, begin, end)
        self._too_near()
        self._past_open_ends()
        self._astray()

    def _stepped(self, deep: F64) -> None:
        """Judge whether no pass goes deeper at once than the cutter bears."""
        if self.tool.step == 0.0:
            return
        which, spans = too_deep_spans(self.ways.curve, deep, self.tool.step, self.tolerance)
        size = np.diff(spans)[:, 0]
        for k in np.flatnonzero(size > self.slack)[:MAX_FINDINGS]:
            row = int(which[k])
            self._finding(
                "depth",
                -1,
                Message(
                    "verify.pass-too-deep",
                    tool="cutter",
                    depth=deep[row],
                    length=size[k],
                    step=self.tool.step,
                ),
                float(deep[row] - self.tool.step),
                row,
            )

    def _finding(
        self, kind: str, edge: int, message: Message, measure: float, row: int = -1
    ) -> None:
        where = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.ways.line[row]) if row >= 0 else -1
        self.bench.found.add(kind, message, measure, edge=where, line=line)

    # -- the edges -------------------------------------------------------------------------------

    def _untouched(self, pieces: CutterPaths, through: Bool) -> tuple[I64, F64, F64]:
        """Return the stretches of edges beside which no centre has run: edge, from, to (mm)."""
        ways = self.ways.taken(through)
        rounds = ways.blend
        length = pieces.curve[:, 5]
        rows = find_overlaps(
            ways.curve, pieces.curve, np.zeros(len(length)), length, self.tolerance
        )
        edge = pieces.edge[rows.edge]
        figure = rows.distance + rounds[rows.curve]
        # What comes from farther off, or goes there, leads in or out.
        runs = rows.best & (rows.distance < 0.99 * self.tolerance)
        shown = np.where(np.isfinite(figure), figure, rows.distance)[runs]
        np.maximum.at(self.bench.figures.deviation, self.edges.row[edge[runs]], shown)
        low, high = pieces.on_edge(rows.edge, rows.place)
        first, last = pieces.on_edge(rows.edge, rows.place[:, [0, 0]])[0], rows.place[:, [1, 1]]
        for side, at in ((0, first), (1, pieces.on_edge(rows.edge, last)[0])):
            off = left_distance(
                ways.curve[rows.curve], rows.along[:, side], pieces.curve[rows.edge]
            )
            self.bench.samples.append(
                (self.edges.row[edge[runs]], (at / self.size[edge])[runs], off[runs])
            )
        along = np.abs(np.diff(rows.place)[:, 0]) > self.tolerance
        for row in np.flatnonzero(runs & along & (figure > self.tolerance + 1e-9))[:MAX_FINDINGS]:
            self.bench.found.add(
                "deviation",
                Message(
                    "verify.centre-off-path",
                    distance=rows.distance[row],
                    rounding=rounds[rows.curve[row]],
                    tolerance=self.tolerance,
                ),
                float(figure[row]) if np.isfinite(figure[row]) else float(rows.distance[row]),
                edge=int(self.edges.row[edge[row]]),
                line=int(ways.line[rows.curve[row]]),
            )
        return uncovered_edges(edge, low, high, self.size)

    def _uncut(self, pieces: CutterPaths, edge: I64, begin: F64, end: F64) -> None:
        """Judge what is not touched: either nothing could touch it, or it is left uncut."""
        blocked_edge, low, high = self._blocked(pieces)
        # What is left of the gaps when the blocked stretches are filled in too.
        touched_edge, first, last = uncovered_edges(edge, begin, end, self.size)
        left_edge, left_begin, left_end = uncovered_edges(
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
        # Standing so far before a stretch that is blocked, the disc still reaches up to it.
        beside = float(np.sqrt(2.0 * self.reach.max() * self.tolerance))
        for k in np.flatnonzero(bare & (missed <= beside)):
            mine = blocked_edge == left_edge[k]
            before = (np.abs(high[mine] - left_begin[k]) < EPSILON).any()
            after = (np.abs(low[mine] - left_end[k]) < EPSILON).any()
            bare[k] = before == after
        reached = ~np.isin(edge, left_edge[bare])
        self.bench.unreached.append(
            unreached_areas(self.bounds, edge[reached], begin[reached], end[reached], self.reach)
        )
        bare &= ~self._bridges(left_edge, left_begin, left_end)
        np.add.at(figures.uncut, row[left_edge[bare]], missed[bare])
        for k in np.flatnonzero(bare)[:MAX_FINDINGS]:
            self._finding(
                "uncut",
                int(left_edge[k]),
                Message(
                    "verify.not-worked",
                    length=missed[k],
                    work=Message("verify.work-cut"),
                    where=Message("verify.where-from-start", place=left_begin[k]),
                ),
                float(missed[k]),
            )

    def _bridges(self, edge: I64, begin: F64, end: F64) -> Bool:
        """Judge the bridges among stretches that are not touched, and return which they are.

        Between the discs on either side a bridge is 2r narrower than the centre's way is open.
        """
        board = self.bench.board
        if board.bridge_width <= 0.0 or board.bridge_spacing <= 0.0:
            return np.zeros(len(edge), np.bool_)
        curve = self.edges.curve[edge]
        bent = curve[:, 0] != 0.0
        waste = np.where(self.bounds.board_left[edge], -1.0, 1.0)
        # Beside an arc the centre's way is longer or shorter than the edge.
        grows = np.where(bent, -curve[:, 0] * waste, 0.0) * self.tool.radius
        scale = 1.0 + grows / np.where(bent, curve[:, 3], 1.0)
        width = (end - begin) * scale - 2.0 * self.tool.radius
        paths = knife_ends(self.edges, self.edges, 0.0, 0.0, self.bounds.outer).paths
        rounds = paths.first < 0
        rounds[paths.path[~self.bounds.outer]] = False
        is_bridge = rounds[paths.path[edge]] & (width > 0.0)
        edge, width = edge[is_bridge], width[is_bridge]
        begin, end = begin[is_bridge], end[is_bridge]

        path, place, bare = paths.path[edge], 0.5 * (begin + end), end - begin
        middle = paths.begin[edge] + np.where(paths.flipped[edge], self.size[edge] - place, place)
        np.add.at(self.bench.figures.setback, self.edges.row[edge], bare)
        found = order_bridges(path, middle, width, bare, bare, paths.length)
        for kind, at, message, measure in check_bridges(
            found, paths, self.edges, rounds, board, self.slack
        ):
            self._finding(kind, at, message, measure)
        return is_bridge

    def _blocked(self, pieces: CutterPaths) -> tuple[I64, F64, F64]:
        """Return the stretches of edges beside which the disc would cut another: edge, from, to."""
        closing = np.flatnonzero(self.bounds.closing)
        curve = self.edges.curve[closing]
        near = float(self.reach.min())
        # Where a cutter gives way more along one axis, a corner is reached by that less.
        wide = float(self.reach.max()) + self.tolerance
        rows = find_overlaps(pieces.curve, curve, np.zeros(len(curve)), curve[:, 5], wide)
        own = pieces.edge[rows.curve]
        other = own != closing[rows.edge]
        low, high = pieces.on_edge(rows.curve[other], rows.along[other])
        edge = [own[other]]
        lows, highs = [low], [high]
        # Corners that stand out into the waste block too.
        corner = self.edges.ends[np.repeat(self.bounds.closing, 2)]
        met = find_overlaps(
            line_curves(corner, corner),
            pieces.curve,
            np.zeros(len(pieces.curve)),
            pieces.curve[:, 5],
            near,
        )
        begin, end = spans_near_points(
            pieces.curve[met.edge], corner[met.curve], near - 0.5 * self.tolerance
        )
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
        rows = find_overlaps(self.ways.curve, curve, np.zeros(len(curve)), curve[:, 5], widest)
        way, edge = rows.curve, rows.edge
        # Beside an open cut both sides lose half of the disc, at the outline too.
        along = self._on_open_cuts()
        into = np.zeros(len(way))
        sides = np.zeros((2, len(way)))
        for at in milling_geometry.nearest_candidates(
            self.ways.curve[way], rows.along, curve[edge], self._round
        ):
            into = np.maximum(
                into,
                milling_geometry.disc_penetration(
                    point_at(self.ways.curve[way], at), curve[edge], self.reach
                ),
            )
            off = left_distance(self.ways.curve[way], at, curve[edge])
            sides = np.stack([np.minimum(sides[0], off), np.maximum(sides[1], off)])
        # What comes out on the other side of an edge has gone through it.
        crosses = (sides[0] < -EPSILON) & (sides[1] > EPSILON)
        into = np.where(crosses, np.maximum(into, self.reach.min()), into)
        self._overcut(closing[edge], way, np.where(along[way], 0.0, into))

        corner = self.edges.ends[np.repeat(self.bounds.closing, 2)]
        met = find_overlaps(
            line_curves(corner, corner),
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
        foot = milling_geometry.nearest_along(
            self.ways.curve[touched], corner[met.curve], self.reach
        )
        off = point_at(self.ways.curve[touched], foot)
        near = np.minimum(near, np.hypot(*((off - corner[met.curve]) / self.reach).T))
        into = np.where(along[touched], 0.0, (1.0 - near) * float(self.reach.min()))
        at_corner = np.repeat(closing, 2)[met.curve]
        self._overcut(at_corner, touched, into)

    def _on_open_cuts(self) -> Bool:
        """Return which ways follow a cut that encloses nothing."""
        own = self.edges.curve[~self.bounds.closing]
        rows = find_overlaps(self.ways.curve, own, np.zeros(len(own)), own[:, 5], self.tolerance)
        size = np.diff(rows.along)[:, 0] >= 0.5 * self.ways.curve[rows.curve, 5]
        result = np.zeros(len(self.ways.z), np.bool_)
        result[rows.curve[size]] = True
        return result

    def _past_open_ends(self) -> None:
        """Judge whether what follows an open cut stops where that ends."""
        rows = np.flatnonzero(self._on_open_cuts())
        own = self.edges.curve[~self.bounds.closing]
        curve = self.ways.curve[rows]
        near = find_overlaps(curve, own, np.zeros(len(own)), own[:, 5], self.tolerance)
        which, spans = uncovered_curves(near, curve)
        size = np.diff(spans)[:, 0]
        for k in np.flatnonzero(size > self.slack)[:MAX_FINDINGS]:
            self._finding(
                "overcut",
                -1,
                Message("verify.past-open-cut", length=size[k]),
                float(size[k]),
                int(rows[which[k]]),
            )

    @property
    def _round(self) -> bool:
        return bool(self.reach[0] == self.reach[1])

    def _overcut(self, edge: I64, way: I32 | I64, into: F64) -> None:
        into = np.where(into > EPSILON, into, 0.0)
        figure = into + np.where(into > 0.0, self.rounds[way], 0.0)
        row = self.edges.row[edge]
        np.maximum.at(self.bench.figures.overcut, row, np.where(into > PRINT_ROUNDING, into, 0.0))
        bad = np.flatnonzero(figure > self.tolerance + PRINT_ROUNDING)
        # Of one way at one edge the worst is told.
        bad = bad[np.argsort(-into[bad], kind="stable")]
        told = np.unique(np.stack([edge[bad], way[bad]], axis=1), axis=0, return_index=True)[1]
        for k in bad[np.sort(told)][:MAX_FINDINGS]:
            self._finding(
                "overcut",
                int(edge[k]),
                Message("verify.cuts-part", depth=into[k]),
                float(into[k]),
                int(way[k]),
            )

    def _astray(self) -> None:
        """Judge work in the middle of a part, and work far from every edge."""
        ways = self.ways
        first = np.unique(ways.track, return_index=True)[1]
        middle = 0.5 * ways.curve[first, 5]
        depth = count_enclosing(point_at(ways.curve[first], middle), self.bounds)
        slits = np.zeros(int(ways.track.max(initial=-1)) + 1, np.bool_)
        slits[ways.track[self._on_open_cuts()]] = True
        for row in first[(depth % 2 == 1) & ~slits[ways.track[first]]][:MAX_FINDINGS]:
            x, y = point_at(ways.curve[row : row + 1], np.zeros(1))[0]
            self._finding(
                "stray",
                -1,
                Message("verify.inside-part", x=x, y=y),
                float(ways.curve[row, 5]),
                int(row),
            )
        far = 2.0 * self.tool.radius + max(self.tool.set_up, NEAR_EDGE)
        near = find_overlaps(
            ways.curve, self.edges.curve, np.zeros(len(self.edges)), self.size, far
        )
        ends = find_overlaps(
            line_curves(self.edges.ends, self.edges.ends),
            ways.curve,
            np.zeros(len(ways.z)),
            ways.curve[:, 5],
            far,
        )
        low, high = spans_near_points(ways.curve[ends.edge], self.edges.ends[ends.curve], far)
        some = high > low
        which, begin, end = uncovered_edges(
            np.concatenate([near.curve, ends.edge[some]]).astype(np.int64),
            np.concatenate([near.along[:, 0], low[some]]),
            np.concatenate([near.along[:, 1], high[some]]),
            ways.curve[:, 5],
        )
        lost = end - begin > self.slack
        for k in np.flatnonzero(lost)[:MAX_FINDINGS]:
            x, y = point_at(ways.curve[which[k : k + 1]], begin[k : k + 1])[0]
            self._finding(
                "stray",
                -1,
                Message("verify.stray", tool="cutter", length=end[k] - begin[k], x=x, y=y),
                float(end[k] - begin[k]),
                int(which[k]),
            )
