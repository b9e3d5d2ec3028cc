"""Check where a blade turns in the board, and how far it cuts beside the line there.

The tip of a blade follows the line, but the blade has a body.  At a height h above the tip its
leading edge, slanted by α, is h tan α ahead of the tip, and its rear edge is a blade's width behind
it, both in the direction of the heading.  On an arc of radius r a point a mm ahead or behind lies
√(r² + a²) − r beside the line.  The distance grows with a, so it is greatest in the top face of the
board, where a = (T + m) tan α for a board of thickness T and a tip m below it.

Where a knife is lifted, its cut ends, and what the blade cuts past that point is the subject of
``track_ends``.  Here the points ahead of the tip count only where the track goes on as far, and
those behind it where it has come as far.

A track on which the blade turns by more than its ``swivel`` angle within its width is a note.  It
is a shortfall if the cut in the top face is farther from the line than the board's
``cut_tolerance``, or if the bend is tighter than the least radius of the blade or the board.
"""

from __future__ import annotations

import math
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.kernels import F64_2, I64_1, inline_kernel, kernel
from knifetip.messages import Message
from knifetip.model.tool import Knife
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.point_distance import distance_from_curve
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.tools import ANGLE_TOLERANCE

#: Poses of the blade that are examined on an arc.
_POSES: Final = 9
#: Least turn that belongs to a bend (radians).
_LEAST_TURN: Final = 1e-3


class BladePaths(NamedTuple):
    """The n tip paths of a blade, in the order of the program."""

    curve: F64_2  #: (n, 6) lines and arcs as rows of six numbers (see ``curves.curve``)
    heading: F64_2  #: (n, 2) degrees at the start and at the end of each path
    track: I64_1  #: (n,) number of the track, ascending; between two tracks the knife is lifted


def check_blade_bends(check: StationCheck, overlaps: Overlaps, blade: Knife, lead: float) -> None:
    """Add a note or a shortfall for each track on which the blade turns in the board.

    Tracks whose tightest bends have equal radii share one note.

    Parameters
    ----------
    check
        The check of the knife's station.
    overlaps
        Overlaps of the tip paths with the edges.
    blade
        The knife.
    lead : mm
        Length a by which the blade cuts the top face ahead of its tip.
    """
    if len(check.curve) == 0:
        return
    track = _tracks_between_swivels(check, blade) if blade.free else check.track
    paths = BladePaths(
        np.ascontiguousarray(check.curve), np.ascontiguousarray(check.heading), track
    )
    board = check.context.board
    turn = _greatest_turns(paths, blade.blade_width)
    top = _distances_beside(paths, lead)
    least_radius = max(blade.least_radius, board.least_radius)
    radius = _radii(paths)
    # A single turn up to the swivel angle is a corner that the knife may take in the board.
    turns = turn > blade.swivel + ANGLE_TOLERANCE
    top[~turns] = 0.0
    far, tight = top > board.cut_tolerance, radius < least_radius
    if not (turns | tight).any():
        return
    rear = _distances_beside(paths, -blade.blade_width)
    edge = np.full(len(check.curve), -1, np.int64)
    best = np.flatnonzero(overlaps.best)
    edge[overlaps.curve[best]] = overlaps.edge[best]
    needed = max(least_radius, (lead**2 - board.cut_tolerance**2) / (2.0 * board.cut_tolerance))
    noted: set[float] = set()
    for number in np.unique(paths.track[turns | tight])[:MAX_FINDINGS]:
        rows = np.flatnonzero(paths.track == number)
        bad = far[rows].any() or tight[rows].any()
        narrow = float(radius[rows].min())
        shown = rows[np.lexsort((-top[rows], radius[rows], edge[rows] < 0))[0]]
        if not bad and round(narrow, 1) in noted:
            continue
        noted.add(round(narrow, 1))
        message = Message(
            "verify.blade-bend-too-tight" if bad else "verify.blade-bend",
            turn=float(turn[rows].max()),
            width=blade.blade_width,
            radius=narrow,
            top=float(top[rows].max()),
            rear=float(rear[rows].max()),
            **({"tolerance": board.cut_tolerance, "least": needed} if bad else {}),
        )
        severity = Severity.SHORTFALL if bad else Severity.NOTE
        check.add_finding(
            "beside",
            int(edge[shown]),
            message,
            float(top[rows].max()),
            int(shown),
            severity=severity,
        )


def _tracks_between_swivels(check: StationCheck, blade: Knife) -> I64:
    """Return the track of each tip path of a free blade, (n,), with a new track after each corner.

    At a corner the blade turns about its tip (``blade_swivels``).
    """
    turned = np.abs(check.heading[1:, 0] - check.heading[:-1, 1])
    new = np.append(True, (turned > blade.swivel) | (check.track[1:] != check.track[:-1]))
    result: I64 = np.cumsum(new)
    return result


