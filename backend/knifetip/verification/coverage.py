"""Coverage: the work of one trade against its edges, both ways round.

    Work, Edges -> deviation, overcut, uncut and setback of every edge, and the findings

Every stretch of work must lie on an edge of the right line type, between the places where the
tip may begin and stop there; every edge must be worked between those places.  What is within the
tolerance of the drawn line counts as on it.

Heading: a tool that reaches ρ from its tip (the blade's width, half the wheel's contact, a
V-cutter's whole edge) swings by 2 ρ sin(ΔC / 2) when it is turned by ΔC off the drawn line; that
must not be more than the tolerance.  A wheel's ΔC is the remainder of 180°, the others' of 360°.
"""

from __future__ import annotations

import math
from dataclasses import replace
from typing import Final, TypeVar

import numpy as np

from knifetip.model.dieline import LineType
from knifetip.model.tool import CreaseWheel, Cutter, Knife, VCutter
from knifetip.verification.bench import CATCH, DEPTH, PLACE, PRINTED, Bench
from knifetip.verification.bridges import bridges, near_corner
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.findings import MOST
from knifetip.verification.folds import at_places, doubled, joined, parted, rolled_gaps
from knifetip.verification.intent import (
    JOINED,
    TOUCHING,
    WORKED,
    Chains,
    Edges,
    KnifeEnds,
    apart,
    creases,
    drawn_once,
    knife_ends,
    pairs_within,
    run_on,
    straight_on,
)
from knifetip.verification.kinematics import Trade, Work, azimuth_at, lines, off_line, point_at
from knifetip.verification.outline import inside, outline, run_outs
from knifetip.verification.overlap import BRIEF, Rows, leftover, narrowed, nearest_until, overlaps
from knifetip.verification.removal import Ways, gaps, judge_removal

#: A bridge stays this far from a sharp corner (mm), and no part hangs by fewer.
CLEAR: Final = 5.0
FEWEST: Final = 2

Held = TypeVar("Held", Knife, CreaseWheel, VCutter)


def compare(bench: Bench, work: Work) -> None:
    """Compare all work with all edges, trade by trade and station by station."""
    knives = any(isinstance(held.tool, Knife) for held in bench.machine.stations)
    cutters = any(isinstance(held.tool, Cutter) for held in bench.machine.stations)
    for trade, kinds in WORKED.items():
        edges = bench.edges.of(*kinds)
        if trade == Trade.CUT and cutters and not knives:
            edges = bench.edges.of(*(kind for kind in kinds if kind != LineType.CUT))
        elif trade == Trade.MILL and (knives or not cutters):
            # Where there is a knife, nothing is left for a cutter.
            edges = bench.edges.of()
        edges, twin, first = drawn_once(edges)
        rows = np.flatnonzero(work.trade == trade)
        owner = _owners(work, rows, edges, bench.tolerance)
        for station in np.unique(work.station[rows]) if len(rows) else (-1,):
            mine = rows[work.station[rows] == station]
            _Trial(bench, work, mine, trade, edges.taken(np.flatnonzero(owner == station))).run()
        # What is drawn twice is worked once, and the figures are those of both.
        bench.figures.copied(first, twin)


def _owners(work: Work, rows: I64, edges: Edges, tolerance: float) -> I64:
    """Return the station that works most of each edge, (n,): the first where none does."""
    stations = np.unique(work.station[rows])
    if len(stations) < 2:
        return np.full(len(edges), stations[0] if len(stations) else -1, np.int64)
    near = overlaps(
        work.curve[rows], edges.curve, np.zeros(len(edges)), edges.curve[:, 5], tolerance
    )
    # A wheel that presses one place goes over no length of it.
    size = np.abs(near.place[:, 1] - near.place[:, 0]) + 1e-6
    column = np.searchsorted(stations, work.station[rows][near.curve])
    total = np.zeros((len(edges), len(stations)))
    np.add.at(total, (near.edge, column), size)
    result: I64 = stations[total.argmax(axis=1)].astype(np.int64)
    return result


