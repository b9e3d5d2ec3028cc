"""Check the passes in which a knife cuts thick board, and leave out all but the last of each cut.

The steps between the passes are limited by the knife and the board: a tip path may be deeper than
the paths before it along the same line by at most one step.  The checks of edges then see the last
pass only, and its verdict is that of the passes with the same direction and headings.  A pass that
no such deeper one repeats stays, so that it must be a half-cut of the drawing.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import suits
from knifetip.model.tool import Knife
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import DEPTH_TOLERANCE, CheckContext
from knifetip.verification.checks.common.pass_depth import Passes, report_deep_passes
from knifetip.verification.columns import Bool
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.joined_work import JoinedWork
from knifetip.verification.kinematics import TipPaths

#: Greatest difference between the headings of two passes of the same cut (degrees).
_SAME_HEADING: Final = 0.1


def check_knife_passes(context: CheckContext, work: JoinedWork) -> None:
    """Add a finding for each tip path of a knife that is more than one step deeper than those
    before it, and a note for each knife that does not suit the board.

    A program that does not set the depth of the knife has a note instead of such findings.
    """
    paths = work.paths
    for index, station in enumerate(context.machine.stations):
        rows = np.flatnonzero(paths.station == index)
        if not isinstance(station.tool, Knife) or len(rows) == 0:
            continue
        if not suits(station.tool, context.board) and not station.tool.oscillating:
            note = Message("verify.fixed-blade", station=station.number)
            context.findings.add("planned", note, 0.0, severity=Severity.NOTE)
        step = station.tool.step
        if step == 0.0:
            continue
        deepest = context.board.caliper + context.machine.into_mat
        if "Z" not in context.programmed:
            if deepest > step:
                note = Message("verify.one-pass", step=step, depth=deepest)
                context.findings.add("planned", note, deepest, severity=Severity.NOTE)
            continue
        deep = context.board.caliper - paths.z[rows]
        passes = Passes(paths.curve[rows], deep, paths.line[rows])
        report_deep_passes(context, "knife", passes, step, context.tolerance)


def last_passes(context: CheckContext, work: JoinedWork) -> TipPaths:
    """Return the tip paths of all programs without those that a later pass of a knife repeats."""
    paths = work.paths
    kept = np.ones(len(paths.z), np.bool_)
    for index, station in enumerate(context.machine.stations):
        if isinstance(station.tool, Knife) and (station.tool.step > 0.0 or context.has_passes):
            rows = np.flatnonzero(paths.station == index)
            kept[rows] = ~_are_repeated(paths.select(paths.station == index), context.tolerance)
    return paths if kept.all() else paths.select(kept)


def _are_repeated(paths: TipPaths, near: float) -> Bool:
    """Return the mask of n tip paths that a later one repeats at a greater depth, (n,).

    The later path has the same direction and the same headings, so that the checks of edges are
    valid for both.

    ``paths``: the tip paths of one knife in the order of the program.
    ``near`` mm: greatest distance between two passes of the same cut.
    """
    size = paths.curve[:, 5]
    overlaps = find_overlaps(paths.curve, paths.curve, np.zeros(len(size)), size, near)
    later = overlaps.edge > overlaps.curve
    later &= paths.z[overlaps.edge] < paths.z[overlaps.curve] - DEPTH_TOLERANCE
    one, other = overlaps.curve[later], overlaps.edge[later]
    same = np.ones(len(one), np.bool_)
    for part in (0.0, 0.5, 1.0):
        points = point_at(paths.curve, part * size)
        same &= np.hypot(*(points[one] - points[other]).T) <= near
    turn = np.abs((paths.heading[one] - paths.heading[other] + 180.0) % 360.0 - 180.0)
    same &= (turn <= _SAME_HEADING).all(axis=1)
    repeated = np.zeros(len(size), np.bool_)
    repeated[one[same]] = True
    return repeated
