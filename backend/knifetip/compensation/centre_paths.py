"""centre_paths: offset the contours of an operation to paths of the cutter's centre.

The distance is the cutter's radius, or half the kerf of a laser, less the deflection.  A closed
path that the cutter enters round a corner starts behind this corner; all others start in the middle
of a segment (ADR 4).

Source: the paper "Tool radius compensation", eqs 1–5.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

import numpy as np

from knifetip.compensation.contour_starts import SHORTEST_START
from knifetip.compensation.corner import (
    list_places,
    replaced_corner_notes,
    select_corner_types,
    turn_angles,
)
from knifetip.compensation.deflection import shift_centres
from knifetip.compensation.leads import fit_lead_ins
from knifetip.errors import CompensationError, GeometryError
from knifetip.geometry import arc
from knifetip.geometry.azimuth import unit_vectors
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import (
    Paths,
    longest_segments,
    segments_before,
    start_at,
    start_in_middle,
)
from knifetip.geometry.tolerance import BULGE
from knifetip.messages import Message
from knifetip.model.operation import Operation
from knifetip.model.tool import DiscTool
from knifetip.offset.offset_paths import OffsetPaths, offset_paths
from knifetip.offset.self_contact import find_self_contact

#: Radius of the circle on which the cutter's centre runs in a hole that is as wide as the cutter,
#: and greatest difference between the radii of such a hole and of the cutter (mm).
_HOLE_MARGIN: Final = 0.001
#: Largest angle by which a corner may turn less than a lead-in round it (degrees).
_ANGLE_TOLERANCE: Final = 1e-6


@dataclass(frozen=True, eq=False, slots=True)
class CentrePaths:
    """Paths of the cutter's centre: q paths with n segments, from p paths of an operation."""

    paths: Paths  #: q paths
    segment: I32  #: (n,) segment of the operation that each segment belongs to
    unreached: (
        F64  #: (p,) area beside each path of the operation that the cutter cannot reach (mm²)
    )
    approach: F64  #: (q,) angle of the lead-in to each path (degrees), as in ``DiscTool``
    #: what the paths change as planned, such as corner types
    notes: tuple[Message, ...] = ()


def centre_paths(operation: Operation) -> CentrePaths:
    """Return the paths of the cutter's centre for an operation, with the unreachable areas.

    The unreachable areas lie beside the contours, where the cutter does not fit.  Closed centre
    paths keep the cutter out of all other closed paths of the operation.  Each closed centre path
    starts in the middle of a segment: of the one beside the segment with which the operation begins
    the path if the leads have room there, else of its longest line, or of its longest arc if it has
    no line.  For a lead-in round a corner it starts behind a corner instead, if there is one with
    room for the lead-in.  A contour into which the cutter does not fit has no centre path; the
    verifier reports its edges as shortfalls.

    Raises
    ------
    CompensationError
        The operation refuses areas that the cutter cannot reach (``interference`` is "refuse"), and
        there are such areas.  Or the corner type, its parameter k or the deflection is invalid.
    """
    cutter = operation.tool
    assert isinstance(cutter, DiscTool)
    paths = operation.paths
    segment = np.arange(len(paths.bulge), dtype=np.int32)
    unreached = np.zeros(len(paths))
    inserted = np.zeros(len(segment), np.bool_)
    notes: tuple[Message, ...] = ()
    if operation.side != 0:
        paths, segment, inserted, unreached, notes = _offset_contours(operation, cutter)
    if operation.side == 0 or cutter.approach >= 0.0 or len(operation.bridges):
        # Paths with bridges have no leads.
        approach = np.full(len(paths), cutter.approach)
        begin = _starts_in_segments(operation, cutter, paths, segment)
        paths, rows = start_in_middle(paths, paths.closed, begin)
        return CentrePaths(paths, segment[rows], unreached, approach, notes)
    behind = _starts_behind_corners(operation, cutter, paths, segment, inserted)
    # A path beside a part and its hole ends on the hole, so that the hole is the last to be cut.
    on_hole = _beside_holes(operation, segment)
    chosen = operation.fixed[operation.fixed >= 0]
    in_chosen = np.zeros(len(paths), np.bool_)
    in_chosen[paths.path_of[np.isin(segment, chosen)]] = True
    behind[in_chosen] = -1
    found = behind >= 0
    approach = np.where(found | ~paths.closed, cutter.approach, 90.0)
    without = paths.closed & ~found & ~in_chosen
    notes += _replaced_lead_notes(paths.start[paths.first[:-1]][without], cutter)
    paths, turned = start_at(paths, np.where(found, behind, paths.first[:-1]))
    is_chosen = np.isin(segment[turned], chosen)
    longest = longest_segments(
        paths, on_hole[turned], operation.endable[segment[turned]], is_chosen
    )
    paths, rows = start_in_middle(paths, paths.closed & ~found, longest)
    return CentrePaths(paths, segment[turned][rows], unreached, approach, notes)


