"""Trial: the work of one station in one trade beside its edges, and what every trade asks of it.

    CheckContext, TipPaths, Edges -> position, depth, heading and completeness of the work

What is within the tolerance of the drawn line counts as on it.

Heading: a tool that reaches ρ from its tip (the blade's width, half the wheel's contact, a
V-cutter's whole edge) swings by 2 ρ sin(ΔC / 2) when it is turned by ΔC off the drawn line; that
must not be more than the tolerance.  A wheel's ΔC is the remainder of 180°, the others' of 360°.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TypeVar

import numpy as np

from knifetip.messages import Message
from knifetip.model.tool import CreaseWheel, Knife, VCutter
from knifetip.verification.checks.check_context import (
    DEPTH_TOLERANCE,
    MIN_SLACK,
    PRINT_TURN,
    CheckContext,
)
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, left_distance
from knifetip.verification.curves.intervals import SHORT, Overlaps, uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import Edges, angle_between
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

ToolKind = TypeVar("ToolKind", Knife, CreaseWheel, VCutter)


class StationCheck(ABC):
    """The work of one station in one trade, and its edges."""

    def __init__(
        self, bench: CheckContext, work: TipPaths, rows: I64, trade: OperationKind, edges: Edges
    ) -> None:
        self.bench, self.trade = bench, trade
        self.figures, self.found, self.tolerance = bench.figures, bench.found, bench.tolerance
        self.curve, self.z, self.heading = work.curve[rows], work.z[rows], work.heading[rows]
        self.station, self.line = work.station[rows], work.line[rows]
        self.blend = work.blend[rows]
        # Along its line, too, the tip may be off by what the controller rounds.
        rounds = self.blend[np.isfinite(self.blend)].max(initial=0.0)
        # A length lies between two printed points, each of them rounded.
        self.slack = bench.resolution + float(
            np.clip(self.tolerance - rounds, MIN_SLACK, self.tolerance)
        )
        self.track = np.unique(work.track[rows], return_inverse=True)[1].astype(np.int64)
        self.laid(edges)

    def laid(self, edges: Edges) -> None:
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
        """Judge, if there is anything to judge."""
        if len(self.curve) or len(self.edges):
            self.judge()

    @abstractmethod
    def judge(self) -> None:
        """Ask what this trade asks."""

    def tool(self, kind: type[ToolKind]) -> ToolKind | None:
        """Return the tool of the station that does this trade, or could."""
        stations = self.bench.machine.stations
        if len(self.station):
            tool = stations[int(self.station[0])].tool
            return tool if isinstance(tool, kind) else None
        return next((held.tool for held in stations if isinstance(held.tool, kind)), None)

    def finding(
        self,
        kind: str,
        edge: int,
        message: Message,
        measure: float,
        work: int = -1,
        line: int = -1,
    ) -> None:
        """Note something about an edge of this trade, ``edge`` -1 for none."""
        row = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.line[work]) if work >= 0 else line
        self.found.add(kind, message, measure, edge=row, line=line)

    def overcut(self, edges: I64, measure: F64) -> None:
        rows = self.edges.row[edges]
        np.maximum.at(self.figures.overcut, rows, measure)

    def matched(self) -> Overlaps:
        """Return where the work runs along the edges."""
        return find_overlaps(self.curve, self.edges.curve, self.low, self.high, self.tolerance)

    def placed(self, rows: Overlaps, final: Bool | None = None, wide: F64 | None = None) -> None:
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
        for row in np.flatnonzero(figure > limit[edge] + 1e-9)[:MAX_FINDINGS]:
            self.finding(
                "deviation",
                edge[row],
                Message(
                    "verify.off-line",
                    tool=self.trade.tool,
                    distance=rows.distance[best[row]],
                    rounding=self.blend[work[row]],
                    tolerance=limit[edge[row]],
                ),
                shown[row],
                work[row],
            )
        drawn = self.size[edge] - self.before[edge] - self.spare[edge, 1]
        for share in (0.0, 0.5, 1.0):
            along = rows.along[best] @ (1.0 - share, share)
            off = left_distance(self.curve[work], along, self.edges.curve[edge])
            place = rows.place[best] @ (1.0 - share, share) - self.before[edge]
            self.bench.samples.append((self.edges.row[edge], place / drawn, off))
        if "Z" not in self.bench.programmed:
            return
        deep = self.bench.board.caliper - self.z[work]
        wrong = np.abs(deep - self.depth[edge])
        if final is not None:
            wrong[~final[best]] = 0.0
        for row in np.flatnonzero(wrong > DEPTH_TOLERANCE)[:MAX_FINDINGS]:
            self.finding(
                "depth",
                edge[row],
                Message(
                    "verify.wrong-depth",
                    tool=self.trade.tool,
                    depth=deep[row],
                    planned=self.depth[edge[row]],
                ),
                wrong[row],
                work[row],
            )

    def headed(self, rows: Overlaps, reach: F64, turn: float, chorded: Bool | None = None) -> None:
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
        follows = (size > SHORT) & (np.abs(span) > 0.5 * size)
        pressed = point & (self.trade == OperationKind.CREASE)
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
            off = angle_between(heading, drawn, turn)
            worst = np.maximum(worst, np.where(follows | pressed, off, 0.0))
        self.swung(worst, reach[work], np.zeros(len(best)), work, edge)

        # What runs past an edge, or round a corner that is none, has only its own direction.
        which, spans = uncovered_curves(rows, self.curve)
        long = np.flatnonzero(spans[:, 1] - spans[:, 0] > self.tolerance)
        which, spans = which[long], spans[long]
        off = np.zeros(len(which))
        for side in range(2):
            share = spans[:, side] / self.curve[which, 5]
            heading = self.heading[which, 0] * (1.0 - share) + self.heading[which, 1] * share
            off = np.maximum(
                off, angle_between(heading, azimuth_at(self.curve[which], spans[:, side]), turn)
            )
        slack = np.degrees(PRINT_TURN / np.maximum(self.curve[which, 5], PRINT_TURN))
        self.swung(off, reach[which], slack, which, np.full(len(which), -1))

    def swung(self, off: F64, reach: F64, slack: F64, work: I32 | I64, edge: I32 | I64) -> None:
        """Judge by how much the tool swings where it is turned off the line by degrees."""
        if "C" not in self.bench.programmed:
            return
        turned = np.maximum(off - slack, 0.0)
        swing = 2.0 * reach * np.sin(np.radians(turned) / 2.0)
        for row in np.flatnonzero(swing > self.tolerance)[:MAX_FINDINGS]:
            self.finding(
                "heading",
                int(edge[row]),
                Message(
                    "verify.wrong-heading",
                    tool=self.trade.tool,
                    degrees=off[row],
                    swing=swing[row],
                ),
                off[row],
                work[row],
            )

    def uncut(
        self, rows: Overlaps, which: I64, only: Bool | None = None, forward: bool | None = None
    ) -> None:
        """Judge what of these edges, between their limits, no work has covered."""
        size = self.size
        wanted = np.zeros(len(self.edges), np.bool_)
        wanted[which] = True
        wanted &= self.high >= self.low
        keep = wanted[rows.edge]
        if only is not None:
            keep &= only
        wide, edge, begin, line = self.gaps(rows, np.flatnonzero(keep), np.flatnonzero(wanted))
        bare = wide > self.slack
        # A pressed crease is a point: covered, or not there at all.
        bare |= (self.high - self.low < 1e-9)[edge] & (line < 0)
        missed = np.where(wide > 0.0, wide, size[edge])
        np.add.at(self.figures.uncut, self.edges.row[edge[bare]], missed[bare])
        done = self._done(forward)
        for row in np.flatnonzero(bare)[:MAX_FINDINGS]:
            e = int(edge[row])
            place = begin[row] - self.before[e]
            where = Message("verify.where-from-start", place=place)
            if place < -self.slack:
                where = Message("verify.where-past-start")
            elif self.spare[e, 1] > 0.0 and begin[row] > self.low[e] + self.slack:
                drawn = self.size[e] - self.spare[e, 1]
                if drawn - begin[row] <= missed[row] + self.slack:
                    where = Message("verify.where-past-end")
            message = Message("verify.not-worked", length=missed[row], work=done, where=where)
            self.finding("uncut", e, message, missed[row], line=int(line[row]))

    def _done(self, forward: bool | None) -> Message:
        """Return the word for what this work does to an edge, from one of its ends or either."""
        if self.trade == OperationKind.CREASE:
            return Message("verify.work-creased")
        if self.trade != OperationKind.GROOVE:
            return Message("verify.work-cut")
        if forward is None:
            return Message("verify.work-grooved")
        return Message(
            "verify.work-grooved-from-start" if forward else "verify.work-grooved-from-end"
        )

    def gaps(self, rows: Overlaps, keep: I64, wanted: I64) -> tuple[F64, I64, F64, I64]:
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
