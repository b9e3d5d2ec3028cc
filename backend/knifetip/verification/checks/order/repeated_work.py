"""Find tip paths of a program along which an earlier program for the same sheet already worked.

A tool that follows an edge again widens a cut, deepens a crease or tears a cut part.  A track that
merely crosses or touches earlier work, as the overrun of a knife or the lead of a cutter does, is
permitted.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.common.context import DEPTH_TOLERANCE, CheckContext
from knifetip.verification.columns import F64, I64
from knifetip.verification.curves.curve import point_at
from knifetip.verification.curves.intervals import uncovered_curves
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.findings import MAX_FINDINGS
from knifetip.verification.joined_work import JoinedWork

#: Greatest fraction of a track that may lie on earlier work.
_PERMITTED_FRACTION: Final = 0.5


def check_repeated_work(context: CheckContext, work: JoinedWork) -> None:
    """Add a finding for each track of a program that earlier programs have already made.

    A track is a chain of tip paths between two lifts.  Work counts as repeated if the same station
    follows the same line at the same depth.
    """
    count, paths = work.earlier_count, work.paths
    rows = np.arange(count, len(paths.z))
    if count == 0 or len(rows) == 0:
        return
    repeated = np.zeros(len(rows))
    for station in np.unique(paths.station[rows]):
        own = np.flatnonzero(paths.station[rows] == station)
        before = np.flatnonzero(paths.station[:count] == station)
        repeated[own] = _repeated_lengths(context, work, rows[own], before)
    # A pressed crease has no length; count it with a small one.
    size = np.maximum(paths.curve[rows, 5], 1e-6)
    track, place = np.unique(paths.track[rows], return_inverse=True)
    total = np.bincount(place, size, minlength=len(track))
    again = np.bincount(place, np.minimum(repeated, size), minlength=len(track))
    for number in np.flatnonzero(again > _PERMITTED_FRACTION * total)[:MAX_FINDINGS]:
        row = rows[np.flatnonzero((place == number) & (repeated > 0.0))[0]]
        x, y = point_at(paths.curve[row : row + 1], np.zeros(1))[0]
        message = Message(
            "verify.made-before",
            station=context.machine.stations[int(paths.station[row])].number,
            length=again[number],
            x=x,
            y=y,
        )
        context.findings.add("stray", message, float(again[number]), line=int(paths.line[row]))


def _repeated_lengths(context: CheckContext, work: JoinedWork, rows: I64, before: I64) -> F64:
    """Return the length of each of n tip paths that earlier paths already made, (n,) mm.

    A path without length that is made again counts as 1e-6 mm.

    ``rows``, ``before``: indices of the n tip paths, and of the earlier paths of the same station.
    """
    curve, z = work.paths.curve[rows], work.paths.z
    made = work.paths.curve[before]
    near = find_overlaps(curve, made, np.zeros(len(made)), made[:, 5], context.tolerance)
    size = np.diff(near.along)[:, 0]
    along = np.abs(np.diff(near.place)[:, 0]) >= 0.5 * size
    same_depth = np.abs(z[rows[near.curve]] - z[before[near.edge]]) <= DEPTH_TOLERANCE
    near = near.select(along & same_depth)
    rest, spans = uncovered_curves(near, curve)
    fresh = np.bincount(rest, spans[:, 1] - spans[:, 0], minlength=len(curve))
    length = curve[:, 5] - fresh
    point = curve[:, 5] < 1e-6
    length[point] = 1e-6
    length[rest[point[rest]]] = 0.0
    return length
