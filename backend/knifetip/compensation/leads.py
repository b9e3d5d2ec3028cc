"""leads: lead-ins and lead-outs of a cutter, on which it moves between the waste and its path.

The offset is set up and cancelled as controllers do: on a straight line to the start of the offset
path (type A), or on a line and an arc around the start of the contour (type B).  A lead on which
the cutter would enter a contour is halved, or left out.

Source: the paper "Tool radius compensation", eqs 1–5.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np
from numpy.typing import ArrayLike

from knifetip.geometry import arc
from knifetip.geometry.azimuth import left_normal
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.points_on_segments import find_points_on_segments
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool

#: Number of points on a lead at which the distance to contours is checked.
_LEAD_CHECKS: Final = 8
#: Fractions of the full lead, tried from the longest.
_LEAD_FRACTIONS: Final = (1.0, 0.5, 0.0)
#: Largest distance by which a lead-in round a corner may come nearer to a contour than r (mm).
_CLEARANCE_ERROR: Final = 0.0005


@dataclass(frozen=True, eq=False, slots=True)
class LeadIns:
    """The lead-ins to m centre paths: a straight move, and for type B an arc."""

    begin: F64  #: (m, 2) mm, start of the straight move; ``arrived`` if its length is 0
    arrived: F64  #: (m, 2) mm, end of the straight move
    bulge: F64  #: (m,) bulge of the arc from ``arrived`` to the start of the path; 0 for no arc
    fraction: F64  #: (m,) length of the straight move, as a fraction of the full lead-in


def set_up_offset(
    start: F64, ahead: F64, side: int, radius: float, lead: float, approach: ArrayLike
) -> tuple[F64, F64, F64]:
    """Return the moves that set up the offset on a straight lead-in before each of m contours.

    The centre of the cutter must arrive at the start S of the offset path.  S is the start of the
    contour, moved by the cutter's radius r to the tool's side, perpendicular to the contour.
    Type A: if the path turns from the lead-in towards the tool's side or not at all, the centre
    moves straight to S.  Type B: if the path turns away from the tool's side, the centre moves
    parallel to the lead-in, at the distance r from it, and then to S on an arc around the start of
    the contour.  To cancel the offset, set it up for the reversed contour and reverse the result.

    Parameters
    ----------
    start : (m, 2) mm
        Start points of the contours, where the lead-ins end.
    ahead : (m, 2)
        Unit tangents of the contours at these points.
    side
        σ, +1 if the cutter is left of travel, −1 if right.
    radius : mm
        Radius of the cutter.
    lead : mm
        Length of the lead-in.
    approach : (m,) degrees, or one for all
        Angle between lead-in and contour: 90 for a lead-in from the tool's side, 0 in line with the
        contour, −90 from the other side.

    Returns
    -------
    from, to : (m, 2) mm
        Position of the centre at the start and at the end of the straight move.
    bulge : (m,)
        Bulge of the arc from ``to`` to S; 0 for type A, in which ``to`` is S.
    """
    angle = np.radians(np.broadcast_to(np.asarray(approach, np.float64), len(start)))
    goes_round = angle < 0.0
    normal = side * left_normal(ahead)
    direction = np.cos(angle)[:, None] * ahead - np.sin(angle)[:, None] * normal
    begin = start - lead * direction
    # In type B a straight move to the perpendicular would cut the corner, so the lead-in is already
    # at distance r.
    beside = np.where(goes_round[:, None], radius * side * left_normal(direction), 0.0)
    arrived = start + np.where(goes_round[:, None], beside, radius * normal)
    bulge = np.where(goes_round, -side * np.tan(-angle / 4.0), 0.0)
    return begin + beside, arrived, bulge


def fit_lead_ins(
    operation: Operation, cutter: DiscTool, start: F64, ahead: F64, side: int, approach: F64
) -> LeadIns:
    """Return lead-ins to centre paths, shortened near other contours.

    If the disc would enter a contour along a lead-in, the lead-in is halved.  If the disc would
    still enter a contour, the length of the lead-in becomes 0; then the tool plunges at the start
    of the centre path, where the tool touches the contour.

    Parameters
    ----------
    start : (m, 2) mm
        Start points of the centre paths.
    ahead : (m, 2)
        Unit tangents of the centre paths at their starts.
    side
        +1 if the cutter is left of travel, −1 if right.
    approach : (m,) degrees
        Angles between the lead-ins and the centre paths.
    """
    r = cutter.radius
    own, others = operation.paths, operation.obstacles
    contours = (
        np.concatenate([own.start, others.start]),
        np.concatenate([own.end, others.end]),
        np.concatenate([own.bulge, others.bulge]),
    )
    on_line = start - side * r * left_normal(ahead)
    begin, arrived, bulge = set_up_offset(on_line, ahead, side, r, cutter.lead_in, approach)
    goes_round = bulge != 0.0
    arrived = np.where(goes_round[:, None], arrived, start)
    away = begin - arrived
    # Between two checked points a contour may be nearer by the sagitta of the step.
    step = float(np.hypot(*away.T).max(initial=0.0)) / _LEAD_CHECKS
    near = float(np.hypot(r, step / 2.0))
    fraction = np.full(len(start), _LEAD_FRACTIONS[-1])
    direct, curved = np.flatnonzero(~goes_round), np.flatnonzero(goes_round)
    # A lead-in round a corner may run along the contour at the distance r, so it is checked at many
    # points instead.
    fine = int(np.ceil(cutter.lead_in / np.sqrt(8.0 * r * _CLEARANCE_ERROR))) if len(curved) else 0
    for tried in reversed(_LEAD_FRACTIONS[:-1]):
        checks = np.arange(1, _LEAD_CHECKS + 1) / _LEAD_CHECKS * tried
        clear = _is_clear(contours, arrived[direct], away[direct], checks, near)
        fraction[direct] = np.where(clear, tried, fraction[direct])
        checks = np.linspace(0.0, tried, fine + 1)
        clear = _is_clear(contours, arrived[curved], away[curved], checks, r - _CLEARANCE_ERROR)
        fraction[curved] = np.where(clear, tried, fraction[curved])
    round_corner = arc.points_along(arrived[curved], start[curved], bulge[curved], _LEAD_CHECKS)
    hit = find_points_on_segments(
        round_corner.reshape(-1, 2),
        np.full(round_corner.size // 2, -1, np.int32),
        *contours,
        r - _CLEARANCE_ERROR,
    )
    blocked = curved[hit.reshape(-1, _LEAD_CHECKS).any(axis=1)]
    fraction[blocked], bulge[blocked], arrived[blocked] = 0.0, 0.0, start[blocked]
    return LeadIns(arrived + fraction[:, None] * away, arrived, bulge, fraction)


def _is_clear(
    contours: tuple[F64, F64, F64], origin: F64, away: F64, checks: F64, near: float
) -> Bool:
    """Return whether all checked points of straight moves keep away from contours, (m,).

    ``contours``: starts (n, 2), ends (n, 2) and bulges (n,) of the segments of all contours.
    ``origin``, ``away`` (m, 2) mm: one end of each move, and the vector from there to the other
    end.
    ``checks`` (c,): positions of the checked points on each move, as fractions of ``away``.
    ``near`` mm: distance from the contours that each point must keep.
    """
    points = (origin[:, None] + checks[None, :, None] * away[:, None]).reshape(-1, 2)
    hit = find_points_on_segments(
        points,
        np.full(len(points), -1, np.int32),
        *contours,
        near,
    )
    clear: Bool = np.logical_not(hit.reshape(-1, len(checks)).any(axis=1))
    return clear