class _Trial:
    """The work of one station in one trade, and its edges."""

    def __init__(self, bench: Bench, work: Work, rows: I64, trade: Trade, edges: Edges) -> None:
        self.bench, self.trade = bench, trade
        self.figures, self.found, self.tolerance = bench.figures, bench.found, bench.tolerance
        self.curve, self.z, self.heading = work.curve[rows], work.z[rows], work.heading[rows]
        self.station, self.line = work.station[rows], work.line[rows]
        self.blend = work.blend[rows]
        # Along its line, too, the tip may be off by what the controller rounds.
        rounds = self.blend[np.isfinite(self.blend)].max(initial=0.0)
        self.slack = float(np.clip(self.tolerance - rounds, PLACE, self.tolerance))
        self.track = np.unique(work.track[rows], return_inverse=True)[1].astype(np.int64)
        self._laid(edges)

    def _laid(self, edges: Edges) -> None:
        """Take these edges for those to work, all of each."""
        self.edges = edges
        self.size = edges.curve[:, 5]
        self.low, self.high = np.zeros(len(edges)), self.size.copy()
        self.depth = np.zeros(len(edges))
        #: (n,) mm of each curve before the edge as drawn begins
        self.before = np.zeros(len(edges))
        #: (n, 2) mm at start and end that may be worked and need not
        self.spare = np.zeros((len(edges), 2))

    def run(self) -> None:
        if len(self.curve) == 0 and len(self.edges) == 0:
            return
        {
            Trade.CUT: self._cut,
            Trade.HALF_CUT: self._half_cut,
            Trade.CREASE: self._crease,
            Trade.GROOVE: self._groove,
            Trade.MILL: self._mill,
        }[self.trade]()

    # -- the four trades -------------------------------------------------------------------------

    def _cut(self) -> None:
        into = self.bench.machine.into_mat
        caliper = self.bench.board.caliper
        self.depth[:] = caliper + into
        self._knife(caliper + into, caliper)

    def _half_cut(self) -> None:
        depth = self.bench.board.half_cut_depth
        self.depth[:] = depth
        self._knife(depth, depth)

    def _knife(self, leads: float, runs: float) -> None:
        """Judge a knife whose top is ahead over ``leads`` mm and that runs on by ``runs``' lead."""
        blade = self._tool(Knife)
        slant = math.tan(math.radians(blade.blade_angle)) if blade else 0.0
        cuts = self.bench.edges.of(LineType.CUT)
        torn = np.isin(self.edges.line_type, (LineType.PERFORATION, LineType.COMBI))
        solid = np.flatnonzero(~torn)
        whole = self.edges.of(LineType.CUT, LineType.HALF_CUT)
        ends = knife_ends(whole, cuts, leads * slant, runs * slant)
        rounds = self._held(whole, ends.paths)
        held = np.zeros(len(self.edges), np.bool_)
        held[solid[rounds[ends.paths.path]]] = True
        if blade and self.trade == Trade.CUT:
            self._unled(blade)
        rows = self._matched()
        dashed = np.zeros(int(self.track.max(initial=-1)) + 1, np.bool_)
        dashed[self.track[rows.curve[rows.best & torn[rows.edge]]]] = True
        dashed |= self._mostly_on(rows, held)
        over = self._stops(whole, solid, ends, dashed, leads * slant, runs * slant)
        # What runs over an end crosses other edges there, and is no work of theirs.
        until = self._before(over)
        rows = nearest_until(rows, self.curve, until)
        self._placed(rows)
        self._off(rows, until)
        self._uncut(rows, np.flatnonzero(~torn & ~held))
        if held.any():
            self._bridged(rows, whole, solid, ends.paths, rounds, leads * slant)
        if torn.any():
            self._perforated(
                rows, np.flatnonzero(torn), dashed & ~self._mostly_on(rows, held), leads * slant
            )
        if blade:
            self._headed(rows, np.full(len(self.z), blade.blade_width), 360.0)
            self._faces(rows, over, leads * slant, (leads - runs) * slant)

    def _faces(self, rows: Rows, over: F64, top: float, bottom: float) -> None:
        """Tell what the bottom face lacks, and what is cut past the edges in the top face.

        Where a track ends the cut is ``top`` mm ahead of the tip in the top face, and ``bottom``
        mm in the bottom one.
        """
        last = np.zeros(len(self.curve), np.bool_)
        last[np.searchsorted(self.track, np.arange(len(over)), side="right") - 1] = True
        work, edge = rows.curve, rows.edge
        low, high = rows.place.min(axis=1), rows.place.max(axis=1)
        forward = rows.place[:, 1] > rows.place[:, 0]
        until = self.curve[work, 5] - over[self.track[work]]
        ends = rows.best & last[work] & (np.abs(rows.along[:, 1] - until) <= BRIEF)
        ends &= np.diff(rows.along)[:, 0] > BRIEF
        ahead = np.where(ends, bottom + over[self.track[work]], 0.0)
        size = self.size[edge]
        keep = rows.best
        bare = gaps(
            edge[keep].astype(np.int64),
            np.where(forward, low, low - ahead)[keep],
            np.where(forward, high + ahead, high)[keep],
            self.size,
        )
        np.add.at(self.figures.bottom_uncut, self.edges.row[bare[0]], bare[2] - bare[1])
        short = np.where(forward, size - high, low)
        past = np.where(ends, top + over[self.track[work]] - short, 0.0)
        goes_on = straight_on(self.edges)[2 * edge.astype(np.int64) + forward]
        past[goes_on] = 0.0
        np.maximum.at(
            self.figures.top_overcut, self.edges.row[edge], np.where(past > BRIEF, past, 0.0)
        )

    def _held(self, whole: Edges, paths: Chains) -> Bool:
        """Return which paths, (c,), the board wants to hang by bridges."""
        result = np.zeros(len(paths.length), np.bool_)
        board = self.bench.board
        if self.trade == Trade.CUT and board.bridge_width > 0.0 and board.bridge_spacing > 0.0:
            result |= paths.first < 0
            inner = ~outline(whole).outer
            result[paths.path[inner]] = False
        return result

    def _mostly_on(self, rows: Rows, some: Bool) -> Bool:
        """Return which tracks run along some of the edges for more than half of their length."""
        count = int(self.track.max(initial=-1)) + 1
        size = np.bincount(self.track, self.curve[:, 5], minlength=count)
        mine = rows.best & some[rows.edge]
        along = np.diff(rows.along[mine])[:, 0]
        on = np.bincount(self.track[rows.curve[mine]], along, minlength=count)
        result: Bool = on > 0.5 * size
        return result

    def _bridged(
        self, rows: Rows, whole: Edges, solid: I64, paths: Chains, rounds: Bool, lead: float
    ) -> None:
        """Judge the bridges: how wide, how many, how far apart, and how far from corners."""
        board = self.bench.board
        place = np.full(len(self.edges), -1, np.int32)
        place[solid] = np.arange(len(solid))
        found = bridges(
            replace(rows, edge=place[rows.edge], best=rows.best & (place[rows.edge] >= 0)),
            paths,
            rounds,
            whole,
            lead,
        )
        edge, short = near_corner(found, paths, whole, CLEAR)
        np.add.at(self.figures.setback, whole.row[edge], np.minimum(found.bare, lead + found.width))
        wide = found.width - board.bridge_width
        np.add.at(self.figures.uncut, whole.row[edge], np.where(wide > self.slack, wide, 0.0))
        for k in range(len(edge))[:MOST]:
            at, e = f"at {found.middle[k]:.3f} mm round the contour", int(solid[edge[k]])
            if abs(wide[k]) > self.slack:
                self._finding(
                    "uncut" if wide[k] > 0.0 else "overcut",
                    e,
                    f"a bridge {at} is {found.width[k]:.3f} mm wide in the top face; the board "
                    f"wants {board.bridge_width:g} mm.",
                    float(abs(wide[k])),
                )
            if short[k] > self.slack:
                self._finding(
                    "deviation",
                    e,
                    f"a bridge {at} is {short[k]:.3f} mm too near a sharp corner.",
                    float(short[k]),
                )
            if found.apart[k] > board.bridge_spacing + self.slack:
                self._finding(
                    "overcut",
                    e,
                    f"from the bridge {at} it is {found.apart[k]:.3f} mm to the next; the board "
                    f"wants at most {board.bridge_spacing:g} mm.",
                    float(found.apart[k] - board.bridge_spacing),
                )
        many = np.bincount(found.path, minlength=len(rounds))
        for path in np.flatnonzero(rounds & (many < FEWEST))[:MOST]:
            e = int(solid[np.flatnonzero(paths.path == path)[0]])
            self._finding(
                "overcut",
                e,
                f"{many[path]} bridges hold the part; the board wants {FEWEST} at least.",
                0.0,
            )

    def _unled(self, blade: Knife) -> None:
        """Leave out how the knife comes from the waste to an outer cut, and goes back into it."""
        if (blade.lead_in <= 0.0 and blade.lead_out <= 0.0) or len(self.curve) == 0:
            return
        bounds = outline(self.edges.of(LineType.CUT))
        cuts = bounds.edges.curve
        nothing, size = np.zeros(len(cuts)), cuts[:, 5]
        keep = np.ones(len(self.curve), np.bool_)
        length = self.curve[:, 5]
        for last, lead in ((False, blade.lead_in), (True, blade.lead_out)):
            order = np.arange(len(length))[:: -1 if last else 1]
            track = self.track[order]
            new = np.ones(len(order), np.bool_)
            new[1:] = track[1:] != track[:-1]
            total = np.cumsum(length[order])
            before = (total - length[order])[new][np.cumsum(new) - 1]
            done = total - before
            mine = order[done <= lead + self.slack]
            # The far end of a lead lies on no cut and in no part, and its near one on an outer cut.
            ends = [point_at(self.curve[mine], np.zeros(len(mine)))]
            ends.append(point_at(self.curve[mine], length[mine]))
            far, near = (ends[1], ends[0]) if last else (ends[0], ends[1])
            on = np.zeros(len(mine), np.bool_)
            on[overlaps(lines(far, far), cuts, nothing, size, self.tolerance).curve] = True
            waste = ~on & (inside(far, bounds) != 1)
            meets = np.zeros(len(mine), np.bool_)
            touch = overlaps(lines(near, near), cuts, nothing, size, self.tolerance)
            meets[touch.curve[bounds.outer[touch.edge]]] = True
            whole = np.abs(done[done <= lead + self.slack] - lead) <= self.slack
            complete = np.zeros(int(self.track.max()) + 1, np.bool_)
            complete[self.track[mine[whole & meets & waste]]] = True
            bad = np.zeros(len(complete), np.bool_)
            bad[self.track[mine[~waste]]] = True
            led = (complete & ~bad)[self.track[mine]]
            keep[mine[led]] = False
        self.curve, self.z, self.heading = self.curve[keep], self.z[keep], self.heading[keep]
        self.station, self.line = self.station[keep], self.line[keep]
        self.blend = self.blend[keep]
        self.track = np.unique(self.track[keep], return_inverse=True)[1].astype(np.int64)

    def _crease(self) -> None:
        wheel = self._tool(CreaseWheel)
        if wheel is None:
            self._uncut(self._matched(), np.arange(len(self.edges)))
            return
        around = self.bench.edges.of(*WORKED[Trade.CREASE])
        pair = self.bench.board.double_crease
        between = rolled_gaps(
            self.edges, self.bench.edges.of(LineType.CUT), self.curve, 0.5 * pair + self.tolerance
        )
        single, places = parted(joined(self.edges, between), self.bench.edges.of(LineType.CUT))
        around, _ = parted(joined(around, between), self.bench.edges.of(LineType.CUT))
        parts = at_places(single, places)
        many = 2 if pair > 0.0 else 1
        if pair > 0.0:
            single, around, parts = doubled(single, pair), doubled(around, pair), np.tile(parts, 2)
        self._laid(single)
        asked = creases(self.edges, self.bench.board, wheel, around, parts)
        self.low, self.high, self.depth = asked.low, asked.high, asked.depth
        for edge in np.flatnonzero(asked.refused)[:MOST]:
            self._finding("uncut", edge, "is too short for the wheel.", self.size[edge])
        rows = self._matched()
        self._placed(rows)
        self._off(rows, self.curve[:, 5])
        planned = np.maximum(self.high - self.low, 0.0)
        np.add.at(self.figures.setback, self.edges.row, (self.size - planned) / many)
        self._uncut(rows, np.arange(len(self.edges)))
        depth = np.maximum(self.bench.board.caliper - self.z, 0.0)
        contact = np.sqrt(np.maximum(depth * (2.0 * wheel.radius - depth), 0.0))
        self._headed(rows, contact, 180.0)

    def _groove(self) -> None:
        self.depth[:] = self.bench.board.groove_depth
        blade = self._tool(VCutter)
        leaves = self.bench.board.groove_curve
        curved = self.edges.curve[:, 0] != 0.0
        for edge in np.flatnonzero(curved)[:MOST] if leaves <= 0.0 else ():
            self._finding("deviation", edge, "is an arc, which no leaning blade can follow.", 0.0)
        boundary = self._run_out(blade) if blade else np.zeros((len(self.edges), 2), np.bool_)
        rows = self._matched()
        wide = np.full(len(self.edges), self.tolerance)
        if leaves > 0.0 and curved.any():
            # A groove of chords leaves its arc by as much as the board allows.
            wide[curved] = leaves + self.tolerance
            wider = overlaps(self.curve, self.edges.curve, self.low, self.high, leaves)
            rows = narrowed(wider, wide, self.curve)
        final = self._passes(rows)
        self._placed(rows, final, wide)
        off_board = 0.0
        if blade and curved.any():
            # Chords leave the board in their own direction.
            off_board = 2.0 * (blade.half_width + self.bench.board.groove_depth * blade.slope)
        self._off(rows, self.curve[:, 5], off_board)
        # What it may run out further is not asked for.
        self.low, self.high = self.low + self.spare[:, 0], self.high - self.spare[:, 1]
        for forward in (True, False):
            way = rows.place[:, 1] > rows.place[:, 0]
            self._uncut(rows, np.arange(len(self.edges)), (way == forward) & final, forward)
        if blade is None:
            return
        self._headed(rows, np.full(len(self.z), 2.0 * blade.half_width), 360.0, curved)
        self._flanks(rows, final, blade, wide)
        worked = np.zeros(len(self.edges), np.bool_)
        worked[rows.edge[rows.best]] = True
        inside = ~(boundary | run_on(self.edges).reshape(-1, 2)).all(axis=1)
        past: F64 = np.where(worked & inside, 2.0 * blade.half_width, 0.0)
        self._overcut(np.arange(len(self.edges)), past)
        limit = self.bench.board.groove_overcut
        for edge in np.flatnonzero(past > limit + self.tolerance)[:MOST]:
            self._finding(
                "overcut",
                edge,
                f"the blade runs {past[edge]:.2f} mm past its ends, and the board allows "
                f"{limit:.2f} mm.",
                past[edge],
            )

    def _run_out(self, blade: VCutter) -> Bool:
        """Lengthen grooves that leave the board; return which ends do, (n, 2).

        Beyond what it must run out, the tip may go on by the blade's width: there is no board.
        """
        half = self.bench.board.groove_depth * blade.slope
        asked = run_outs(self.edges, self.bench.edges.of(LineType.CUT), half)
        boundary = asked.boundary.reshape(-1, 2)
        least = asked.least.reshape(-1, 2)
        # Chords leave the board in their own direction, and their last one says how far.
        straight_on = self.edges.curve[:, 0] == 0.0
        boundary &= straight_on[:, None]
        self.spare = np.where(boundary, 2.0 * blade.half_width + self.tolerance, 0.0)
        more = least + self.spare
        curve = self.edges.curve.copy()
        # Of a straight edge the row is its start, its direction and its length.
        straight = curve[:, 0] == 0.0
        curve[straight, 1:3] -= more[straight, :1] * curve[straight, 3:5]
        curve[straight, 5] += more[straight].sum(axis=1)
        self.edges = replace(self.edges, curve=curve)
        self.size = curve[:, 5]
        self.high = self.size.copy()
        self.before = more[:, 0]
        return boundary

    def _passes(self, rows: Rows) -> Bool:
        """Return which stretches are of the deepest pass over their edge in their direction.

        Those before it may be shallower, each no deeper than the next.
        """
        deep = (self.bench.board.caliper - self.z)[rows.curve]
        way = 2 * rows.edge.astype(np.int64) + (rows.place[:, 1] > rows.place[:, 0])
        deepest = np.zeros(2 * len(self.edges))
        np.maximum.at(deepest, way[rows.best], deep[rows.best])
        final: Bool = deep >= deepest[way] - DEPTH
        order = np.flatnonzero(rows.best & (np.abs(np.diff(rows.place)[:, 0]) > BRIEF))
        order = order[np.lexsort((rows.curve[order], way[order]))]
        same = way[order[1:]] == way[order[:-1]]
        back = same & (deep[order[1:]] < deep[order[:-1]] - DEPTH)
        for k in np.flatnonzero(back)[:MOST]:
            row = order[k + 1]
            self._finding(
                "depth",
                int(rows.edge[row]),
                f"the V-cutter goes {deep[row]:.3f} mm deep after it has been "
                f"{deep[order[k]]:.3f} mm deep.",
                float(deep[order[k]] - deep[row]),
                int(rows.curve[row]),
            )
        return final

    def _flanks(self, rows: Rows, final: Bool, blade: VCutter, limit: F64) -> None:
        """Judge where the flanks come out at the top face, h tan θ beside the line.

        On each pass the blade leans to the right of travel, and cuts the flank on that side.
        """
        size = np.abs(np.diff(rows.place)[:, 0])
        which = np.flatnonzero(rows.best & final & (size > BRIEF))
        work, edge = rows.curve[which], rows.edge[which]
        forward = rows.place[which, 1] > rows.place[which, 0]
        deep = self.bench.board.caliper - self.z[work]
        lean = (deep - self.depth[edge]) * blade.slope
        error = np.zeros(len(which))
        for side in range(2):
            left = off_line(self.curve[work], rows.along[which, side], self.edges.curve[edge])
            right = np.where(forward, -left, left) + lean
            error = np.where(np.abs(right) > np.abs(error), right, error)
        row = self.edges.row[edge]
        np.maximum.at(self.figures.flank, row, np.abs(error))
        wide = np.zeros((len(self.figures.width), 2))
        np.maximum.at(wide, (row, forward.astype(np.int64)), self.depth[edge] * blade.slope + error)
        np.maximum(self.figures.width, wide.sum(axis=1), out=self.figures.width)
        web = np.full(len(self.figures.web), np.inf)
        np.minimum.at(web, row, self.bench.board.caliper - deep)
        self.figures.web[np.isfinite(web)] = web[np.isfinite(web)]
        for k in np.flatnonzero(np.abs(error) > limit[edge] + 1e-9)[:MOST]:
            hand = "outside" if error[k] > 0.0 else "inside"
            self._finding(
                "deviation",
                int(edge[k]),
                f"a flank comes out {abs(error[k]):.4f} mm {hand} "
                f"its place on the top face; the tolerance is {limit[edge[k]]:g} mm.",
                float(abs(error[k])),
                int(work[k]),
            )

    def _mill(self) -> None:
        held = self.bench.machine.stations[int(self.station[0])] if len(self.station) else None
        if held is None or not isinstance(held.tool, Cutter):
            self._uncut(self._matched(), np.arange(len(self.edges)))
            return
        ways = Ways(self.curve, self.z, self.track, self.line, self.blend)
        judge_removal(self.bench, self.edges, ways, held, self.slack)

    # -- what they share -------------------------------------------------------------------------

    def _tool(self, kind: type[Held]) -> Held | None:
        """Return the tool of the station that does this trade, or could."""
        stations = self.bench.machine.stations
        if len(self.station):
            tool = stations[int(self.station[0])].tool
            return tool if isinstance(tool, kind) else None
        return next((held.tool for held in stations if isinstance(held.tool, kind)), None)

    def _finding(
        self, kind: str, edge: int, text: str, measure: float, work: int = -1, line: int = -1
    ) -> None:
        """Note something about an edge of this trade, ``edge`` -1 for none."""
        row = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.line[work]) if work >= 0 else line
        place = f"{self.trade.word}, edge {row}: " if row >= 0 else f"{self.trade.word}: "
        where = f" Line {line}." if line >= 0 else ""
        self.found.add(kind, place + text + where, measure, edge=row, line=line)

    def _overcut(self, edges: I64, measure: F64) -> None:
        rows = self.edges.row[edges]
        np.maximum.at(self.figures.overcut, rows, measure)

    def _matched(self) -> Rows:
        """Return where the work runs along the edges."""
        return overlaps(self.curve, self.edges.curve, self.low, self.high, self.tolerance)

    def _placed(self, rows: Rows, final: Bool | None = None, wide: F64 | None = None) -> None:
        """Judge how far off the edges the work is, and how deep where it is ``final``.

        Parameters
        ----------
        wide : (n,) mm
            The tolerance of each edge, where they differ.
        """
        limit = np.full(len(self.edges), self.tolerance) if wide is None else wide
        best = np.flatnonzero(rows.best)
        work, edge = rows.curve[best], rows.edge[best]
        figure = rows.distance[best] + self.blend[work]
        shown = np.where(np.isfinite(figure), figure, rows.distance[best])
        np.maximum.at(self.figures.deviation, self.edges.row[edge], shown)
        for row in np.flatnonzero(figure > limit[edge] + 1e-9)[:MOST]:
            self._finding(
                "deviation",
                edge[row],
                f"{self.trade.tool} is {rows.distance[best[row]]:.4f} mm off the line and the "
                f"controller may round {self.blend[work[row]]:.4f} mm more; the tolerance is "
                f"{limit[edge[row]]:g} mm.",
                shown[row],
                work[row],
            )
        drawn = self.size[edge] - self.before[edge] - self.spare[edge, 1]
        for share in (0.0, 0.5, 1.0):
            along = rows.along[best] @ (1.0 - share, share)
            off = off_line(self.curve[work], along, self.edges.curve[edge])
            place = rows.place[best] @ (1.0 - share, share) - self.before[edge]
            self.bench.samples.append((self.edges.row[edge], place / drawn, off))
        deep = self.bench.board.caliper - self.z[work]
        wrong = np.abs(deep - self.depth[edge])
        if final is not None:
            wrong[~final[best]] = 0.0
        for row in np.flatnonzero(wrong > DEPTH)[:MOST]:
            self._finding(
                "depth",
                edge[row],
                f"{self.trade.tool} goes {deep[row]:.3f} mm below the top of the board, where "
                f"{self.depth[edge[row]]:.3f} mm is planned.",
                wrong[row],
                work[row],
            )

    def _headed(self, rows: Rows, reach: F64, turn: float, chorded: Bool | None = None) -> None:
        """Judge the heading where the work runs along an edge, and where it runs on past one.

        Parameters
        ----------
        chorded : (n,)
            Edges that are worked in chords, each in its own direction.
        """
        best = np.flatnonzero(rows.best)
        work, edge = rows.curve[best], rows.edge[best]
        length = self.curve[work, 5]
        point = length < 1e-6
        along, place = rows.along[best], rows.place[best]
        span = place[:, 1] - place[:, 0]
        # The direction of a brief way is lost in the last digit.
        size = along[:, 1] - along[:, 0]
        follows = (size > BRIEF) & (np.abs(span) > 0.5 * size)
        pressed = point & (self.trade == Trade.CREASE)
        back = np.where(span < 0.0, 180.0, 0.0)
        worst = np.zeros(len(best))
        for side in range(2):
            share = along[:, side] / np.where(point, 1.0, length)
            first, last = self.heading[work, 0], self.heading[work, 1]
            heading = first + (last - first) * share
            drawn = azimuth_at(self.edges.curve[edge], place[:, side]) + back
            if chorded is not None:
                own = azimuth_at(self.curve[work], along[:, side])
                drawn = np.where(chorded[edge], own, drawn)
            off = apart(heading, drawn, turn)
            worst = np.maximum(worst, np.where(follows | pressed, off, 0.0))
        self._swung(worst, reach[work], np.zeros(len(best)), work, edge)

        # What runs past an edge, or round a corner that is none, has only its own direction.
        which, spans = leftover(rows, self.curve)
        long = np.flatnonzero(spans[:, 1] - spans[:, 0] > self.tolerance)
        which, spans = which[long], spans[long]
        off = np.zeros(len(which))
        for side in range(2):
            share = spans[:, side] / self.curve[which, 5]
            heading = self.heading[which, 0] * (1.0 - share) + self.heading[which, 1] * share
            off = np.maximum(
                off, apart(heading, azimuth_at(self.curve[which], spans[:, side]), turn)
            )
        slack = np.degrees(PRINTED / np.maximum(self.curve[which, 5], PRINTED))
        self._swung(off, reach[which], slack, which, np.full(len(which), -1))

    def _swung(self, off: F64, reach: F64, slack: F64, work: I32, edge: I32 | I64) -> None:
        turned = np.maximum(off - slack, 0.0)
        swing = 2.0 * reach * np.sin(np.radians(turned) / 2.0)
        for row in np.flatnonzero(swing > self.tolerance)[:MOST]:
            self._finding(
                "heading",
                int(edge[row]),
                f"{self.trade.tool} is turned {off[row]:.3f}° off the line, so that it swings "
                f"{swing[row]:.3f} mm.",
                off[row],
                work[row],
            )

    def _uncut(
        self, rows: Rows, which: I64, only: Bool | None = None, forward: bool | None = None
    ) -> None:
        """Judge what of these edges, between their limits, no work has covered."""
        size = self.size
        wanted = np.zeros(len(self.edges), np.bool_)
        wanted[which] = True
        wanted &= self.high >= self.low
        keep = wanted[rows.edge]
        if only is not None:
            keep &= only
        wide, edge, begin, line = self._gaps(rows, np.flatnonzero(keep), np.flatnonzero(wanted))
        bare = wide > self.slack
        # A pressed crease is a point: covered, or not there at all.
        bare |= (self.high - self.low < 1e-9)[edge] & (line < 0)
        missed = np.where(wide > 0.0, wide, size[edge])
        np.add.at(self.figures.uncut, self.edges.row[edge[bare]], missed[bare])
        done = {Trade.CREASE: "creased", Trade.GROOVE: "grooved"}.get(self.trade, "cut")
        for row in np.flatnonzero(bare)[:MOST]:
            e = int(edge[row])
            way = "" if forward is None else f" from its {'start' if forward else 'end'}"
            place = begin[row] - self.before[e]
            where = f", beginning {place:.3f} mm from its start."
            if place < -self.slack:
                where = ", where it must run out past its start."
            elif self.spare[e, 1] > 0.0 and begin[row] > self.low[e] + self.slack:
                drawn = self.size[e] - self.spare[e, 1]
                where = (
                    where
                    if drawn - begin[row] > missed[row] + self.slack
                    else (", where it must run out past its end.")
                )
            text = f"{missed[row]:.3f} mm of it are not {done}{way}{where}"
            self._finding("uncut", e, text, missed[row], line=int(line[row]))

    def _gaps(self, rows: Rows, keep: I64, wanted: I64) -> tuple[F64, I64, F64, I64]:
        """Return the gaps: length, edge, where they begin, and the line before them.

        One gap before every stretch, and one after the last of each edge; many are empty.
        """
        edge = rows.edge[keep].astype(np.int64)
        low, high = rows.place[keep].min(axis=1), rows.place[keep].max(axis=1)
        line = self.line[rows.curve[keep]].astype(np.int64)
        # Every edge gets a stretch without length where it ends, so that all gaps lie before one.
        edge = np.concatenate([edge, wanted])
        low = np.concatenate([low, self.high[wanted]])
        high = np.concatenate([high, self.high[wanted]])
        line = np.concatenate([line, np.full(len(wanted), -1)])
        order = np.lexsort((high, low, edge))
        edge, low, high, line = edge[order], low[order], high[order], line[order]
        # One running maximum for all edges: each stands on its own step.
        step = edge * (2.0 * float(self.size.max(initial=0.0)) + 1.0)
        reached = np.maximum.accumulate(high + step) - step
        new = np.ones(len(edge), np.bool_)
        new[1:] = edge[1:] != edge[:-1]
        before = np.where(new, self.low[edge], np.concatenate([[0.0], reached[:-1]]))
        before = np.maximum(before, self.low[edge])
        previous = np.where(new, -1, np.concatenate([[-1], line[:-1]]))
        return low - before, edge, before, np.where(line >= 0, line, previous)

    def _off(self, rows: Rows, until: F64, past: float = 0.0) -> None:
        """Judge the work that lies on no edge, or past where it may go on one.

        Parameters
        ----------
        until : (n,) mm
            How far along each way: what comes after runs over, as it may.
        past : mm
            As much work off the board is let pass.
        """
        which, spans = leftover(rows, self.curve)
        spans[:, 1] = np.minimum(spans[:, 1], until[which])
        point = self.curve[which, 5] < 1e-6
        keep = point | (spans[:, 1] - spans[:, 0] > 1e-7)
        if past > 0.0 and len(which):
            bounds = outline(self.bench.edges.of(LineType.CUT))
            middle = point_at(self.curve[which], spans.mean(axis=1))
            short = spans[:, 1] - spans[:, 0] <= past
            keep &= ~(short & bounds.outer.any() & (inside(middle, bounds) == 0))
        which, spans = which[keep], spans[keep]
        if len(which) == 0:
            return
        size = spans[:, 1] - spans[:, 0]
        track = self.track[which]
        # Pieces that follow each other are one.
        joined = np.zeros(len(which), np.bool_)
        joined[1:] = (
            (which[1:] == which[:-1] + 1)
            & (track[1:] == track[:-1])
            & (spans[1:, 0] <= 1e-7)
            & (spans[:-1, 1] >= self.curve[which[:-1], 5] - 1e-7)
        )
        first = np.flatnonzero(~joined)
        total: F64 = np.add.reduceat(size, first)
        lone = self.curve[which[first], 5] < 1e-6
        self._astray(which, spans, first, total, np.flatnonzero((total > self.slack) | lone))

    def _astray(self, which: I32, spans: F64, first: I64, total: F64, bad: I64) -> None:
        """Say of pieces on no edge what they are: past an end, beside an edge, or nowhere."""
        bad = bad[:MOST]
        if len(bad) == 0 or self.found.full:
            return
        curve, all_edges = self.curve[which[first[bad]]], self.bench.edges
        nothing = np.zeros(len(self.edges))
        on = overlaps(curve, self.edges.curve, nothing, self.size, self.tolerance)
        near = overlaps(curve, self.edges.curve, nothing, self.size, CATCH)
        other = overlaps(
            curve, all_edges.curve, np.zeros(len(all_edges)), all_edges.curve[:, 5], TOUCHING
        )
        clear = self.bench.board.end_clearance if self.trade == Trade.CREASE else 0.0
        for k, group in enumerate(bad):
            line, length = int(self.line[which[first[group]]]), float(total[group])
            span = spans[first[group]]
            if (edge := _along(on, k, span)) >= 0:
                self._overcut(np.array([edge]), np.array([max(length - clear, 0.0)]))
                text = f"{self.trade.tool} works {length:.3f} mm past where it should stop."
                self._finding("overcut", edge, text, length, line=line)
                continue
            edge, measure = _beside(near, k, span)
            if edge >= 0:
                row = self.edges.row[edge]
                self.figures.deviation[row] = max(self.figures.deviation[row], measure)
                text = f"{self.trade.tool} is {measure:.3f} mm off the line."
                self._finding("deviation", edge, text, measure, line=line)
                continue
            if (edge := _touched(on, k, span)) >= 0:
                self._overcut(np.array([edge]), np.array([length]))
                text = f"{self.trade.tool} runs {length:.3f} mm past its end."
                self._finding("overcut", edge, text, length, line=line)
                continue
            x, y = point_at(curve[k : k + 1], span[:1])[0]
            where = f"at X{x:.3f} Y{y:.3f} of the sheet"
            if (wrong := _along(other, k, span)) >= 0:
                kind = LineType(int(all_edges.line_type[wrong])).word
                where = f"along edge {int(all_edges.row[wrong])}, which is {kind}"
            what = f"works {length:.3f} mm" if length > 0.0 else "goes down"
            text = f"{self.trade.tool} {what} {where}, where no edge asks for it."
            self._finding("stray", -1, text, length, line=line)

    # -- where a knife begins and stops ----------------------------------------------------------

    def _stops(
        self,
        whole: Edges,
        solid: I64,
        ends: KnifeEnds,
        dashed: Bool,
        lead: float,
        overrun: float,
    ) -> F64:
        """Judge where the knife goes in and comes out; return how far tracks run over (mm).

        Tracks that begin where the last one ended, as at a corner turned in the air, are one run.
        A run begins at an end of an edge, unless it is closed.  It stops where an end of an edge
        says, or, if it is closed, on its own way, ``overrun`` from where it began.
        """
        count = len(dashed)
        over = np.zeros(count)
        if count == 0:
            return over
        first = np.searchsorted(self.track, np.arange(count))
        last = np.searchsorted(self.track, np.arange(count), side="right") - 1
        start = point_at(self.curve[first], np.zeros(count))
        stop = point_at(self.curve[last], self.curve[last, 5])
        ahead = azimuth_at(self.curve[last], self.curve[last, 5])

        known = np.flatnonzero(~np.isnan(ends.stop[:, 0]))
        run_over = np.zeros(count, np.bool_)
        run_over[pairs_within(stop, ends.stop[known[ends.meets[known]]], self.tolerance)[0]] = True
        new = np.ones(count, np.bool_)
        jump = np.hypot(*(start[1:] - stop[:-1]).T)
        # Beside where one run has run over an end another may begin, but not at the same place.
        new[1:] = jump > np.where(run_over[:-1], PRINTED, JOINED)
        opens = np.flatnonzero(new)
        closes = np.concatenate([opens[1:], [count]]) - 1
        plain = ~dashed[opens]
        opens, closes = opens[plain], closes[plain]
        if len(opens) == 0:
            return over

        reached = np.cumsum(self.curve[:, 5])
        size = reached[last[closes]] - reached[first[opens]] + self.curve[first[opens], 5]
        # A way round that is shorter than the overrun is run over once.
        ring = self._after(first[opens], last[closes], np.minimum(overrun, size / 2.0))
        gap = np.hypot(*(stop[closes] - ring).T)
        closed = gap <= self.slack

        run, end = pairs_within(stop[closes], ends.stop[known], CATCH)
        end = known[end]
        away = np.hypot(*(stop[closes[run]] - ends.stop[end]).T)
        order = np.lexsort((away, run))
        run, end, away = run[order], end[order], away[order]
        nearest = np.unique(run, return_index=True)[1]
        run, end, away = run[nearest], end[nearest], away[nearest]
        planned = np.full(len(opens), -1, np.int64)
        distance = np.full(len(opens), np.inf)
        planned[run], distance[run] = end, away
        right = (distance <= self.slack) & (~closed | (distance < gap))

        # Where no end is near, ``planned`` is -1: the last, which neither meets nor is free.
        ran = right & np.append(ends.meets, False)[planned]
        over[closes[ran]] = overrun
        self._overcut(solid[planned[ran] // 2], np.full(int(ran.sum()), overrun))
        short = right & np.append(ends.free, False)[planned]
        # Cuts drawn over each other end together.
        free = known[ends.free[known]]
        together = pairs_within(ends.stop[planned[short]], ends.stop[free], JOINED)[1]
        self._set_back(whole, solid, ends, np.unique(free[together]), lead)

        for k in np.flatnonzero(~closed & ~right)[:MOST]:
            work = int(last[closes[k]])
            edge = int(solid[planned[k] // 2]) if planned[k] >= 0 else -1
            # A closed way that stops elsewhere on itself is nearest to its own planned end.
            if gap[k] < min(distance[k], CATCH):
                target, measure, edge = ring[k], float(gap[k]), -1
            elif planned[k] >= 0:
                target, measure = ends.stop[planned[k]], float(distance[k])
            else:
                self._finding(
                    "uncut",
                    -1,
                    "the knife comes out where no edge ends, and not where it went in.",
                    float(gap[k]),
                    work,
                )
                continue
            angle = math.radians(float(ahead[closes[k]]))
            x, y = stop[closes[k]] - target
            past = x * math.cos(angle) + y * math.sin(angle) > 0.0
            self._finding(
                "overcut" if past else "uncut",
                edge,
                f"the knife comes out {measure:.3f} mm {'past' if past else 'short of'} where it "
                "should.",
                measure,
                work,
            )

        begun = np.zeros(len(opens), np.bool_)
        begun[pairs_within(start[opens], whole.ends, TOUCHING)[0]] = True
        for k in np.flatnonzero(~begun & ~closed & right)[:MOST]:
            self._finding(
                "overcut",
                int(solid[planned[k] // 2]),
                "the knife goes in where no edge begins.",
                0.0,
                int(first[opens[k]]),
            )
        return over

    def _before(self, over: F64) -> F64:
        """Return how far along each way its track begins to run over (mm)."""
        until = self.curve[:, 5].copy()
        track = np.flatnonzero(over > 0.0)
        at = np.searchsorted(self.track, track, side="right") - 1
        left = over[track]
        while len(at):
            size = until[at].copy()
            until[at] = np.maximum(size - left, 0.0)
            on = (left > size) & (at > 0)
            on &= self.track[at] == self.track[at - 1]
            at, left = at[on] - 1, (left - size)[on]
        return until

    def _after(self, first: I64, last: I64, distance: F64) -> F64:
        """Return the points at a distance (mm) along runs, from where they begin, (n, 2)."""
        at, left = first.copy(), distance
        while True:
            size = self.curve[at, 5]
            on = (left > size) & (at < last)
            if not on.any():
                return point_at(self.curve[at], np.minimum(left, size))
            left = np.where(on, left - size, left)
            at = np.where(on, at + 1, at)

    def _set_back(self, whole: Edges, solid: I64, ends: KnifeEnds, which: I64, lead: float) -> None:
        """Take off what a knife need not cut at free ends at which it stops."""
        paths = ends.paths
        path = paths.path[which // 2]
        begin = np.zeros(len(paths.length))
        finish = paths.length.copy()
        at_last = paths.last[path] == which
        finish[path[at_last]] -= lead
        begin[path[~at_last]] += lead
        low, high = paths.stretch(begin, finish, whole.curve)
        self.figures.setback[whole.row] += whole.curve[:, 5] - np.maximum(high - low, 0.0)
        self.low[solid], self.high[solid] = low, high

    def _perforated(self, rows: Rows, which: I64, dashed: Bool, lead: float) -> None:
        """Judge perforations: cuts of the board's length, less the blade's lead, and its gaps."""
        cut, gap = self.bench.board.perforation
        torn = np.zeros(len(self.edges), np.bool_)
        torn[which] = True
        keep = np.flatnonzero(torn[rows.edge])
        gaps, edge, begin, line = self._gaps(rows, keep, which)
        wide = gaps > gap + lead + self.slack
        np.add.at(self.figures.uncut, self.edges.row[edge[wide]], gaps[wide])
        for row in np.flatnonzero(wide)[:MOST]:
            self._finding(
                "uncut",
                int(edge[row]),
                f"a gap of {gaps[row]:.3f} mm, {begin[row]:.3f} mm from its start; the board "
                f"wants gaps of {gap:g} mm.",
                gaps[row],
                line=int(line[row]),
            )
        size = np.bincount(self.track, self.curve[:, 5], minlength=len(dashed))
        number = np.bincount(edge[line >= 0], minlength=len(self.edges))
        alone = np.zeros(len(dashed), np.bool_)
        few = keep[number[rows.edge[keep]] <= 2]
        alone[self.track[rows.curve[few]]] = True
        wrong = dashed & ~alone & (np.abs(size - (cut - lead)) > self.slack)
        first = np.searchsorted(self.track, np.arange(len(dashed)))
        for track in np.flatnonzero(wrong)[:MOST]:
            self._finding(
                "uncut",
                -1,
                f"a cut of {size[track]:.3f} mm in a perforation, where {cut - lead:.3f} mm is "
                "planned.",
                float(abs(size[track] - (cut - lead))),
                int(first[track]),
            )


def _stretches(rows: Rows, curve: int, span: F64) -> tuple[slice, F64, Bool]:
    """Return one curve's rows, how much of a span of it each shares, and which run along."""
    mine = slice(*np.searchsorted(rows.curve, [curve, curve + 1]))
    along, place = rows.along[mine], rows.place[mine]
    shared = np.minimum(along[:, 1], span[1]) - np.maximum(along[:, 0], span[0])
    size = along[:, 1] - along[:, 0]
    return mine, shared, np.abs(place[:, 1] - place[:, 0]) >= 0.5 * size


def _along(rows: Rows, curve: int, span: F64) -> int:
    """Return an edge that most of the span of a curve runs along, -1 if there is none."""
    mine, shared, parallel = _stretches(rows, curve, span)
    good = np.flatnonzero((shared >= 0.5 * (span[1] - span[0])) & parallel)
    return int(rows.edge[mine][good[0]]) if len(good) else -1


def _beside(rows: Rows, curve: int, span: F64) -> tuple[int, float]:
    """Return the nearest edge that the span runs beside, and how far off it is (mm)."""
    mine, shared, parallel = _stretches(rows, curve, span)
    good = np.flatnonzero((shared >= 0.8 * (span[1] - span[0])) & parallel)
    if len(good) == 0:
        return -1, 0.0
    return int(rows.edge[mine][good[0]]), float(rows.distance[mine][good[0]])


def _touched(rows: Rows, curve: int, span: F64) -> int:
    """Return the edge that the span leaves or comes to, -1 if there is none."""
    mine, _, _ = _stretches(rows, curve, span)
    along = rows.along[mine]
    touching = (np.abs(along[:, 1] - span[0]) < 1e-6) | (np.abs(along[:, 0] - span[1]) < 1e-6)
    good = np.flatnonzero(touching)
    return int(rows.edge[mine][good[0]]) if len(good) else -1
