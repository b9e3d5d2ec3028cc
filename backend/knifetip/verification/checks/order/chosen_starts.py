"""Check that closed cuts begin and run as the user has chosen.

The tip paths are divided into runs: paths of one depth, each of which begins where the one before
it ends.  A run that follows a chosen edge must contain a loop: from the chosen point round the
contour back to this point.  No path of the same depth may follow a part of the loop before it, so
that the cut does begin there.  Lead-ins come before the loop, and an overrun after it.

The centre of a cutter is beside the edge by the cutter's radius, so its loop begins there.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Station
from knifetip.model.tool import Knife
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.chosen_starts import ExpectedStart
from knifetip.verification.expectation.cutter_paths import disc_reach
from knifetip.verification.kinematics import TipPaths
from knifetip.verification.tools import OperationKind, expected_tool


def check_chosen_starts(
    context: CheckContext, starts: Sequence[ExpectedStart], paths: TipPaths
) -> None:
    """Add a finding for each chosen edge whose closed cut begins elsewhere or runs against the
    chosen direction.

    ``paths`` are the tip paths of all programs of the sheet, in the order of the work.
    """
    cuts = (OperationKind.CUT, OperationKind.HALF_CUT, OperationKind.MILL)
    rows = np.flatnonzero(np.isin(paths.operation, cuts) & (paths.curve[:, 5] > 0.0))
    for start in starts:
        against = False
        for index in np.unique(paths.station[rows]):
            station = context.machine.stations[int(index)]
            own = rows[paths.station[rows] == index]
            answers = [
                _Contour(context, start, station, paths, own, side).check()
                for side in ((0.0,) if expected_tool(station.tool).disc is None else (1.0, -1.0))
            ]
            if True in answers:
                break
            against |= False in answers
        else:
            _add_finding(context, start, against)


def _add_finding(context: CheckContext, start: ExpectedStart, against: bool) -> None:
    """Add the finding that a cut begins elsewhere, or if ``against`` runs the other way."""
    if against:
        message = Message("verify.other-direction", edge=start.row)
    elif math.isnan(start.place):
        message = Message("verify.no-closed-cut", edge=start.row)
    else:
        x, y = start.point - start.placement
        message = Message("verify.other-start", edge=start.row, x=float(x), y=float(y))
    context.findings.add("order", message, 0.0, edge=start.row)


class _Contour:
    """The tip paths of one station beside one chosen edge, on one side of it."""

    def __init__(
        self,
        context: CheckContext,
        start: ExpectedStart,
        station: Station,
        paths: TipPaths,
        rows: I64,
        side: float,
    ) -> None:
        """Select the tip paths ``rows`` of a station.

        ``side`` is the side of the edge on which a cutter's centre runs: 1 left, -1 right; 0 for a
        knife, whose tip runs on the edge.
        """
        self.start, self.side = start, side
        self.curve, self.z = paths.curve[rows], paths.z[rows]
        first, last = paths.ends()
        self.first, self.last = first[rows], last[rows]
        self.limit = context.tolerance + start.moved + 2.0 * context.resolution
        reach = np.zeros(2) if side == 0.0 else disc_reach(context.board, station)
        self.limit += abs(float(reach[0] - reach[1]))
        self.shift = side * float(reach.mean())
        self.point = start.point + start.left * side * reach
        slant = station.tool.blade_angle if isinstance(station.tool, Knife) else 0.0
        through = context.board.caliper + context.machine.into_mat
        #: greatest length by which another cut may run along the contour before it is cut (mm)
        self.overrun = 4.0 * self.limit + through * math.tan(math.radians(slant))

    def check(self) -> bool | None:
        """Return whether the cut runs in the chosen direction, from the chosen point; None if no
        run follows the edge, or if one of them does not begin there.
        """
        along = self._follow_edge()
        if len(along.curve) == 0:
            return None
        answer: bool | None = True
        for run in self._runs():
            on_edge = np.isin(along.curve, run)
            if not on_edge.any():
                continue
            loop = self._loop(run, along.curve[on_edge].min())
            if len(loop) == 0 or self._is_followed_before(loop):
                return None
            counted = on_edge & np.isin(along.curve, loop)
            forward = along.place[counted, 1] > along.place[counted, 0]
            if self.start.forward is not None and (forward != self.start.forward).any():
                answer = False
        return answer

    def _follow_edge(self) -> Overlaps:
        """Return the stretches of tip paths that follow the edge."""
        edge = self.start.curve.copy()
        if edge[0] == 0.0:
            edge[1:3] += self.shift * np.array([-edge[4], edge[3]])
        else:
            # The centre of an arc to the left lies on its left.
            radius = edge[3] - edge[0] * self.shift
            if radius <= 0.0:
                return Overlaps.none()
            edge[5] *= radius / edge[3]
            edge[3] = radius
        found = find_overlaps(self.curve, edge[None], np.zeros(1), edge[5:], self.limit)
        size = np.diff(found.along)[:, 0]
        long = size > 0.5 * np.minimum(self.curve[found.curve, 5], float(edge[5]))
        # A path that only crosses the edge, or leaves it at an angle, does not follow it.
        return found.select(long & (np.abs(np.diff(found.place)[:, 0]) >= 0.5 * size))

    def _runs(self) -> Iterator[I64]:
        """Yield the indices of the tip paths of each run."""
        gap = np.hypot(*(self.first[1:] - self.last[:-1]).T)
        joined = (gap <= self.limit) & (np.abs(np.diff(self.z)) <= self.limit)
        yield from np.split(np.arange(len(self.z)), np.flatnonzero(~joined) + 1)

    def _loop(self, run: I64, low: int) -> I64:
        """Return the indices of the paths of a run that form the closed cut; empty if none do.

        ``low`` is the first path of the run that follows the edge.
        """
        for begin in run[run <= low]:
            point = self.point
            if math.isnan(self.start.place):
                point = self.first[begin]
            elif np.hypot(*(self.first[begin] - point)) > self.limit:
                continue
            rows = run[run >= begin]
            back = np.hypot(*(self.last[rows] - point).T) <= self.limit
            back[0] &= bool(self.curve[begin, 5] > 2.5 * self.limit)
            closing = rows[back]
            if len(closing) and closing[0] >= low:
                loop: I64 = rows[rows <= closing[0]]
                return loop
        return np.zeros(0, np.int64)

    def _is_followed_before(self, loop: I64) -> bool:
        """Return whether earlier tip paths of the same depth follow a part of a loop."""
        before = np.flatnonzero(np.abs(self.z - self.z[loop[0]]) <= self.limit)
        before = before[before < loop[0]]
        curves: F64 = self.curve[loop]
        found = find_overlaps(
            self.curve[before], curves, np.zeros(len(loop)), curves[:, 5], self.limit
        )
        length = np.diff(found.along)[:, 0]
        return bool((found.best & (length > self.overrun)).any())
