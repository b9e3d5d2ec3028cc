"""Base class of the checks that compare the path of a tool's tip with the edges.

The base class checks position, depth and heading of the tip, and whether each edge is cut or
creased completely.  A tip path within the tolerance of a drawn edge counts as cutting or creasing
that edge.

Heading: let ρ be the distance from the tip to the farthest point of the tool (the blade's width,
half the wheel's contact length, or a V-cutter's cutting edge).  If the heading differs by ΔC from
the direction of the edge, that point swings by 2 ρ sin(ΔC / 2).  The swing must not exceed the
tolerance.  ΔC is taken modulo 180° for a wheel, which has no front, and modulo 360° for other
tools.
"""

from __future__ import annotations

from abc import ABC, abstractmethod
from typing import TypeVar

import numpy as np

from knifetip.messages import Message
from knifetip.model.tool import CreaseWheel, Knife, VCutter
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import (
    MIN_SLACK,
    PRINT_TURN,
    CheckContext,
)
from knifetip.verification.checks.common.stretch_figures import (
    FollowedStretches,
    heading_errors,
    sample_stretches,
)
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.curves.group_order import order_in_groups
from knifetip.verification.curves.intervals import (
    SHORT,
    Overlaps,
    nearest_parts,
    uncovered_curves,
)
from knifetip.verification.expectation.edges import JOIN_DISTANCE, Edges, angle_between
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind

ToolKind = TypeVar("ToolKind", Knife, CreaseWheel, VCutter)