def _radii(paths: BladePaths) -> F64:
    """Return the radius of the bend that each tip path belongs to, infinite for none, (n,) mm.

    For an arc it is that of the arc, and for a chord along which the blade turns its length divided
    by the turn.  Where the blade turns at joints of lines, it is the length of
    the longer line divided by the turn, since a chord may be cut short by the end of the track.
    """
    curve = paths.curve
    radius = np.where(curve[:, 0] != 0.0, curve[:, 3], math.inf)
    # A chord along which C turns, as in languages without arcs.
    own = np.radians(np.abs(paths.heading[:, 1] - paths.heading[:, 0]))
    chord = (curve[:, 0] == 0.0) & (own > _LEAST_TURN)
    radius[chord] = curve[chord, 5] / own[chord]
    joint = np.flatnonzero(paths.track[1:] == paths.track[:-1])
    turned = np.radians(np.abs(paths.heading[joint + 1, 0] - paths.heading[joint, 1]))
    longer = np.maximum(curve[joint, 5], curve[joint + 1, 5])
    both = (curve[joint, 0] == 0.0) & (curve[joint + 1, 0] == 0.0) & (turned > _LEAST_TURN)
    bend = longer[both] / turned[both]
    np.minimum.at(radius, joint[both], bend)
    np.minimum.at(radius, joint[both] + 1, bend)
    return radius


@kernel
def _greatest_turns(paths: BladePaths, width: float) -> Any:
    """Return the greatest change of heading within ``width`` mm of travel up to the end of each tip
    path, (n,) degrees.
    """
    curve, heading, track = paths
    turn = np.zeros(len(track))
    for row in range(len(track)):
        low = high = heading[row, 1]
        left = width
        other = row
        while left > 0.0 and other >= 0 and track[other] == track[row]:
            size = curve[other, 5]
            share = min(1.0, left / size) if size > 0.0 else 1.0
            begin = heading[other, 1] + (heading[other, 0] - heading[other, 1]) * share
            low = min(low, begin, heading[other, 1])
            high = max(high, begin, heading[other, 1])
            left -= size
            other -= 1
        turn[row] = max(high - heading[row, 1], heading[row, 1] - low)
    return turn


@kernel
def _distances_beside(paths: BladePaths, reach: float) -> Any:
    """Return the greatest distance from its track of a point that moves with the blade, for each
    tip path, (n,) mm.

    The point is ``reach`` mm ahead of the tip in the direction of the heading, or behind it if
    ``reach`` is negative.  It counts only where the track leads on, or has led, as far.
    """
    curve, heading, track = paths
    beside = np.zeros(len(track))
    if reach == 0.0:
        return beside
    for row in range(len(track)):
        poses = 2 if curve[row, 0] == 0.0 else _POSES
        for pose in range(poses):
            share = pose / (poses - 1)
            along = share * curve[row, 5]
            x, y = _point_on(curve, row, along)
            turned = heading[row, 0] + (heading[row, 1] - heading[row, 0]) * share
            angle = math.radians(turned)
            x, y = x + reach * math.cos(angle), y + reach * math.sin(angle)
            beside[row] = max(beside[row], _distance_from_track(paths, row, along, x, y, reach))
    return beside


@inline_kernel
def _point_on(curve: F64_2, row: int, along: float) -> tuple[float, float]:
    if curve[row, 0] == 0.0:
        return curve[row, 1] + curve[row, 3] * along, curve[row, 2] + curve[row, 4] * along
    angle = curve[row, 4] + curve[row, 0] * along / curve[row, 3]
    return (
        curve[row, 1] + curve[row, 3] * math.cos(angle),
        curve[row, 2] + curve[row, 3] * math.sin(angle),
    )


@inline_kernel
def _distance_from_track(
    paths: BladePaths, row: int, along: float, x: float, y: float, reach: float
) -> float:
    """Return the distance of the point (x, y) from the part of the track that the point can be on;
    0 if the track ends before.
    """
    curve, _, track = paths
    step = 1 if reach > 0.0 else -1
    left = abs(reach) - (curve[row, 5] - along if step > 0 else along)
    least = distance_from_curve(x, y, curve, row)
    other = row + step
    while left > -abs(reach) and 0 <= other < len(track) and track[other] == track[row]:
        least = min(least, distance_from_curve(x, y, curve, other))
        left -= curve[other, 5]
        other += step
    return least if left <= 0.0 else 0.0
