"""Check how far a crease wheel presses beside bent creases, and how much of them it misses.

A wheel of radius R pressed in by δ touches the board along a straight line of length 2s,
s² = δ(2R − δ), in the direction of its heading.  On a crease that bends, the ends of this contact
lie beside the crease: on an arc of radius r by √(r² + s²) − r.  Because the wheel stops s before a
free end, the last s of a bent crease are pressed only as far as the contact stays on it.

The contact is taken from the program's tip paths: depth, heading and position.  It must lie within
the board's ``crease_tolerance`` of the creases; the rest is a shortfall of the track, that is, of
the creases that the wheel makes between two lifts.
"""

from __future__ import annotations

import math
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.tool import CreaseWheel
from knifetip.model.verdict import Severity
from knifetip.verification.checks.common.base import StationCheck
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.intervals import Overlaps
from knifetip.verification.curves.point_distance import distance_from_curves
from knifetip.verification.expectation.edges import Edges
from knifetip.verification.findings import MAX_FINDINGS

#: Poses of the wheel that are examined on each tip path, as fractions of its length.
_POSES: Final = np.linspace(0.0, 1.0, 5)
#: Distance of the points of a crease that are compared with the contacts (mm).
_PITCH: Final = 0.1
#: Most of these points on one crease.
_MOST_POINTS: Final = 2000
#: A track with at least so many tip paths may bend at its joints.
_MANY: Final = 3


def check_bends(
    check: StationCheck, overlaps: Overlaps, creases: Edges, contact: F64, wheel: CreaseWheel
) -> None:
    """Add a shortfall for each track whose contacts lie beside the creases by more than permitted.

    Parameters
    ----------
    check
        The check of the wheel's station, with the tip paths and the creases that it makes.
    overlaps
        Overlaps of the tip paths with these creases.
    creases
        All creases of the dieline, also those of other wheels.
    contact : (k,) mm
        Half the length s of the contact on each tip path.
    wheel
        The wheel.
    """
    permitted = check.context.board.crease_tolerance
    best = np.flatnonzero(overlaps.best)
    path, edge = overlaps.curve[best].astype(np.int64), overlaps.edge[best].astype(np.int64)
    tracks = _bent_tracks(check, path, edge, contact, permitted)
    if not tracks.any():
        return
    rows = np.flatnonzero(tracks[check.track])
    off = _off_creases(check, rows, contact, creases, permitted)
    for track in np.unique(check.track[rows[off]])[:MAX_FINDINGS]:
        own = check.track[path] == track
        # A track on no crease is stray work.
        if own.any():
            _report_track(check, path[own], edge[own], contact, creases, wheel)


def _bent_tracks(check: StationCheck, path: I64, edge: I64, contact: F64, permitted: float) -> Bool:
    """Return the mask of the tracks on which a contact may leave the creases, (t,).

    Such a track follows an arc that is too tight for the contact, or has many tip paths.  ``path``
    and ``edge`` are the tip path and the crease of each overlap.
    """
    count = int(check.track.max(initial=-1)) + 1
    kind, radius = check.edges.curve[edge, 0], check.edges.curve[edge, 3]
    tight = (kind != 0.0) & (np.hypot(radius, contact[path]) - radius > permitted)
    result: Bool = np.bincount(check.track, minlength=count) >= _MANY
    result[check.track[path[tight]]] = True
    return result


def _contact_ends(check: StationCheck, rows: I64, contact: F64) -> tuple[F64, F64]:
    """Return the tip positions and the ends of the contacts at several poses on n tip paths.

    Both results are (n, 2 p, 2) mm for p poses: the ends ahead of the tip come first, then the ends
    behind it.  ``rows`` are the indices of the tip paths.
    """
    curve, poses = check.curve[rows], len(_POSES)
    along = np.multiply.outer(curve[:, 5], _POSES)
    tip = point_at(np.repeat(curve, poses, axis=0), along.ravel()).reshape(-1, poses, 2)
    first, last = check.heading[rows, 0, None], check.heading[rows, 1, None]
    heading = np.radians(first + (last - first) * _POSES)
    reach = contact[rows, None, None] * np.stack([np.cos(heading), np.sin(heading)], axis=2)
    return np.concatenate([tip, tip], axis=1), np.concatenate([tip + reach, tip - reach], axis=1)