def _offset_contours(
    operation: Operation, cutter: DiscTool
) -> tuple[Paths, I32, Bool, F64, tuple[Message, ...]]:
    """Return the offset of an operation's contours, with the cutter's deflection compensated.

    A deflection that is equal along X and Y acts like a smaller radius of the cutter, which the
    offset takes into account exactly where the cutter fits and where it does not.  So the mean of
    both deflections is subtracted from the radius, and ``shift_centres`` compensates the rest.  If
    the shifted path crosses itself, as in a neck between the smaller and the larger reach, the
    smaller deflection is subtracted instead of the mean: then the cutter does not enter the neck.

    Returns ``paths`` Paths: centre paths with n segments; ``segment, inserted`` (n,), (n,): segment
    of the operation that each segment belongs to, and whether it belongs to the transition at a
    corner; ``unreached`` (p,) mm²: area beside each path of the operation that the cutter cannot
    reach; notes: what the offset changes as planned.
    Raises ``CompensationError``: a deflection is as large as the cutter's radius, or the contours
    have no offset.
    """
    x, y = operation.deflection
    if max(x, y) > 0.0 and max(x, y) >= cutter.radius:
        raise CompensationError(
            "deflection.exceeds-radius", radius=cutter.radius, deflection=max(x, y)
        )
    kind, k = select_corner_types(operation)
    mean, least = 0.5 * (x + y), min(x, y)
    offset = _offset(operation, cutter.radius - mean, kind, k)
    paths, rows = shift_centres(offset.paths, operation.side, x - mean, y - mean)
    if x != y and _crosses_itself(paths):
        other = _offset(operation, cutter.radius - least, kind, k)
        moved, kept = shift_centres(other.paths, operation.side, x - least, y - least)
        if not _crosses_itself(moved):
            offset, paths, rows = other, moved, kept
    notes = replaced_corner_notes(operation, kind, offset.replaced)
    return paths, offset.source[rows], offset.inserted[rows], offset.unreached, notes


def _offset(operation: Operation, distance: float, kind: U8, k: F64) -> OffsetPaths:
    """Return the contours of an operation, offset by a distance in mm.

    ``kind`` and ``k`` are the corner type at the start of each segment and its parameter.

    Raises ``CompensationError``: the contours have no offset; the message has the edges.
    """
    paths = operation.paths
    # Open paths are offset one by one: the side beyond their ends is undefined.
    group = np.where(paths.closed, 0, 1 + np.arange(len(paths)))
    try:
        return offset_paths(
            _widen_round_holes(paths, distance, operation.side), distance, operation.side,
            corner=kind, k=k, interference=operation.interference, group=group,
        )  # fmt: skip
    except (CompensationError, GeometryError) as reason:
        raise _offset_error(reason, operation) from None


#: Codes of errors about the offset of a contour at two of its segments, for errors about a cutter
#: at two edges.
_CUTTER_ERRORS: Final[Mapping[str, str]] = {
    "offset.interference": "cutter.interference",
    "offset.self-contact": "cutter.contour-touches-itself",
    "offset.cusp": "cutter.corner-loop",
}


