"""offset_paths: the public function of the offset engine."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any, Final, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import CompensationError, GeometryError, ZeroLengthEdge
from knifetip.geometry.columns import F64, I32, U8, Bool
from knifetip.geometry.path import Paths
from knifetip.offset.batch import offset_on_all_cores
from knifetip.offset.cusps import find_cusp_loops, straighten_cusps
from knifetip.offset.raw_segments import NO_FAILURE, NO_LENGTH, NOT_A_NUMBER, NOT_CLOSED
from knifetip.offset.self_contact import find_self_contact
from knifetip.offset.transition import Corner, check_corners

#: If no offset is found, the radius is reduced by this (mm).  In a slot as wide as the tool, both
#: sides have the same offset, and rounding decides whether it has two paths, one or none.
_RADIUS_STEP: Final = 1e-5


@dataclass(frozen=True, eq=False, slots=True)
class OffsetPaths:
    """Paths of the tool's centre: q paths with n segments, offset from p input paths."""

    paths: Paths  #: the q offset paths, each in the direction of its input path
    source: I32  #: (n,) input segment of each segment; in a transition, the one after the corner
    inserted: Bool  #: (n,) whether each segment belongs to the transition at a corner
    owner: I32  #: (q,) input path of each offset path, taken from its first segment
    unreached: F64  #: (p,) mm² beside each input path that the tool cannot reach
    #: (m,) input segments with a transition of type B at their starts instead of type C or D
    replaced: I32


def offset_paths(
    paths: Paths,
    distance: ArrayLike,
    side: ArrayLike,
    *,
    corner: ArrayLike = Corner.B,
    k: ArrayLike = 0.5,
    interference: str = "trim",
    group: ArrayLike | None = None,
) -> OffsetPaths:
    """Return the paths of a tool's centre at a distance from contours.

    The point P of a contour is moved by the radius r of the tool to the side σ along the left
    normal n::

        P_e = P + σ r n

    Lines are shifted; an arc with the radius R and the signed curvature κ gets the radius R (1 - σ
    r κ).

    Parameters
    ----------
    paths : Paths
        p contours, closed or open, that do not cross themselves.  Thin loops at cusps are removed
        if no offset is found with them (see ``cusps``).
    distance : (p,) mm, or one for all
        The radius r; 0 returns the paths unchanged.
    side : (p,) or one for all
        σ: +1 left of travel, -1 right.
    corner, k : (n,) or one for all
        ``Corner`` at the *start* of each segment and, for type D, its parameter k; they are used if
        the corner is convex for the tool.  Type B replaces type C or D at a corner where the tool's
        path round the corner would meet another part of the offset or come nearer to a contour
        than r.
    interference : "trim" or "refuse"
        Whether parts where the tool does not fit are left out, or raise an error.
    group : (p,), optional
        Paths with the same number bound one region (an outline and its holes): the tool keeps clear
        of all of them.  They need one distance and one side.  By default each path is a group.

    Returns
    -------
    OffsetPaths
        A closed path gives closed paths: none if the tool does not fit, several if it cannot pass a
        neck.  No point of a result is nearer to its contours than r, except within
        ``DISTANCE_TOLERANCE``, or within ``_RADIUS_STEP`` if no offset is found with r.  No result
        path runs between a corner and the path on which the tool goes round this corner.  A path of
        type C or D round a corner is never cut short.

    Raises
    ------
    ZeroLengthEdge
        A segment is shorter than ``tolerance.POINT``.
    GeometryError
        Coordinates, radius, side or groups are invalid.
    CompensationError
        ``interference`` is "refuse", and the tool would cut into a contour; ``source`` has the rows
        of the two segments, the message has the depth.

    Notes
    -----
    ``OffsetPaths.unreached`` is the area between the contour and the area that the disc sweeps.
    The boundary of the swept area is the offset curve moved back by r.  At every corner where the
    offset curve turns towards the contour, this boundary has an arc of radius r.  The area of a
    group is stored with its first path.  If the tool does not fit at the start or end of an open
    path, the area is an estimate.

    Cost: n log n in the number of segments; the tree of boxes over the segments uses their order
    along the path.  Large batches are processed on all cores.
    """
    count, rows = len(paths), len(paths.bulge)
    radius = _broadcast(distance, count, np.float64)
    sides = _broadcast(side, count, np.float64)
    if not (np.isfinite(radius) & (radius >= 0.0)).all():
        raise GeometryError("offset.bad-distance")
    if not (np.abs(sides) == 1.0).all():
        raise GeometryError("offset.bad-side")
    if interference not in ("trim", "refuse"):
        raise GeometryError("offset.bad-interference", interference=interference)
    # Type B for all corners remains a single value: only types C and D change at single corners.
    same = 1 if np.ndim(k) == 0 and np.ndim(corner) == 0 and corner == Corner.B else rows
    kinds = _broadcast(corner, same, np.uint8)
    k_values = _broadcast(k, same, np.float64)
    check_corners(kinds, k_values)
    signed = radius * sides
    regions = _Regions(*_order_by_group(group, signed), signed, interference == "refuse")
    result, failure = _offset(paths, regions, kinds, k_values)
    if failure[0] == NOT_CLOSED:
        straight, segment = straighten_cusps(paths)
        corner_row = segment if same > 1 else slice(None)
        types = kinds[corner_row], k_values[corner_row]
        result, _ = _offset(straight, regions, *types)
        if result is None:
            less = np.sign(signed) * np.maximum(radius - _RADIUS_STEP, 0.0)
            result, _ = _offset(straight, regions._replace(signed=less), *types)
        if result is not None:
            result = replace(
                result, source=segment[result.source], replaced=np.unique(segment[result.replaced])
            )
    if result is None:
        raise _failure_error(failure, radius, paths)
    return result


