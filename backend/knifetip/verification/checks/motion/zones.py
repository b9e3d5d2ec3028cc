"""Check that no tool touches a keep-out zone of the machine.

A keep-out zone is a box on the table, such as a clamp or a stop.  The footprint of a station is a
disc about its axis with the radius of its tool or of its holder, whichever is larger; tool and
holder are taken to fill it from the tip upwards.  The footprint meets a zone if the axis enters
the zone grown by this radius: a rectangle with round corners.  A move touches the zone if its
footprint meets the zone and its lowest height of the tip is below the zone's top.

The grown zone is the union of two rectangles, each of them grown along one axis only, and of a disc
at each corner.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.machine import Machine, Zone
from knifetip.verification.columns import F64, Bool
from knifetip.verification.findings import MAX_FINDINGS, Findings
from knifetip.verification.reading.moves import Moves
from knifetip.verification.tools import body_radius

#: Part of the radius that may be in a zone: rounding of printed coordinates and of chords (mm).
_SLACK: Final = 0.01
#: Greatest distance between an arc and the chords that replace it (mm).
_SAGITTA: Final = 1e-3


def check_zones(moves: Moves, machine: Machine, findings: Findings) -> None:
    """Add a finding for each move in which a station touches a keep-out zone.

    A move whose height is unknown, or a program that does not move Z, is taken to be below the top
    of every zone.  A move from an unknown position may lead across every zone, so it must be above
    them; if the program does not move Z, such a move is checked at its end only.
    """
    if not machine.zones or len(moves.line) == 0:
        return
    datum = np.array([(one.x, one.y, one.z) for one in machine.stations] + [(0.0, 0.0, 0.0)])
    radius = np.array(
        [max(one.envelope, body_radius(one.tool)) for one in machine.stations] + [0.0]
    )
    start = moves.start[:, :3] - datum[moves.station]
    end = moves.end[:, :3] - datum[moves.station]
    lowest = np.minimum(start[:, 2], end[:, 2])
    if "Z" in moves.programmed:
        _check_unknown_starts(moves, start, end, machine, findings)
    else:
        lowest = np.full(len(lowest), -np.inf)
    start = np.where(np.isnan(start[:, :2]).any(axis=1)[:, None], end, start)
    for zone in machine.zones:
        low = ~(lowest >= zone.top) & ~np.isnan(end[:, :2]).any(axis=1)
        rows = np.flatnonzero(low & _may_meet(moves, start, end, radius[moves.station], zone))
        met = np.zeros(len(low), np.bool_)
        for row in rows:
            points = _points(moves, int(row), start[row, :2], end[row, :2], datum)
            size = max(float(radius[moves.station[row]]) - _SLACK, 0.0)
            met[row] = _enters(points[:-1], points[1:], size, zone).any()
        first = met & ~np.concatenate([[False], met[:-1]])
        for row in np.flatnonzero(first)[:MAX_FINDINGS]:
            station = int(moves.station[row])
            number = machine.stations[station].number if station >= 0 else 0
            depth = zone.top - lowest[row] if np.isfinite(lowest[row]) else zone.top
            message = Message("verify.in-zone", station=number, zone=zone.name, depth=depth)
            findings.add("travel", message, depth, line=moves.line[row])


def _check_unknown_starts(
    moves: Moves, start: F64, end: F64, machine: Machine, findings: Findings
) -> None:
    """Add a finding for moves from an unknown position below the top of the highest zone.

    A move sideways must be above the top all the way.  A move of Z alone may begin at an unknown
    height, if it ends above the top: the tool is taken to rise.

    ``start``, ``end`` (n, 3) mm: positions of the tip before and after each of n moves; NaN where
    unknown.
    """
    highest = max(machine.zones, key=lambda zone: zone.top)
    unknown = np.isnan(start[:, :2]) | np.isnan(end[:, :2])
    moved = (start != end) & ~np.isnan(end)
    sideways = moved[:, :2].any(axis=1)
    lowest = np.where(sideways, np.minimum(start[:, 2], end[:, 2]), end[:, 2])
    low = unknown.any(axis=1) & moved.any(axis=1) & ~(lowest >= highest.top)
    for row in np.flatnonzero(low)[:MAX_FINDINGS]:
        message = Message("verify.unknown-beside-zone", zone=highest.name, top=highest.top)
        findings.add("travel", message, 0.0, line=moves.line[row])


def _may_meet(moves: Moves, start: F64, end: F64, radius: F64, zone: Zone) -> Bool:
    """Return the mask of the n moves whose bounding circle or box may meet a zone, (n,)."""
    # An arc lies within its diameter around its start.
    spoke = np.hypot(*(moves.start[:, :2] - moves.centre).T)
    wide = np.where(moves.sweep != 0.0, 2.0 * np.nan_to_num(spoke), 0.0) + radius
    result: Bool = (np.minimum(start[:, 0], end[:, 0]) - wide <= zone.x + zone.width) & (
        np.maximum(start[:, 0], end[:, 0]) + wide >= zone.x
    )
    result &= np.minimum(start[:, 1], end[:, 1]) - wide <= zone.y + zone.height
    result &= np.maximum(start[:, 1], end[:, 1]) + wide >= zone.y
    return result


def _points(moves: Moves, row: int, start: F64, end: F64, datum: F64) -> F64:
    """Return points along the way of the axis in a move, whose chords replace it, (k, 2) mm."""
    sweep = float(moves.sweep[row])
    if sweep == 0.0:
        return np.stack([start, end])
    centre = moves.centre[row] - datum[moves.station[row], :2]
    radius = math.dist(start, centre)
    pieces = max(1, math.ceil(abs(sweep) * math.sqrt(radius / (8.0 * _SAGITTA))))
    first = math.atan2(start[1] - centre[1], start[0] - centre[0])
    angle = first + sweep * np.arange(pieces + 1) / pieces
    result: F64 = centre + radius * np.column_stack([np.cos(angle), np.sin(angle)])
    return result


def _enters(start: F64, end: F64, radius: float, zone: Zone) -> Bool:
    """Return the mask of k straight lines that enter a zone that is grown by a radius, (k,).

    ``start`` and ``end`` are the ends of the lines, (k, 2) mm; ``radius`` is in mm.
    """
    x0, x1, y0, y1 = zone.x, zone.x + zone.width, zone.y, zone.y + zone.height
    met = _crosses(start, end, (x0 - radius, x1 + radius), (y0, y1))
    met |= _crosses(start, end, (x0, x1), (y0 - radius, y1 + radius))
    travel = end - start
    a = (travel**2).sum(axis=1)
    for corner in ((x0, y0), (x1, y0), (x0, y1), (x1, y1)):
        away = start - np.array(corner)
        # |away + t travel|² = radius² has a root between 0 and 1, or the start is inside.
        b, c = (away * travel).sum(axis=1), (away**2).sum(axis=1) - radius**2
        root = np.sqrt(np.maximum(b**2 - a * c, 0.0))
        first = (-b - root) / np.where(a > 0.0, a, 1.0)
        met |= (c < 0.0) | ((b**2 > a * c) & (a > 0.0) & (first >= 0.0) & (first <= 1.0))
    return met


def _crosses(start: F64, end: F64, x: tuple[float, float], y: tuple[float, float]) -> Bool:
    """Return the mask of k lines of which a part lies inside a rectangle, (k,).

    ``x`` and ``y`` are the limits of the rectangle along each axis (mm).
    """
    enter, leave = np.zeros(len(start)), np.ones(len(start))
    outside = np.zeros(len(start), np.bool_)
    for axis, (low, high) in enumerate((x, y)):
        travel = end[:, axis] - start[:, axis]
        still = travel == 0.0
        outside |= still & ((start[:, axis] <= low) | (start[:, axis] >= high))
        step = np.where(still, 1.0, travel)
        bounds = np.sort(
            np.stack([(low - start[:, axis]) / step, (high - start[:, axis]) / step]), 0
        )
        enter = np.where(still, enter, np.maximum(enter, bounds[0]))
        leave = np.where(still, leave, np.minimum(leave, bounds[1]))
    result: Bool = ~outside & (enter < leave) | (
        ~outside & (enter == leave) & (start == end).all(1)
    )
    return result