def _offset_error(
    reason: CompensationError | GeometryError, operation: Operation
) -> CompensationError:
    """Return the error that the contours of an operation have no offset, with their edges."""
    edges = operation.source[list(reason.edges)].tolist()
    message = reason.message
    if (code := _CUTTER_ERRORS.get(message.code)) is not None:
        assert isinstance(operation.tool, DiscTool)
        known = message.arguments
        measures = {name: known[name] for name in ("depth", "size", "x", "y") if name in known}
        message = Message(
            code, diameter=2.0 * operation.tool.radius, edge=edges[0], other=edges[1], **measures
        )
    elif edges:
        message = Message("error.at-edges", edges=edges, error=message)
    else:
        message = message.located(lambda row: int(operation.source[row]))
    return CompensationError(message, at_edges=edges)


def _widen_round_holes(paths: Paths, distance: float, side: int) -> Paths:
    """Return contours in which round holes as wide as the cutter are a little wider.

    In such a hole the cutter only plunges, and the digits of the drawing decide whether the offset
    is a point, nothing, or too small to be printed.  The radius becomes ``distance`` plus
    ``_HOLE_MARGIN``, which gives the smallest circle that a program prints.

    ``paths``: contours; those of holes have the cutter on their inner side.
    ``distance`` mm: distance of the cutter's centre from the contours.
    ``side``: side of the cutter: +1 left, -1 right.
    """
    bent = np.abs(paths.bulge) > BULGE
    rows = np.flatnonzero(bent)
    if len(rows) == 0:
        return paths
    centre = np.zeros((len(bent), 2))
    centre[rows] = arc.centre(paths.start[rows], paths.end[rows], paths.bulge[rows])
    middle = centre[paths.first[:-1]][paths.path_of]
    radius = np.hypot(*(paths.start - middle).T)
    is_round = bent & (np.hypot(*(centre - middle).T) <= _HOLE_MARGIN)
    is_round &= np.abs(radius - distance) < _HOLE_MARGIN
    whole = np.bincount(paths.path_of, ~is_round, len(paths)) == 0.0
    widened = (whole & paths.closed & (side * paths.areas > 0.0))[paths.path_of]
    factor = np.where(widened, (distance + _HOLE_MARGIN) / np.maximum(radius, _HOLE_MARGIN), 1.0)
    return replace(
        paths,
        start=np.where(
            widened[:, None], middle + (paths.start - middle) * factor[:, None], paths.start
        ),
        end=np.where(widened[:, None], middle + (paths.end - middle) * factor[:, None], paths.end),
    )


def _crosses_itself(paths: Paths) -> bool:
    """Return whether any of the paths touches or crosses itself, except between neighbours."""
    bounds = pairwise(paths.first.tolist())
    segments = paths.start, paths.end, paths.bulge
    return any(find_self_contact(*segments, low, high)[0] >= 0 for low, high in bounds)


def _starts_in_segments(operation: Operation, cutter: DiscTool, paths: Paths, segment: I32) -> I32:
    """Return for each closed centre path the segment in whose middle it should start, (q,).

    It is the longest one beside the segment with which the operation begins the path.  If there is
    none of at least ``SHORTEST_START``, or the leads must be shorter there, it is the longest
    segment of the centre path in which the operation may end.  A path beside a part and its hole
    starts on the hole.  For an open path the result has no meaning.

    ``paths``: centre paths, q in number, with n segments.
    ``segment`` (n,): segment of the operation that each segment belongs to.
    """
    owner, on_hole = paths.path_of, _beside_holes(operation, segment)
    endable = operation.endable[segment]
    longest = longest_segments(paths, on_hole, endable)
    stated = np.isin(segment, np.concatenate([operation.begin, operation.fixed]))
    stated &= paths.closed[owner]
    stated &= on_hole == on_hole[longest][owner]
    stated &= endable == endable[longest][owner]
    rows: I32 = np.flatnonzero(stated).astype(np.int32)
    size = arc.length(paths.start[rows], paths.end[rows], paths.bulge[rows])
    # Where the cutter hardly reaches a segment, a lead would run along the one before or after it.
    wide = (size >= SHORTEST_START) | np.isin(segment[rows], operation.fixed)
    rows, size = rows[wide], size[wide]
    rows = rows[np.lexsort((rows, -size, owner[rows]))]
    rows = rows[np.diff(owner[rows], prepend=-1) > 0]
    if operation.side != 0:
        length = [
            _lead_lengths(operation, cutter, paths, some) for some in (rows, longest[owner[rows]])
        ]
        fits = (length[0] >= length[1]).all(axis=1)
        rows = rows[fits | np.isin(segment[rows], operation.fixed)]
    longest[owner[rows]] = rows
    return longest


