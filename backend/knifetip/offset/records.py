"""records: groups of arrays that the kernels of the offset engine pass to each other."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.kernels import (
    F64_1,
    F64_2,
    I32_1,
    I64_1,
    U8_1,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutF64_2,
    OutI32_1,
    OutI64_1,
    OutI64_2,
)


class Contours(NamedTuple):
    """n segments of p paths, before offsetting."""

    start: F64_2  #: (n, 2) mm
    end: F64_2  #: (n, 2) mm
    bulge: F64_1  #: (n,) tan(sweep / 4)
    first: I32_1  #: (p + 1,) first segment of each path, and n


class CornerTypes(NamedTuple):
    """Type of the transition at the start of each segment, for convex corners."""

    kind: U8_1  #: (n,) or (1,) ``transition.Corner``
    share: F64_1  #: (n,) or (1,) share of C in D
    step: int  #: 1, or 0 if all corners have the first kind


class MovedSegments(NamedTuple):
    """Segments moved to their side by the radius, not yet connected."""

    table: OutF64_2  #: (n, ``raw_segments.COLUMNS``)
    joint: OutI64_1  #: (n,) kind of joint at the start of each, such as ``raw_segments.CONVEX``


class OffsetSegments(NamedTuple):
    """Room for m segments of the result."""

    start: OutF64_2  #: (m, 2) mm
    end: OutF64_2  #: (m, 2) mm
    bulge: OutF64_1  #: (m,)
    source: OutI32_1  #: (m,) segment of the contour
    inserted: OutBool_1  #: (m,) whether it belongs to a transition


class RawRows(NamedTuple):
    """Room for rows that are split where they cross."""

    rows: OutF64_2  #: (m, 5) x0, y0, x1, y1, bulge
    info: OutI64_2  #: (m, 4) segment, whether inserted, whether the next row continues it, path


class RegionPaths(NamedTuple):
    """The c paths of one region."""

    member: I32_1  #: (c,) number of each
    begin: I64_1  #: (c + 1,) first segment of each in the region
    closed: Bool_1  #: (c,)


class RegionCorners(NamedTuple):
    """The corners of one region, at the start of each of its n segments."""

    moved: MovedSegments
    before: OutI64_1  #: (n,) segment before each
    kind: OutI64_1  #: (n,) ``transition.Corner``
    share: OutF64_1  #: (n,) share of C in D
    capped: bool  #: whether there is one of type C or D


class BoxTree(NamedTuple):
    """A tree of boxes over rows, as ``boxes.tree`` fills it."""

    boxes: F64_2  #: (t, 4) x0, y0, x1, y1: of the rows, then of the nodes above them
    level: I64_1  #: (24,) first box of each height
    height: int  #: of the root


class JoinedPieces(NamedTuple):
    """q pieces of rows, and how they continue each other."""

    piece: F64_2  #: (q, 6) x0, y0, x1, y1, and the parameters of the row at its start and end
    owner: I64_1  #: (q,) row of each
    opening: I64_1  #: first piece of each row
    after: OutI64_1  #: (q,) piece that continues each, -1 for none
    before: OutI64_1  #: (q,) piece that each continues, -1 for none


class ResultChains(NamedTuple):
    """Room for r rows of the result in chains."""

    line: OutF64_2  #: (r, 5) x0, y0, x1, y1, bulge
    tag: OutI64_2  #: (r, 4) segment, whether inserted, path, row
    bounds: OutI64_1  #: first row of each chain, and the number of rows
    ring: OutBool_1  #: whether each chain is closed


class OffsetGroups(NamedTuple):
    """The paths of all groups, and the signed radius of each path."""

    member: I32_1  #: (p,) paths in the order of their groups
    bounds: I32_1  #: (g + 1,) where each group begins in ``member``
    signed: F64_1  #: (p,) mm, positive left of travel


class OffsetChains(NamedTuple):
    """Room for c chains of the result."""

    first: OutI32_1  #: (c,) first row of each
    owner: OutI32_1  #: (c,) path of each
    unreached: OutF64_1  #: (p,) mm² beside each path


class RegionOffset(NamedTuple):
    """The offset of one region, or the failure."""

    line: OutF64_2  #: rows x0, y0, x1, y1, bulge
    tag: OutI64_2  #: of each row: segment, whether inserted, path, raw row
    bounds: OutI64_1  #: first row of each chain, and the number of rows
    chains: int  #: number of chains
    unreached: float  #: area that the tool does not reach (mm²)
    overlaps: bool  #: whether the area is an estimate, because arcs of the tool's edge overlap
    code: int  #: ``raw_segments.FINE`` or another failure
    row: int  #: segment that fails
    other: int  #: segment that it comes too close to
    depth: float  #: by which the tool would cut into it (mm)