class StationCheck(ABC):
    """Base class of the checks that compare the paths of the tip of one station's tool with the
    edges.

    An instance checks one kind of operation (cut, half-cut, crease, groove or mill).
    """

    def __init__(
        self,
        context: CheckContext,
        work: TipPaths,
        rows: I64,
        operation: OperationKind,
        edges: Edges,
    ) -> None:
        self.context, self.operation = context, operation
        self.figures, self.findings, self.tolerance = (
            context.figures,
            context.findings,
            context.tolerance,
        )
        self.curve, self.z, self.heading = work.curve[rows], work.z[rows], work.heading[rows]
        self.station, self.line = work.station[rows], work.line[rows]
        self.blend = work.blend[rows]
        # The controller's rounding of corners also shifts the tip along its line.
        rounds = self.blend[np.isfinite(self.blend)].max(initial=0.0)
        # A length lies between two printed points, and both are rounded.
        self.slack = context.resolution + float(
            np.clip(self.tolerance - rounds, MIN_SLACK, self.tolerance)
        )
        self.track = np.unique(work.track[rows], return_inverse=True)[1].astype(np.int64)
        self.set_edges(edges)

    def set_edges(self, edges: Edges) -> None:
        """Set the edges that must be cut, creased or grooved; each is required over its entire
        length.
        """
        self.edges = edges
        self.size = edges.curve[:, 5]
        self.low, self.high = np.zeros(len(edges)), self.size.copy()
        self.depth = np.zeros(len(edges))
        self.depth_tolerance = np.full(len(edges), self.context.depth_tolerance)
        #: (n,) mm of each curve before the start of the drawn edge
        self.before = np.zeros(len(edges))
        #: (n, 2) mm at start and end where a tip path is allowed but not required
        self.spare = np.zeros((len(edges), 2))

    def run(self) -> None:
        """Run the check if there are tip paths or edges to compare, else do nothing."""
        if len(self.curve) or len(self.edges):
            self.check()

    @abstractmethod
    def check(self) -> None:
        """Compare the tip paths with the edges; add findings and the measured figures of each
        edge.
        """

    def tool(self, kind: type[ToolKind]) -> ToolKind | None:
        """Return the tool of the checked station, or None if that tool is not of the class
        ``kind``.

        If there are no tip paths to check, the station is unknown.  The result is then the first
        tool of the class ``kind`` that is mounted in the machine, or None if there is none.
        """
        stations = self.context.machine.stations
        if len(self.station):
            tool = stations[int(self.station[0])].tool
            return tool if isinstance(tool, kind) else None
        return next((station.tool for station in stations if isinstance(station.tool, kind)), None)

    def add_finding(
        self,
        kind: str,
        edge: int,
        message: Message,
        measure: float,
        work: int = -1,
        line: int = -1,
        severity: Severity = Severity.FAULT,
    ) -> None:
        """Append a finding to the verdict.

        Parameters
        ----------
        kind, message
            Kind of the finding, such as "depth", and its text.
        edge
            Index of the edge that the finding concerns, -1 for none.
        measure
            Size of the fault, in the unit of the kind: mm or degrees.
        work, line
            Index of the tip path whose program line the finding gets.  If ``work`` is -1, the
            finding gets the program line ``line``, or none if ``line`` is -1 too.
        severity
            Whether the finding is a fault, a shortfall or a note.
        """
        row = int(self.edges.row[edge]) if edge >= 0 else -1
        line = int(self.line[work]) if work >= 0 else line
        self.findings.add(kind, message, measure, edge=row, line=line, severity=severity)

    def record_overcut(self, edges: I64, measure: F64) -> None:
        """Increase the recorded overcut of each edge of ``edges`` to ``measure`` if ``measure`` is
        greater.

        ``edges`` are k indices of edges, and ``measure`` is the overcut of each of them, (k,) mm.
        """
        rows = self.edges.row[edges]
        np.maximum.at(self.figures.overcut, rows, measure)

    def match_edges(self) -> Overlaps:
        """Return the overlaps of the tip paths with the edges.

        An overlap is a stretch of a tip path within the tolerance of an edge.
        """
        return self.edges.find_overlaps(self.curve, self.tolerance, (self.low, self.high))

    def check_position(
        self, overlaps: Overlaps, final: Bool | None = None, wide: F64 | None = None
    ) -> None:
        """Check the distance of the tip paths from the drawing, and the depth of the tip; add
        findings.

        The distance is the sum of three parts: distance of the tip path from the edge, rounding of
        the path by the controller, and distance of the edge from the curve of the file.

        Parameters
        ----------
        overlaps
            Overlaps of the tip paths with the n edges.
        final
            Mask of the overlaps whose depth is checked; with None, the depth of all is checked.
        wide : (n,) mm
            Greatest permitted distance for each edge; with None, the tolerance of the
            verification.
        """
        limit = np.full(len(self.edges), self.tolerance) if wide is None else wide
        best = np.flatnonzero(overlaps.best)
        work, edge = overlaps.curve[best], overlaps.edge[best]
        distance, blend, rows = overlaps.distance[best], self.blend[work], self.edges.row[edge]
        fit_error = self.context.fit_error[rows]
        along, place = overlaps.along[best], overlaps.place[best]
        span, size = (np.abs(stretch[:, 1] - stretch[:, 0]) for stretch in (place, along))
        # A path across the tolerance band, as at a corner, follows another edge.
        follows, permitted = span >= 0.5 * size, limit[edge] + 1e-9
        far = np.flatnonzero(follows & (distance + blend + fit_error > permitted))
        if len(far):
            distance[far] = self._distances_where_nearest(overlaps, best[far])
        shown = self.figures.record_deviation(rows, distance, blend, fit_error)
        for row in far[(distance + blend + fit_error > permitted)[far]][:MAX_FINDINGS]:
            parts = {
                "distance": distance[row],
                "rounding": blend[row],
                "tolerance": limit[edge[row]],
            }
            message = Message("verify.off-line", tool=self.operation.tool, **parts)
            severity = Severity.FAULT
            if distance[row] + blend[row] <= permitted[row]:
                message = Message("verify.off-curve", fit=fit_error[row], **parts)
                severity = Severity.SHORTFALL
            self.add_finding(
                "deviation", edge[row], message, shown[row], work[row], severity=severity
            )
        drawn = self.size[edge] - self.before[edge] - self.spare[edge, 1]
        before = self.before[edge]
        stretches = FollowedStretches(work, along, edge, place)
        curve = np.ascontiguousarray(self.curve)
        positions, offsets = sample_stretches(curve, self.edges.curve, stretches)
        for position, offset in zip(positions, offsets, strict=True):
            self.context.samples.append((rows, (position - before) / drawn, offset))
        if "Z" not in self.context.programmed:
            return
        deep = self.context.board.caliper - self.z[work]
        lowest, highest = self.planned_depths(edge, place)
        planned = np.where(np.abs(deep - lowest) > np.abs(deep - highest), lowest, highest)
        wrong = np.abs(deep - planned)
        if final is not None:
            wrong[~final[best]] = 0.0
        for row in np.flatnonzero(wrong > self.depth_tolerance[edge])[:MAX_FINDINGS]:
            self.add_finding(
                "depth",
                edge[row],
                Message(
                    "verify.wrong-depth",
                    tool=self.operation.tool,
                    depth=deep[row],
                    planned=planned[row],
                ),
                wrong[row],
                work[row],
            )

    def _distances_where_nearest(self, overlaps: Overlaps, rows: I64) -> F64:
        """Return the greatest distance from its edge of each of n overlaps where the path is near
        no nearer edge, (n,) mm.

        At a corner a path leaves the tolerance band of one edge while it follows the other edge.
        ``rows`` are the indices of the overlaps.
        """
        count = 8
        start, end = nearest_parts(overlaps, rows).T
        bounds = np.linspace(start, end, count + 1, axis=1)
        pieces = np.repeat(rows, count)
        along = np.column_stack([bounds[:, :-1].ravel(), bounds[:, 1:].ravel()])
        stretches = FollowedStretches(
            overlaps.curve[pieces], along, overlaps.edge[pieces], overlaps.place[pieces]
        )
        curve = np.ascontiguousarray(self.curve)
        _, offsets = sample_stretches(curve, self.edges.curve, stretches)
        result: F64 = np.abs(offsets).max(axis=0).reshape(-1, count).max(axis=1)
        return result

    def planned_depths(self, edge: I32, place: F64) -> tuple[F64, F64]:  # noqa: ARG002  # subclasses use them
        """Return the least and the greatest planned depth of the tip along k stretches, (k,) mm
        each.

        Parameters
        ----------
        edge : (k,)
            Index of the edge of each stretch.
        place : (k, 2) mm
            Positions on the edge at which each stretch starts and ends.
        """
        return self.depth[edge], self.depth[edge]

    def check_plunges(self) -> None:
        """Add a finding for each plunge without a move before the lift.

        No such plunge is planned for a blade.  Its heading has no direction of travel to follow,
        and where the blade is turned across the edge, it cuts into the panel.
        """
        for work in np.flatnonzero(self.curve[:, 5] < 1e-6)[:MAX_FINDINGS]:
            x, y = point_at(self.curve[work : work + 1], np.zeros(1))[0]
            message = Message("verify.plunge-without-move", tool=self.operation.tool, x=x, y=y)
            self.add_finding("stray", -1, message, 0.0, work)

    def check_heading(
        self, overlaps: Overlaps, reach: F64, turn: float, chorded: Bool | None = None
    ) -> None:
        """Check the heading of the tool along edges and past the ends of edges; add findings.

        Parameters
        ----------
        overlaps
            Overlaps of the tip paths with the n edges.
        reach : mm
            Distance from the tip to the farthest point of the tool, one per tip path.
        turn : degrees
            Rotation after which the tool has the same shape again: 180 or 360.
        chorded : (n,)
            Mask of the edges that the tool follows in chords; None if the tool follows no edge in
            chords.  On these edges the heading is compared with the direction of the chord, on all
            other edges with the direction of the edge.
        """
        best = np.flatnonzero(overlaps.best)
        work, edge = overlaps.curve[best], overlaps.edge[best]
        chords = np.zeros(len(self.edges), np.bool_) if chorded is None else chorded
        worst = self._heading_errors(overlaps, best, chords, turn)
        wrong = np.flatnonzero(_swing_lengths(reach[work], worst) > self.tolerance)
        if len(wrong):
            worst[wrong] = self._least_errors(overlaps, best[wrong], worst[wrong], chords, turn)
        # A shift of the tip by rounding turns the direction of an arc by this shift / radius.
        shift = max(PRINT_TURN, self.context.resolution)
        arcs = np.flatnonzero(self.edges.curve[edge, 0] != 0.0)
        slack = np.zeros(len(best))
        slack[arcs] = np.degrees(shift / self.edges.curve[edge[arcs], 3])
        if self.operation == OperationKind.CREASE:
            # The wheel rolls straight over a short gap between creases whose ends lie a little
            # beside their common line.
            lines = np.flatnonzero(self.edges.curve[edge, 0] == 0.0)
            size = np.maximum(self.size[edge[lines]], JOIN_DISTANCE)
            slack[lines] = np.degrees(JOIN_DISTANCE / size)
        self.check_swing(worst, reach[work], slack, work, edge)

        # A path past an edge has no edge to compare with, only its own direction.
        path_rows, spans = uncovered_curves(overlaps, self.curve)
        long = np.flatnonzero(spans[:, 1] - spans[:, 0] > self.tolerance)
        path_rows, spans = path_rows[long], spans[long]
        error = np.zeros(len(path_rows))
        for side in range(2):
            fraction = spans[:, side] / self.curve[path_rows, 5]
            heading = (
                self.heading[path_rows, 0] * (1.0 - fraction)
                + self.heading[path_rows, 1] * fraction
            )
            error = np.maximum(
                error,
                angle_between(heading, azimuth_at(self.curve[path_rows], spans[:, side]), turn),
            )
        # Both ends of the path are rounded.
        apart = max(PRINT_TURN, 2.0 * self.context.resolution)
        slack = np.degrees(apart / np.maximum(self.curve[path_rows, 5], apart))
        self.check_swing(error, reach[path_rows], slack, path_rows, np.full(len(path_rows), -1))

    def _heading_errors(self, overlaps: Overlaps, rows: I64, chorded: Bool, turn: float) -> F64:
        """Return the error of the heading in each of k overlaps, (k,) degrees."""
        errors: F64 = heading_errors(
            np.ascontiguousarray(self.curve),
            np.ascontiguousarray(self.heading),
            self.edges.curve,
            FollowedStretches(
                overlaps.curve[rows],
                overlaps.along[rows],
                overlaps.edge[rows],
                overlaps.place[rows],
            ),
            chorded,
            self.operation == OperationKind.CREASE,
            turn,
        )
        return errors

    def _least_errors(
        self, overlaps: Overlaps, rows: I64, errors: F64, chorded: Bool, turn: float
    ) -> F64:
        """Return the least error of the heading of k overlaps with any edge there, (k,) degrees.

        Where two edges lie within the tolerance, rounded coordinates may put a tip path nearer to
        the other edge than to its own.  All edges that it follows over the same stretch count.

        ``rows``, ``errors`` (k,): indices of the overlaps, and the error in each of them in
        degrees.
        """
        first = np.searchsorted(overlaps.curve, overlaps.curve[rows])
        count = np.searchsorted(overlaps.curve, overlaps.curve[rows], side="right") - first
        owner = np.repeat(np.arange(len(rows)), count)
        other = first[owner] + np.arange(len(owner)) - np.repeat(np.cumsum(count) - count, count)
        along, place = overlaps.along[other], overlaps.place[other]
        own = overlaps.along[rows[owner]]
        same = np.abs(place[:, 1] - place[:, 0]) > 0.5 * (along[:, 1] - along[:, 0])
        same &= (along[:, 0] <= own[:, 0] + SHORT) & (along[:, 1] >= own[:, 1] - SHORT)
        other, owner = other[same], owner[same]
        least = errors.copy()
        np.minimum.at(least, owner, self._heading_errors(overlaps, other, chorded, turn))
        return least

    def check_swing(
        self, error: F64, reach: F64, slack: F64, work: I32 | I64, edge: I32 | I64
    ) -> None:
        """Add a finding for each wrong heading that swings the tool by more than the tolerance.

        Parameters
        ----------
        error, slack : (k,) degrees
            k differences between the heading and the planned direction, and the part of each
            difference that is permitted because coordinates are rounded.
        reach : (k,) mm
            Distance from the tip to the farthest point of the tool.
        work, edge : (k,)
            Index of the tip path, and index of the edge, -1 for no edge.
        """
        if "C" not in self.context.programmed:
            return
        swing = _swing_lengths(reach, np.maximum(error - slack, 0.0))
        for row in np.flatnonzero(swing > self.tolerance)[:MAX_FINDINGS]:
            self.add_finding(
                "heading",
                int(edge[row]),
                Message(
                    "verify.wrong-heading",
                    tool=self.operation.tool,
                    degrees=error[row],
                    swing=swing[row],
                ),
                error[row],
                work[row],
            )

    def check_uncut(
        self,
        overlaps: Overlaps,
        edge_rows: I64,
        counted: Bool | None = None,
        forward: bool | None = None,
    ) -> None:
        """Check that tip paths cover edges completely; add a finding for each gap, and record the
        uncovered length of each edge.

        An edge must be covered between the points at which the tip may start and must stop.

        Parameters
        ----------
        overlaps
            Overlaps of the tip paths with the edges.
        edge_rows
            Indices of the edges to check.
        counted
            Mask of the overlaps that count as covering an edge; None if all count.
        forward
            The direction that the message names: True if the counted tip paths run from the start
            to the end of the edges, False if they run back, None for either direction.
        """
        size = self.size
        is_checked = np.zeros(len(self.edges), np.bool_)
        is_checked[edge_rows] = True
        is_checked &= self.high >= self.low
        keep = is_checked[overlaps.edge]
        if counted is not None:
            keep &= counted
        wide, edge, begin, line = self.edge_gaps(
            overlaps, np.flatnonzero(keep), np.flatnonzero(is_checked)
        )
        bare = wide > self.slack
        # A pressed crease is a point without length: it is made or not.
        bare |= (self.high - self.low < 1e-9)[edge] & (line < 0)
        missed = np.where(wide > 0.0, wide, size[edge])
        np.add.at(self.figures.uncut, self.edges.row[edge[bare]], missed[bare])
        work = self._missing_work(forward)
        for row in np.flatnonzero(bare)[:MAX_FINDINGS]:
            e = int(edge[row])
            place = begin[row] - self.before[e]
            location = Message("verify.where-from-start", place=place)
            if place < -self.slack:
                location = Message("verify.where-past-start")
            elif self.spare[e, 1] > 0.0 and begin[row] > self.low[e] + self.slack:
                drawn = self.size[e] - self.spare[e, 1]
                if drawn - begin[row] <= missed[row] + self.slack:
                    location = Message("verify.where-past-end")
            message = Message("verify.not-worked", length=missed[row], work=work, where=location)
            self.add_finding("uncut", e, message, missed[row], line=int(line[row]))

    def _missing_work(self, forward: bool | None) -> Message:
        """Return what an edge lacks: "a cut", "a crease" or "a groove".

        Only the text for a groove depends on ``forward``: it names the start of the edge (True),
        the end of the edge (False), or neither (None) as the point at which the tool starts.
        """
        if self.operation == OperationKind.CREASE:
            return Message("verify.work-creased")
        if self.operation != OperationKind.GROOVE:
            return Message("verify.work-cut")
        if forward is None:
            return Message("verify.work-grooved")
        return Message(
            "verify.work-grooved-from-start" if forward else "verify.work-grooved-from-end"
        )

    def edge_gaps(
        self, overlaps: Overlaps, overlap_rows: I64, edge_rows: I64
    ) -> tuple[F64, I64, F64, I64]:
        """Return the gaps between the stretches of edges that tip paths cover.

        There is one gap before each stretch and one after the last stretch of each edge.  Many gaps
        have length 0.  The length is negative if a stretch overlaps the stretches before it.

        Parameters
        ----------
        overlaps, overlap_rows
            Overlaps of the tip paths with the edges, and the indices of the overlaps that count.
        edge_rows
            Indices of the edges that are searched for gaps.

        Returns
        -------
        Four arrays, (k,) each: length of each gap (mm), index of its edge, start of the gap on the
        edge (mm), and the program line of a stretch next to the gap, -1 for an edge without
        stretches.
        """
        edge = overlaps.edge[overlap_rows].astype(np.int64)
        low, high = (position[overlap_rows] for position in overlaps.place_range())
        # A stretch beyond the limit belongs to another edge; there may be a gap in front of it.
        low = np.minimum(low, self.high[edge])
        line = self.line[overlaps.curve[overlap_rows]].astype(np.int64)
        # Add an empty stretch at the end of each edge, so that every gap lies before a stretch.
        edge = np.concatenate([edge, edge_rows])
        low = np.concatenate([low, self.high[edge_rows]])
        high = np.concatenate([high, self.high[edge_rows]])
        line = np.concatenate([line, np.full(len(edge_rows), -1)])
        order = order_in_groups(edge, low, high)
        edge, low, high, line = edge[order], low[order], high[order], line[order]
        # Offset each edge, so that one running maximum serves all edges.
        step = edge * (2.0 * float(self.size.max(initial=0.0)) + 1.0)
        reached = np.maximum.accumulate(high + step) - step
        new = np.ones(len(edge), np.bool_)
        new[1:] = edge[1:] != edge[:-1]
        before = np.where(new, self.low[edge], np.concatenate([[0.0], reached[:-1]]))
        before = np.maximum(before, self.low[edge])
        previous = np.where(new, -1, np.concatenate([[-1], line[:-1]]))
        return low - before, edge, before, np.where(line >= 0, line, previous)


def _swing_lengths(reach: F64, turned: F64) -> F64:
    """Return the lengths by which points at distances from the tip swing, (k,) mm.

    ``reach`` is the distance of each point, (k,) mm; ``turned`` is its angle, (k,) degrees.
    """
    swing: F64 = 2.0 * reach * np.sin(np.radians(turned) / 2.0)
    return swing