def _lead_lengths(operation: Operation, cutter: DiscTool, paths: Paths, rows: I32) -> F64:
    """Return the lengths of the lead-in and the lead-out in the middle of each of k segments of
    centre paths, as fractions of the full lengths, (k, 2).
    """
    ends = paths.start[rows], paths.end[rows], paths.bulge[rows]
    half = np.full(len(rows), 0.5)
    middle = arc.point_at(*ends, half)
    ahead, approach = unit_vectors(arc.tangent_at(*ends, half)), np.full(len(rows), cutter.approach)
    leads = (
        fit_lead_ins(operation, cutter, middle, ahead, operation.side, approach),
        fit_lead_ins(operation, cutter, middle, -ahead, -operation.side, approach),
    )
    return np.column_stack([lead.fraction for lead in leads])


def _starts_behind_corners(
    operation: Operation, cutter: DiscTool, paths: Paths, segment: I32, inserted: Bool
) -> I32:
    """Return for each closed centre path the segment at which it should start, (q,); -1 for none.

    The cutter has a lead-in round a corner (type B).  On it the cutter turns by the angle of the
    lead-in, so the contour must turn away from the cutter by at least this angle.  Of the corners
    with room for the lead-in, the one at which the operation begins the path is returned, or else
    the one with the largest turn; if the lead-in must be halved everywhere, one with room for the
    half.  A path beside a part and its hole starts on the hole.

    ``paths``: centre paths, q in number, with n segments.
    ``segment`` (n,): segment of the operation that each segment belongs to.
    ``inserted`` (n,): whether each segment belongs to the transition at a corner.
    """
    turn = np.degrees(turn_angles(operation.paths, operation.side))[segment]
    before = np.arange(-1, len(segment) - 1)
    before[paths.first[:-1]] = paths.first[1:] - 1
    suited = paths.closed[paths.path_of] & ~inserted & inserted[before]
    on_hole = _beside_holes(operation, segment)
    suited &= on_hole | (np.bincount(paths.path_of, on_hole, len(paths)) == 0.0)[paths.path_of]
    suited &= operation.endable[segments_before(operation.paths)[segment]]
    suited &= (segment[before] == segment) & (turn >= -cutter.approach - _ANGLE_TOLERANCE)
    rows = np.flatnonzero(suited).astype(np.int32)
    ahead, _ = arc.tangents(paths.start[rows], paths.end[rows], paths.bulge[rows])
    lead = fit_lead_ins(
        operation, cutter, paths.start[rows], unit_vectors(ahead), operation.side,
        np.full(len(rows), cutter.approach),
    )  # fmt: skip
    owner = paths.path_of[rows]
    other = ~np.isin(segment[rows], operation.begin)
    best = np.lexsort((rows, -turn[rows], other, -lead.fraction, owner))
    best = best[np.diff(owner[best], prepend=-1) > 0]
    best = best[lead.fraction[best] > 0.0]
    result: I32 = np.full(len(paths), -1, np.int32)
    result[owner[best]] = rows[best]
    return result


def _beside_holes(operation: Operation, segment: I32) -> Bool:
    """Return whether each of some segments of an operation belongs to a hole, (n,).

    ``segment`` (n,) are the indices of the segments.
    """
    paths = operation.paths
    is_hole: Bool = operation.side * paths.areas > 0.0
    return is_hole[paths.path_of[segment]]


def _replaced_lead_notes(position: F64, cutter: DiscTool) -> tuple[Message, ...]:
    """Return a message about contours that the cutter cannot enter round a corner, if any.

    ``position`` (m, 2) is a point of each of these contours (mm).
    """
    if len(position) == 0:
        return ()
    return (
        Message(
            "lead.no-corner",
            count=len(position),
            angle=-cutter.approach,
            places=list_places(position),
        ),
    )