class _Regions(NamedTuple):
    """The regions to be offset: groups of p paths, as for ``offset_on_all_cores``."""

    member: I32  #: (p,) path numbers in the order of their groups
    first: I32  #: (g + 1,) position in ``member`` at which each group begins; the last entry is p
    signed: F64  #: (p,) mm, radius of the tool for each path, positive if it is left of travel
    refuse: bool  #: whether a position where the tool does not fit is a failure


def _offset(
    paths: Paths, regions: _Regions, requested: U8, k: F64
) -> tuple[OffsetPaths | None, tuple[int, int, int, float]]:
    """Return the offset of n segments, None if it failed, and the failure.

    ``requested``, ``k`` (n,) each, or (1,) each for type B at all corners: types of the
    transitions, and the parameter k of type D.
    Returns offset: the offset, or None; failure: failure code, the two contour segments concerned,
    and the depth by which the tool would cut into the contour (mm).
    """
    kinds = requested.copy()
    start, end, bulge, source, inserted, first, owner, unreached, failure = offset_on_all_cores(
        paths, regions.member, regions.first, regions.signed, kinds, k, regions.refuse
    )
    if failure[0] != NO_FAILURE:
        return None, failure
    for column in (start, end, bulge, first):
        column.flags.writeable = False
    # A corner that the tool does not reach has no transition of any type.
    changed = np.flatnonzero(kinds != requested).astype(np.int32)
    replaced = np.intersect1d(changed, source[inserted]) if len(changed) else changed
    columns = source, inserted, owner, unreached, replaced
    return OffsetPaths(Paths(start, end, bulge, first), *columns), failure


def _broadcast(values: ArrayLike, count: int, dtype: Any) -> Any:
    """Return values as a contiguous array with the shape (count,) and the type ``dtype``.

    A single value is repeated ``count`` times.
    """
    array = np.asarray(values, dtype)
    return np.ascontiguousarray(np.broadcast_to(array, count))


def _order_by_group(group: ArrayLike | None, signed: F64) -> tuple[I32, I32]:
    """Order the paths by group.

    ``group`` (p,): number of the group of each path, or None if each path is a group.
    ``signed`` (p,) mm: signed radius for each path.
    Returns ``member`` (p,): path numbers in the order of their groups; ``group_first`` (g + 1,):
    position in ``member`` at which each group begins; the last entry is p.
    Raises ``GeometryError``: the paths of a group have different radii or sides.
    """
    count = len(signed)
    if group is None:
        return np.arange(count, dtype=np.int32), np.arange(count + 1, dtype=np.int32)
    number = _broadcast(group, count, np.int64)
    member = np.argsort(number, kind="stable").astype(np.int32)
    begins = np.flatnonzero(np.diff(number[member], prepend=number[member[:1]] - 1))
    mixed = np.diff(signed[member]) != 0.0
    mixed[begins[1:] - 1] = False
    if mixed.any():
        path = int(member[np.flatnonzero(mixed)[0] + 1])
        raise GeometryError("offset.mixed-group", path=path)
    return member, np.append(begins, count).astype(np.int32)


def _failure_error(
    failure: tuple[int, int, int, float], radius: F64, paths: Paths
) -> GeometryError | CompensationError:
    """Return the exception for a failure of the offset kernels.

    ``failure``: failure code, the two contour segments concerned, and the depth by which the tool
    would cut into the contour (mm).  The code is a constant of ``raw_segments`` other than
    ``NO_FAILURE``.
    ``radius`` (p,) mm: radius of the tool for each path.
    """
    code, row, other, depth = failure
    if code == NO_LENGTH:
        return ZeroLengthEdge([row])
    if code == NOT_A_NUMBER:
        return GeometryError("segment.not-finite", segment=row, at_edges=[row])
    path = int(np.searchsorted(paths.first, row, side="right")) - 1
    if code == NOT_CLOSED:
        one, two, x, y = find_self_contact(
            paths.start, paths.end, paths.bulge, paths.first[path], paths.first[path + 1]
        )
        if one >= 0:
            return CompensationError(
                "offset.self-contact",
                path=path,
                radius=radius[path],
                x=x,
                y=y,
                one=one,
                two=two,
                at_edges=(one, two),
            )
        loops = find_cusp_loops(paths)
        of_path = np.flatnonzero(paths.path_of[loops.before] == path)
        if len(of_path):
            worst = of_path[loops.size[of_path].argmax()]
            one, two = int(loops.before[worst]), int(loops.after[worst])
            return CompensationError(
                "offset.cusp",
                path=path,
                radius=radius[path],
                size=loops.size[worst],
                x=paths.end[one, 0],
                y=paths.end[one, 1],
                one=one,
                two=two,
                at_edges=(one, two),
            )
        return CompensationError(
            "offset.dead-end",
            path=path,
            radius=radius[path],
            depth=depth,
            segment=row,
            at_edges=[row],
        )
    return CompensationError(
        "offset.interference",
        radius=radius[path],
        segment=row,
        depth=depth,
        other=other,
        at_edges=(row, other),
    )
