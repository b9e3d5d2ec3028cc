"""offset_paths: paths of the centre of a tool of radius r that runs beside contours.

    Paths, radius and side -> Paths of the centre, and the area that the tool cannot reach

First each path is offset by itself: every segment is moved by r, convex corners get their
transition, and at concave corners neighbours are trimmed to their intersection.  This is enough
for most contours.  If a segment is too short, an arc too tight, or a path meets itself or its
neighbours, all moved segments are split where they cross, pieces nearer than r to a contour are
removed, and the rest is connected again: to nothing, one path or several.  Lines stay lines and
arcs stay arcs.

Source: "Tool radius compensation", equations 3 to 5, P_e = P + σ r n with σ = +1 left of travel;
corners from ``transition``.  The global part, in ``region``, is our own.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import ArrayLike

from knifetip.errors import CompensationError, GeometryError, ZeroLengthEdge
from knifetip.geometry.boxes import where_met
from knifetip.geometry.columns import F64, I32, Bool
from knifetip.geometry.path import Paths
from knifetip.offset.batch import on_all_cores
from knifetip.offset.clearance import NEARER as NEARER
from knifetip.offset.raw_segments import FINE, NO_LENGTH, NOT_A_NUMBER, TORN
from knifetip.offset.transition import Corner, check


@dataclass(frozen=True, eq=False, slots=True)
class OffsetPaths:
    """Paths of the tool's centre: n segments in q paths, from p input paths."""

    paths: Paths  #: q result paths, in the direction of their input path
    source: I32  #: (n,) input segment of each; a transition has the segment after its corner
    inserted: Bool  #: (n,) whether it belongs to the transition at a corner
    owner: I32  #: (q,) input path of each result path, that of its first segment
    unreached: F64  #: (p,) mm² beside each input path that the tool cannot reach


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
    """Return the paths of a tool's centre beside paths.

    With n the left normal, σ the side and κ the signed curvature::

        P_e = P + σ r n                     lines are shifted, arcs get the radius R (1 - σ r κ)

    Parameters
    ----------
    paths : Paths
        p contours, closed or open, that do not cross themselves.
    distance : (p,) mm, or one for all
        The radius r; 0 returns the paths unchanged.
    side : (p,) or one for all
        σ: +1 left of travel, -1 right.
    corner, k : (n,) or one for all
        ``Corner`` and knob of the transition at the *start* of each segment, where that is convex.
    interference : "trim" or "refuse"
        Whether what does not fit is left out, or is an error.
    group : (p,), optional
        Paths with the same number bound one region (an outline and its holes): the tool keeps
        clear of all of them.  They need one distance and one side.  Without it each is alone.

    Returns
    -------
    OffsetPaths
        A closed path gives closed paths: none where the tool does not fit at all, several where it
        cannot pass a neck.  No point of a result is nearer to its contours than r, except within
        ``NEARER``.  A result path does not run through the transition of another corner either.

    Raises
    ------
    ZeroLengthEdge
        A segment shorter than ``tolerance.POINT``.
    GeometryError
        Coordinates, radius, side or groups that make no sense.
    CompensationError
        ``interference`` is "refuse", and the tool would cut into a contour; ``source`` are the rows
        of the two segments, the message has the depth.

    Notes
    -----
    ``unreached`` is the area between the contour and what the disc sweeps: the offset curve moved
    back by r, with an arc of radius r about every corner that it turns towards the contour.
    The area of a group stands with its first path.  Of an open path that loses an end it is an
    estimate.

    Cost: n log n in the number of segments; the tree over the boxes of the segments lives on their
    order along the path.  Large batches are done on all cores.
    """
    count, rows = len(paths), len(paths.bulge)
    radius = _column(distance, count, np.float64)
    sides = _column(side, count, np.float64)
    if not (np.isfinite(radius) & (radius >= 0.0)).all():
        raise GeometryError("offset.bad-distance")
    if not (np.abs(sides) == 1.0).all():
        raise GeometryError("offset.bad-side")
    if interference not in ("trim", "refuse"):
        raise GeometryError("offset.bad-interference", interference=interference)
    # A single value for all stays single.
    same = 1 if np.ndim(corner) == 0 and np.ndim(k) == 0 else rows
    kinds = _column(corner, same, np.uint8)
    share = _column(k, same, np.float64)
    check(kinds, share)
    signed = radius * sides
    member, members = _grouped(group, signed)
    start, end, bulge, source, inserted, first, owner, unreached, failure = on_all_cores(
        paths, member, members, signed, kinds, share, interference == "refuse"
    )
    if failure[0] != FINE:
        raise _refusal(failure, radius, paths)
    for column in (start, end, bulge, first):
        column.flags.writeable = False
    return OffsetPaths(Paths(start, end, bulge, first), source, inserted, owner, unreached)


def _column(values: ArrayLike, count: int, dtype: Any) -> Any:
    given = np.asarray(values, dtype)
    return np.ascontiguousarray(np.broadcast_to(given, count))


def _grouped(group: ArrayLike | None, signed: F64) -> tuple[I32, I32]:
    """Return the paths ordered by group, and the start of each group."""
    count = len(signed)
    if group is None:
        return np.arange(count, dtype=np.int32), np.arange(count + 1, dtype=np.int32)
    number = _column(group, count, np.int64)
    member = np.argsort(number, kind="stable").astype(np.int32)
    begins = np.flatnonzero(np.diff(number[member], prepend=number[member[:1]] - 1))
    mixed = np.diff(signed[member]) != 0.0
    mixed[begins[1:] - 1] = False
    if mixed.any():
        path = int(member[np.flatnonzero(mixed)[0] + 1])
        raise GeometryError("offset.mixed-group", path=path, source=[str(path)])
    return member, np.append(begins, count).astype(np.int32)


def _refusal(
    failure: tuple[int, int, int, float], radius: F64, paths: Paths
) -> GeometryError | CompensationError:
    code, row, other, depth = failure
    if code == NO_LENGTH:
        return ZeroLengthEdge([row])
    if code == NOT_A_NUMBER:
        return GeometryError("segment.not-finite", segment=row, source=[str(row)])
    path = int(np.searchsorted(paths.first, row, side="right")) - 1
    if code == TORN:
        one, two, x, y = where_met(
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
                source=[str(one), str(two)],
            )
        return CompensationError(
            "offset.dead-end",
            path=path,
            radius=radius[path],
            depth=depth,
            segment=row,
            source=[str(row)],
        )
    return CompensationError(
        "offset.interference",
        radius=radius[path],
        segment=row,
        depth=depth,
        other=other,
        source=[str(row), str(other)],
    )
