"""records: named tuples of the arrays that the kernels of the offset engine pass to each other."""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    Bool_1,
    Bool_2,
    OutBool_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    OutI64_1,
    OutI64_2,
    OutU8_1,
    kernel,
)


class Contours(NamedTuple):
    """Input of the offset engine: p paths with n segments in total, stored in columns."""

    start: F64_2  #: (n, 2) mm
    end: F64_2  #: (n, 2) mm
    bulge: F64_1  #: (n,) tan(sweep / 4)
    first: I32_1  #: (p + 1,) first segment of each path, and n


class Segment(NamedTuple):
    """A line or an arc of any path."""

    x0: float  #: x of its start (mm)
    y0: float  #: y of its start (mm)
    x1: float  #: x of its end (mm)
    y1: float  #: y of its end (mm)
    bulge: float  #: tan(sweep / 4)


class CornerTypes(NamedTuple):
    """For each contour segment, the type of the transition at its start.

    A transition is the tool's path round a corner; the type is used only if the corner is convex.
    ``region`` changes type C or D to B at a corner whose transition meets another part of the
    offset or comes nearer to a contour than the tool's radius.
    """

    kind: OutU8_1  #: (n,), or (1,) if all corners are of type B: ``transition.Corner``
    k: F64_1  #: (n,) or (1,) parameter k of type D: 0 as B, 1 as C
    step: int  #: 1, or 0 if all corners are of type B


class MovedSegments(NamedTuple):
    """Contour segments that are moved sideways by the tool's radius and not yet connected."""

    table: OutF64_2  #: (n, ``raw_segments.COLUMNS``) moved ends, tangents and radii
    joint: OutI64_1  #: (n,) kind of joint at each start, such as ``raw_segments.CONVEX``


class MovedCorner(NamedTuple):
    """A corner of a contour, and where the segments at it are in the table of moved segments."""

    segment: int  #: contour segment after the corner
    row_before: int  #: row of the moved segment before the corner
    row_after: int  #: row of the moved segment after the corner
    signed: float  #: radius of the tool (mm), positive left of travel


class MovedPath(NamedTuple):
    """One input path, and where its segments are in the table of moved segments."""

    low: int  #: first contour segment of the path
    high: int  #: contour segment after the last one of the path
    closed: bool  #: whether the path is closed
    signed: float  #: radius of the tool (mm), positive left of travel
    segments: MovedSegments  #: the moved segments
    first_row: int  #: row of the path's first segment in ``segments``


class OffsetSegments(NamedTuple):
    """Output columns for the segments of all offset paths, with capacity for m segments."""

    start: OutF64_2  #: (m, 2) mm
    end: OutF64_2  #: (m, 2) mm
    bulge: OutF64_1  #: (m,)
    source: OutI32_1  #: (m,) contour segment that each segment comes from
    inserted: OutBool_1  #: (m,) whether the segment belongs to a transition


@kernel
def empty_segments(capacity: int) -> OffsetSegments:
    """Return output columns with capacity for ``capacity`` segments; the values are arbitrary."""
    return OffsetSegments(
        np.empty((capacity, 2)),
        np.empty((capacity, 2)),
        np.empty(capacity),
        np.empty(capacity, np.int32),
        np.empty(capacity, np.bool_),
    )


class RawRows(NamedTuple):
    """Table of m moved segments of a region, which are later split at their intersections."""

    rows: OutF64_2  #: (m, 5) x0, y0, x1, y1, bulge
    #: (m, 4) contour segment, whether inserted, whether the next row continues the row, path
    info: OutI64_2
    follow: OutI64_1  #: (m,) row that continues each row, -1 for none


class RegionPaths(NamedTuple):
    """The c paths that bound one region, in an order in which near paths are adjacent."""

    member: I32_1  #: (c,) number of each path in the input
    begin: I64_1  #: (c + 1,) first segment of each path in the region
    closed: Bool_1  #: (c,) whether each path is closed


class RegionCorners(NamedTuple):
    """The corners of one region, each at the start of one of its n contour segments."""

    origin: OutF64_2  #: (n, 5) x0, y0, x1, y1 and bulge of each contour segment
    source: OutI64_1  #: (n,) index of each contour segment in the input
    segments: MovedSegments  #: the moved segments
    previous: OutI64_1  #: (n,) segment before each segment
    kind: OutI64_1  #: (n,) ``transition.Corner``
    k: OutF64_1  #: (n,) parameter k of type D
    capped: bool  #: whether any corner is of type C or D


class JoinedPieces(NamedTuple):
    """The q pieces into which m rows are split, with predecessor and successor of each piece."""

    piece: F64_2  #: (≥ q, 6) x0, y0, x1, y1, and parameters of both ends on the row
    owner: I64_1  #: (≥ q,) row that each piece is part of
    opening: I64_1  #: (m,) first piece of each row
    touched: Bool_2  #: (m, 2) whether each row is split exactly at its start and at its end
    good: OutBool_1  #: (q,) whether each piece is valid: not nearer to a contour than the radius
    successor: OutI64_1  #: (q,) piece that continues each piece, -1 for none
    predecessor: OutI64_1  #: (q,) piece that each piece continues, -1 for none


class ResultChains(NamedTuple):
    """Columns for the offset of a region: up to r segments, connected into chains."""

    line: OutF64_2  #: (r, 5) x0, y0, x1, y1, bulge
    tag: OutI64_2  #: (r, 4) contour segment, whether inserted, path, raw row
    bounds: OutI64_1  #: first row of each chain, and the number of rows
    closed: OutBool_1  #: whether each chain is closed


class OffsetGroups(NamedTuple):
    """The p input paths ordered by group, and the signed radius of the tool for each path."""

    member: I32_1  #: (p,) path numbers in the order of their groups
    bounds: I32_1  #: (g + 1,) position in ``member`` at which each group begins
    signed: F64_1  #: (p,) radius of the tool (mm), positive left of travel


class OffsetChains(NamedTuple):
    """Output columns with capacity for c chains of offset segments, one chain per offset path.

    Also contains the areas beside p input paths that the tool cannot reach.
    """

    first: OutI32_1  #: (c,) first row of each chain
    owner: OutI32_1  #: (c,) input path of each chain
    unreached: OutF64_1  #: (p,) area beside each path that the tool cannot reach (mm²)


class OffsetProgress(NamedTuple):
    """How many groups are offset, and how many rows of the output columns are written."""

    group: int  #: first group that is not offset; the number of groups if all are
    segment_count: int  #: number of segments in ``OffsetSegments``
    chain_count: int  #: number of chains in ``OffsetChains``


class RegionOffset(NamedTuple):
    """The offset of one region as chains of r segments, or the failure that prevented it."""

    line: OutF64_2  #: (r, 5) x0, y0, x1, y1, bulge
    tag: OutI64_2  #: (r, 4) contour segment, whether inserted, path, raw row
    bounds: OutI64_1  #: first row of each chain, and the number of rows
    chains: int  #: number of chains
    unreached: float  #: area that the tool cannot reach (mm²)
    overlaps: bool  #: whether the area is an estimate, because arcs of the tool's edge overlap
    code: int  #: ``raw_segments.NO_FAILURE`` or another code
    row: int  #: segment that fails
    other_row: int  #: segment that the tool comes too close to
    depth: float  #: depth by which the tool would cut into ``other_row`` (mm)