def _off_creases(
    check: StationCheck, rows: I64, contact: F64, creases: Edges, permitted: float
) -> Bool:
    """Return the mask of the tip paths on which an end of a contact lies beside all creases, (n,).

    ``rows`` are the indices of the n tip paths.
    """
    _, ends = _contact_ends(check, rows, contact)
    flat = ends.reshape(-1, 2)
    beside = np.ones(len(flat), np.bool_)
    beside[creases.find_overlaps(line_curves(flat, flat), permitted).curve] = False
    off: Bool = beside.reshape(len(rows), -1).max(axis=1)
    return off


def _report_track(
    check: StationCheck,
    path: I64,
    edge: I64,
    contact: F64,
    creases: Edges,
    wheel: CreaseWheel,
) -> None:
    """Add the shortfall of one track, on the crease beside which the wheel presses farthest.

    ``path`` and ``edge`` are the tip paths of the track and the creases that they follow.
    """
    board = check.context.board
    permitted = board.crease_tolerance
    paths = np.unique(path)
    tips, ends = _contact_ends(check, paths, contact)
    near = _creases_near(creases, ends.reshape(-1, 2), float(contact[paths].max()) + permitted)
    far = distance_from_curves(ends.reshape(-1, 2), near).reshape(len(paths), -1).max(axis=1)
    if not (far > permitted).any():
        return
    worst = int(paths[far.argmax()])
    shown = edge[path == worst]
    at = int(shown[np.argmax(check.size[shown])]) if len(shown) else int(edge[0])
    # The contacts at the ends of the track, and the paths of the tip between them.
    outer = [0, len(_POSES) - 1, len(_POSES), 2 * len(_POSES) - 1]
    touched = line_curves(
        tips[[0, -1]][:, outer].reshape(-1, 2), ends[[0, -1]][:, outer].reshape(-1, 2)
    )
    pressed = np.concatenate([check.curve[paths], touched])
    missed = sum(
        _unpressed_length(check, int(each), pressed, permitted) for each in np.unique(edge)
    )
    s, beside = float(contact[worst]), float(far.max())
    depth = wheel.radius - math.sqrt(max(wheel.radius**2 - s * s, 0.0))
    bend = (s * s - beside**2) / (2.0 * beside)
    message = Message(
        "verify.crease-too-bent",
        wheel=wheel.radius,
        contact=2.0 * s,
        distance=beside,
        tolerance=permitted,
        length=missed,
        radius=math.ceil((s * s - permitted**2) / (2.0 * permitted)),
        smaller=max(((2.0 * bend + permitted) * permitted / depth + depth) / 2.0, 0.0),
    )
    check.add_finding("beside", at, message, beside, worst, severity=Severity.SHORTFALL)


def _creases_near(creases: Edges, points: F64, distance: float) -> F64:
    """Return the curves of the creases that may be within ``distance`` mm of points, (m, 6)."""
    low, high = points.min(axis=0) - distance, points.max(axis=0) + distance
    curve = creases.curve
    arcs = curve[:, 0] != 0.0
    start, end = creases.ends[0::2], creases.ends[1::2]
    least, most = np.minimum(start, end), np.maximum(start, end)
    # An arc stays within its diameter of its ends.
    margin = np.where(arcs, 2.0 * curve[:, 3], 0.0)[:, None]
    near = ((least - margin <= high) & (most + margin >= low)).all(axis=1)
    result: F64 = curve[near]
    return result


def _unpressed_length(check: StationCheck, edge: int, pressed: F64, permitted: float) -> float:
    """Return the length of a crease that no contact presses within the tolerance (mm).

    ``pressed`` are the lines and arcs along which the wheel presses the board, (m, 6).
    """
    size = float(check.size[edge])
    count = int(np.clip(math.ceil(size / _PITCH), 2, _MOST_POINTS))
    along = (np.arange(count) + 0.5) * size / count
    points = point_at(np.repeat(check.edges.curve[edge : edge + 1], count, axis=0), along)
    bare = distance_from_curves(points, pressed) > permitted
    return float(np.count_nonzero(bare)) * size / count
