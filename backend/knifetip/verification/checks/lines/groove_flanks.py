"""Find V-grooves whose flanks meet, so that no ridge remains between them.

In the top face a groove is a strip of half-width r on both sides of its line.  On the side of
another groove, the top face ends where the flank of the one groove enters the strip of the other
one: beside parallel grooves nearer than 2 r, and between two grooves that meet, or would meet, at
an angle φ for the length r cot(φ/2) from there.  At a right angle this length is r, as at each
corner of a tray.  So a shortfall is a length of more than r and the board's thickness, and a note a
length of more than 1.2 r between grooves at an angle, which is below 80°.

The flanks are curves beside the lines at the distance r, and the strips are found by the search for
overlaps, for straight grooves and for arcs.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.board import Board
from knifetip.model.dieline import LineType
from knifetip.model.machine import Machine
from knifetip.model.tool import VCutter
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.context import CheckContext
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.curve import azimuth_at, left_distance, line_curves, point_at
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.expectation.edge_paths import EdgePaths, edge_paths, link_ends
from knifetip.verification.expectation.edges import (
    STRAIGHT_ANGLE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    without_duplicates,
)

#: Greatest turn at a joint of edges that are one groove (degrees).
_SMOOTH: Final = 20.0
#: Flanks nearer to the border of a strip than this do not enter it (mm).
_BORDER: Final = 1e-4
#: Least length of a note, in half-widths of the groove.
_NOTED: Final = 1.2
#: Greatest number of findings.
_MOST_FINDINGS: Final = 50


@dataclass(frozen=True, eq=False, slots=True)
class _Stretches:
    """k stretches of flanks that lie in the strip of another groove."""

    edge: I64  #: (k,) the edge of the flank
    along: F64  #: (k, 2) mm along this edge
    other: I64  #: (k,) the edge of the strip
    place: F64  #: (k, 2) mm along the edge of the strip, beside ``along``
    left: I64  #: (k,) 1 if the flank is to the left of its edge, -1 if to the right


@dataclass(frozen=True, slots=True)
class _Meeting:
    """A length along which the flanks of two grooves meet."""

    pair: tuple[int, int]  #: the numbers of the two grooves
    length: float  #: mm
    edge: int  #: index of the edge of the flank
    other: int  #: index of the edge of the strip
    place: F64  #: (2,) mm, where the lines of the grooves are nearest
    distance: float  #: mm between the lines there
    angle: float  #: degrees between the lines there


def groove_width(board: Board, machine: Machine) -> float:
    """Return the width of a V-groove in the top face (mm); 0 without a V-cutter."""
    tilts = [one.tool.tilt for one in machine.stations if isinstance(one.tool, VCutter)]
    return 2.0 * board.groove_depth * math.tan(math.radians(tilts[0])) if tilts else 0.0


def check_groove_flanks(context: CheckContext) -> None:
    """Add a shortfall or a note for each two V-grooves that leave no ridge between them."""
    edges, _, _ = without_duplicates(context.edges.with_types(LineType.V_GROOVE))
    width = groove_width(context.board, context.machine)
    if len(edges) < 2 or width <= 0.0:
        return
    half = 0.5 * width
    least = half + context.board.caliper
    meetings = sorted(_meetings(edges, half, _NOTED * half), key=lambda one: -one.length)
    seen: set[tuple[int, int]] = set()
    for meeting in meetings:
        if meeting.pair in seen or len(seen) == _MOST_FINDINGS:
            continue
        is_long = meeting.length > least
        if not is_long and meeting.angle <= STRAIGHT_ANGLE:
            continue
        seen.add(meeting.pair)
        severity = Severity.SHORTFALL if is_long else Severity.NOTE
        values = {"length": meeting.length, "width": width}
        if meeting.angle > STRAIGHT_ANGLE:
            x, y = meeting.place
            message = Message(
                "verify.grooves-at-angle", angle=meeting.angle, x=float(x), y=float(y), **values
            )
        else:
            message = Message("verify.grooves-meet", distance=meeting.distance, **values)
        row = int(edges.row[max(meeting.edge, meeting.other)])
        context.findings.add("near", message, meeting.length, edge=row, severity=severity)


def _meetings(edges: Edges, half: float, least: float) -> list[_Meeting]:
    """Return where the flanks of two grooves meet for more than ``least`` mm.

    ``edges`` are the edges of grooves, and ``half`` is the half-width of a groove (mm).
    """
    paths = edge_paths(edges, link_ends(edges, _SMOOTH)[0])
    stretches = _stretches(edges, half)
    own, other = paths.path[stretches.edge], paths.path[stretches.other]
    side = np.where(paths.flipped[stretches.edge], -stretches.left, stretches.left)
    position = _positions(paths, edges, stretches.edge[:, None], stretches.along)
    low, high = position.min(axis=1), position.max(axis=1)
    # Stretches of one flank that follow each other in the strip of one groove are one run.
    order = np.lexsort((low, other, side, own))
    key = np.column_stack([own, side, other])[order]
    group = np.cumsum(np.append(False, (key[1:] != key[:-1]).any(axis=1))[: len(order)])
    apart = group * (float(paths.length.max()) + 1.0)
    reached = np.maximum.accumulate(high[order] + TOUCH_DISTANCE + apart)
    first = np.flatnonzero(np.append(True, (low[order] + apart)[1:] > reached[:-1])[: len(order)])
    begin, finish = (
        low[order[first]],
        np.maximum.reduceat(high[order], first) if len(first) else low,
    )
    long = np.flatnonzero(finish - begin > least)
    if not len(long):
        return []
    met = _meeting_positions(edges, paths, half)
    last = np.append(first[1:], len(order))
    result: list[_Meeting] = []
    for run in long:
        rows = order[first[run] : last[run]]
        pair = int(own[rows[0]]), int(other[rows[0]])
        inner = (at for at in met.get(pair, ()) if begin[run] < at < finish[run])
        bounds = [float(begin[run]), *sorted(inner), float(finish[run])]
        for span in pairwise(bounds):
            if span[1] - span[0] > least:
                row, share = _stretch_ends(rows, position, np.array(span))
                meeting = _nearest(edges, stretches, row, share)
                result.append(_Meeting((min(pair), max(pair)), span[1] - span[0], *meeting))
    return result


def _stretch_ends(rows: I64, position: F64, span: F64) -> tuple[I64, F64]:
    """Return the stretch at each end of a part of a run, (2,), and where on it the end lies, (2,).

    Where is 0 for the start of the stretch, and 1 for its end.

    ``rows``: the stretches of the run.
    ``position`` (k, 2) mm: ends of all stretches along their groove.
    ``span`` (2,) mm: start and end of the part.
    """
    start, end = position[rows].T
    low, high = np.minimum(start, end), np.maximum(start, end)
    row = np.argmin(np.maximum(low - span[:, None], span[:, None] - high), axis=1)
    size = (end - start)[row]
    share = (span - start[row]) / np.where(size == 0.0, 1.0, size)
    return rows[row], np.clip(share, 0.0, 1.0)


def _nearest(
    edges: Edges, stretches: _Stretches, row: I64, share: F64
) -> tuple[int, int, F64, float, float]:
    """Return edge, other edge, place, distance and angle at the one of k places on stretches at
    which the lines of the grooves are nearest; see ``_Meeting``.

    ``row``, ``share`` (k,): the stretch of each place, and where on it the place lies (0 to 1).
    """
    edge, other = stretches.edge[row], stretches.other[row]
    weight = np.column_stack([1.0 - share, share])
    along = (stretches.along[row] * weight).sum(axis=1)
    place = (stretches.place[row] * weight).sum(axis=1)
    curve, beside = edges.curve[edge], edges.curve[other]
    distance = np.abs(left_distance(curve, along, beside))
    angle = angle_between(azimuth_at(curve, along), azimuth_at(beside, place), 180.0)
    k = int(np.argmin(distance))
    point = point_at(curve, along)[k]
    return int(edge[k]), int(other[k]), point, float(distance[k]), float(angle[k])


def _stretches(edges: Edges, half: float) -> _Stretches:
    """Return the stretches of the flanks of n grooves that lie in the strip of another one."""
    flanks, left, owner = [], [], []
    for side in (1, -1):
        rows, curve = _offset(edges.curve, side * half)
        flanks.append(curve)
        owner.append(rows)
        left.append(np.full(len(rows), side))
    curves, rows = np.concatenate(flanks), np.concatenate(owner)
    found: Overlaps = edges.find_overlaps(curves, half - _BORDER)
    edge, other = rows[found.curve], found.edge.astype(np.int64)
    scale = edges.curve[edge, 5] / curves[found.curve, 5]
    keep = np.flatnonzero(edge != other)
    return _Stretches(
        edge[keep],
        (found.along * scale[:, None])[keep],
        other[keep],
        found.place[keep],
        np.concatenate(left)[found.curve][keep],
    )


def _offset(curve: F64, left: float) -> tuple[I64, F64]:
    """Return the lines and arcs at the distance ``left`` (mm) to the left of n curves, (m, 6), and
    the index of the curve of each, (m,).

    An arc whose radius would not remain positive has none.
    """
    straight = curve[:, 0] == 0.0
    radius = np.where(straight, 1.0, curve[:, 3])
    # To the left of an anticlockwise arc lies its centre.
    factor = np.where(straight, 1.0, 1.0 - curve[:, 0] * left / radius)
    result = curve.copy()
    result[straight, 1] -= left * curve[straight, 4]
    result[straight, 2] += left * curve[straight, 3]
    result[~straight, 3] *= factor[~straight]
    result[:, 5] *= factor
    rows = np.flatnonzero(factor * radius > _BORDER)
    return rows, result[rows]


def _positions(paths: EdgePaths, edges: Edges, edge: I64, along: F64) -> F64:
    """Return positions along the groove of an edge, for positions along the edge (mm)."""
    size = edges.curve[edge, 5]
    result: F64 = paths.begin[edge] + np.where(paths.flipped[edge], size - along, along)
    return result


def _meeting_positions(
    edges: Edges, paths: EdgePaths, half: float
) -> dict[tuple[int, int], list[float]]:
    """Return the positions along a groove at which another one meets it, for each pair (mm).

    These are the places beside an end of the other groove that is nearer than the half-width
    ``half`` (mm), and the places at which the lines cross without such an end.
    """
    ends = np.concatenate([paths.first, paths.last])
    groove = np.tile(np.arange(len(paths.length)), 2)[ends >= 0]
    points = edges.ends[ends[ends >= 0]]
    beside = edges.find_overlaps(line_curves(points, points), half)
    crossed = edges.find_overlaps(edges.curve, TOUCH_DISTANCE)
    crossed = crossed.select(crossed.curve != crossed.edge)
    edge = np.concatenate([beside.edge, crossed.edge]).astype(np.int64)
    other = np.concatenate([groove[beside.curve], paths.path[crossed.curve]])
    place = np.concatenate([beside.place, crossed.place])
    position = _positions(paths, edges, edge[:, None], place)
    result: dict[tuple[int, int], list[float]] = {}
    for own, met, at in zip(paths.path[edge], other, np.sort(position, axis=1), strict=True):
        known = result.setdefault((int(own), int(met)), [])
        if not any(at[0] - TOUCH_DISTANCE <= one <= at[1] + TOUCH_DISTANCE for one in known):
            known.append(float(at.mean()))
    return result
