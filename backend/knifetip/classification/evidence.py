"""evidence: what shape alone tells of each edge.

    ends, bulge, inscriptions -> Shape

The drawing is a planar graph with faces.  The outside of a part that lies in no other
is the outline of a blank; what parts two faces of it divides panels; a closed part inside a face is
a hole; a line that leads nowhere is a slit, or lies free.  What the parts are is told in ``parts``;
lines with arrowheads are taken out before all else (``arrows``), since they would divide panels.

Measured over the whole part, never from a single line: a crease is known by its two panels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, Final

import numpy as np

from knifetip.classification.arrows import arrows
from knifetip.classification.folding import holding
from knifetip.classification.measures import Extents
from knifetip.classification.parts import Parts
from knifetip.classification.role import Role
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.cores import both, each, runs
from knifetip.geometry.tolerance import GAP
from knifetip.kernels import (
    F64_1,
    I32_1,
    U8_1,
    U8_2,
    Bool_1,
    OutBool_1,
    OutF64_1,
    OutI32_1,
    OutI32_2,
    OutU8_1,
    kernel,
)
from knifetip.model.drawing import Inscription
from knifetip.topology.coincident import coincident_edges
from knifetip.topology.faces import Faces, trace_faces
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.morton_order import spatial_order
from knifetip.topology.planar_graph import PlanarGraph, build_graph

#: A loose end nearer than this to another line was meant to touch it (mm).
_REACH: Final = 1.0
#: A drawing whose unit is not known is taken to be so large across (mm): for tolerances only.
_ACROSS: Final = 500.0
#: A face narrower than this lies between a pair of lines: a double crease, a slot (mm).
_NARROW: Final = 6.0


@dataclass(frozen=True, eq=False, slots=True)
class Shape:
    """What shape tells of n edges."""

    tangled: bool  #: the drawing is too tangled to be looked at
    role: U8  #: (n,) Role of the greater part of each edge
    sure: F64  #: (n,) the share of its length that has this role
    paired: Bool  #: (n,) it bounds a face so narrow that it has a partner beside it
    dashed: Bool  #: (n,) it is one of a row of dashes
    holds: Bool  #: (n,) it must be a fold, since a panel hangs on it
    annotated: Bool  #: (n,) a text stands beside the part that it belongs to
    on: I32  #: (n,) an edge that it lies wholly on, -1 for none
    part: I32  #: (n,) the connected part of the drawing that it belongs to, -1 for none
    sides: I32  #: (n, 2) the faces on its two sides, along most of its length
    area: F64  #: (f,) of each face, ≤ 0 for the outside of a part

    def among(self, count: int, rows: I64, role: Role) -> Shape:
        """Return what is told of all ``count`` edges, of which these are some; the rest are alike.

        Parameters
        ----------
        rows
            Where these edges are among all.
        role
            Of the rest.
        """
        whole: dict[str, Any] = {}
        for one in fields(self):
            column = getattr(self, one.name)
            if one.name in ("tangled", "area"):
                whole[one.name] = column
                continue
            filled = np.zeros((count, *column.shape[1:]), column.dtype)
            if one.name in ("part", "on"):
                filled[:] = -1
            elif one.name == "role":
                filled[:] = role
            elif one.name == "sure":
                filled[:] = role != Role.UNKNOWN
            filled[rows] = np.where(column < 0, -1, rows[column]) if one.name == "on" else column
            whole[one.name] = filled
        return Shape(**whole)


def shape(
    ends: F64,
    bulge: F64,
    inscriptions: Sequence[Inscription] = (),
    unit_known: bool = True,
    folds: bool = True,
) -> Shape:
    """Return what shape tells of n edges, (n, 2, 2) and (n,).

    Parameters
    ----------
    unit_known
        Whether the ends are in mm; otherwise tolerances go by the size of the whole.
    folds
        Whether anybody wants to know which edges must be folds.
    """
    count = len(bulge)
    ends, bulge = np.array(ends, np.float64), np.array(bulge, np.float64)
    unit = 1.0
    if not unit_known and count:
        across = ends.reshape(-1, 2)
        unit = float(np.hypot(*(across.max(axis=0) - across.min(axis=0)))) / _ACROSS or 1.0
    order = spatial_order(ends)
    if order is None:
        return _shape(ends, bulge, inscriptions, unit, folds)
    seen = _shape(ends[order], bulge[order], inscriptions, unit, folds)
    return seen.among(count, order, Role.UNKNOWN)


def _shape(
    ends: F64, bulge: F64, inscriptions: Sequence[Inscription], unit: float, folds: bool
) -> Shape:
    count = len(bulge)
    graph = build_graph(ends, bulge, GAP * unit, _REACH * unit)
    if graph is None:
        return _nothing(count)
    said = arrows(graph, count, unit)
    if not said.any():
        return _seen(graph, ends, bulge, inscriptions, unit, folds)
    rest = np.flatnonzero(~said)
    graph = build_graph(ends[rest], bulge[rest], GAP * unit, _REACH * unit)
    if graph is None:
        return _nothing(len(rest)).among(count, rest, Role.ARROW)
    seen = _seen(graph, ends[rest], bulge[rest], inscriptions, unit, folds)
    return seen.among(count, rest, Role.ARROW)


def _nothing(count: int) -> Shape:
    none = np.zeros(count, np.bool_)
    return Shape(
        count > 0,
        np.zeros(count, np.uint8),
        np.zeros(count),
        none,
        none,
        none,
        none,
        np.full(count, -1, np.int32),
        np.full(count, -1, np.int32),
        np.zeros((count, 2), np.int32),
        np.zeros(1),
    )


def _seen(
    graph: PlanarGraph,
    ends: F64,
    bulge: F64,
    inscriptions: Sequence[Inscription],
    unit: float,
    folds: bool,
) -> Shape:
    count, touch = len(bulge), GAP * unit
    (length, extents), sides = both(
        lambda: (arc.over(graph.chords(), graph.bulge), Extents.of(graph, unit)),
        lambda: trace_faces(graph, ends, bulge, touch),
    )
    parts = Parts.of(graph, sides, length, extents, inscriptions, unit)
    role = _roles(graph, sides, parts)
    slender = _slender(sides.left, sides.right, length, sides.area, _NARROW * unit)
    greatest, share, whole = np.empty(count, np.uint8), np.empty(count), np.empty(count)
    narrow, part_of = np.empty(count, np.bool_), np.empty(count, np.int32)
    beside_it = np.empty((count, 2), np.int32)

    def gathered(run: tuple[int, int]) -> None:
        pieces = graph.first, graph.component, length, role, sides.left, sides.right
        _gather(*pieces, slender, greatest, share, whole, narrow, part_of, beside_it, *run)

    each(gathered, runs(count, MIN_CHUNK))
    # An edge too short to be a piece is what the edge before it is, which it goes on from.
    before = np.maximum.accumulate(np.where(whole > 0.0, np.arange(count), 0))
    speck = np.flatnonzero(whole == 0.0)
    like = before[speck]
    gap = np.hypot(*(ends[like, 1] - ends[speck, 0]).T)
    # In a file of another order it is what the longest is that ends there.
    like = np.where(
        (whole[like] > 0.0) & (gap <= 4.0 * touch), like, _longest(graph, length, speck)
    )
    speck, like = speck[like >= 0], like[like >= 0]
    greatest[speck], share[speck] = greatest[like], share[like]
    part_of[speck] = part_of[like]
    whole[speck] = touch
    # The last stands for no part: a drawing of nothing but specks has none.
    beside: Bool = np.append(parts.annotated, np.False_)[part_of]
    none = np.zeros(count, np.bool_)
    return Shape(
        False,
        np.where(whole > 0.0, greatest, np.uint8(Role.UNKNOWN)),
        share,
        narrow,
        graph.dashed,
        holding(graph, sides, role, length, count) if folds else none,
        beside,
        coincident_edges(graph, length),
        part_of,
        beside_it,
        sides.area,
    )


@kernel
def _slender(left: I32_1, right: I32_1, length: F64_1, area: F64_1, narrow: float) -> Any:
    """Return which faces are long and narrower than this, (f,)."""
    one, other = np.zeros(len(area)), np.zeros(len(area))
    for p in range(len(length)):
        one[left[p]] += length[p]
        other[right[p]] += length[p]
    result = np.empty(len(area), np.bool_)
    for f in range(len(area)):
        perimeter = one[f] + other[f]
        long = perimeter > 5.0 * narrow
        result[f] = area[f] > 0.0 and long and 2.0 * area[f] < narrow * perimeter
    return result


@kernel
def _gather(
    first: I32_1,
    part: I32_1,
    length: F64_1,
    role: U8_1,
    left: I32_1,
    right: I32_1,
    slender: Bool_1,
    greatest: OutU8_1,
    share: OutF64_1,
    whole: OutF64_1,
    narrow: OutBool_1,
    part_of: OutI32_1,
    sides: OutI32_2,
    begin: int,
    end: int,
) -> None:
    """Write of some edges what their pieces have the most of.

    Parameters
    ----------
    greatest, share, whole
        The role of the greater part of its length; that part of its length; its length.
    narrow
        Whether most of it has a slender face on one side alone.
    part_of
        The connected part that it is of, -1 where it has no piece.
    sides
        Those of its longest piece.
    """
    of = np.zeros(256)
    for i in range(begin, end):
        part_of[i] = part[first[i]] if first[i] < first[i + 1] else -1
        longest = total = paired = 0.0
        best = 0
        sides[i, 0] = sides[i, 1] = 0
        for p in range(first[i], first[i + 1]):
            of[role[p]] += length[p]
            total += length[p]
            if slender[left[p]] != slender[right[p]]:
                paired += length[p]
            if length[p] > longest:
                longest = length[p]
                sides[i, 0], sides[i, 1] = left[p], right[p]
        for p in range(first[i], first[i + 1]):
            kind = role[p]
            if of[kind] > of[best] or (of[kind] == of[best] and kind < best):
                best = kind
        greatest[i] = best
        share[i] = of[best] / total if total > 0.0 else 0.0
        whole[i], narrow[i] = total, paired > 0.5 * total
        for p in range(first[i], first[i + 1]):
            of[role[p]] = 0.0


def _longest(graph: PlanarGraph, length: F64, specks: I64) -> I32:
    """Return of edges without pieces the edge of the longest piece that ends there, -1 for none."""
    found = np.full(len(graph.vertex), -1, np.int32)
    if len(specks) == 0:
        return found[:0]
    wanted = np.zeros(len(graph.vertex), np.bool_)
    wanted[graph.end_vertex[2 * specks]] = True
    at = np.concatenate([graph.start, graph.end])
    piece = np.flatnonzero(wanted[at] & (np.tile(graph.edge, 2) >= 0))
    piece = piece[np.argsort(np.tile(length, 2)[piece], kind="stable")]
    # Of several at one place the last stays, which is the longest.
    found[at[piece]] = np.tile(graph.edge, 2)[piece]
    return found[graph.end_vertex[2 * specks]]


#: What a piece of each kind of part is: at its rim, on its own outside, in one face, between two.
_BLANK: Final = Role.OUTLINE, Role.STRAY, Role.SLIT, Role.DIVIDER
_SMALL: Final = Role.MARK, Role.STRAY, Role.MARK, Role.MARK
_INSIDE: Final = Role.HOLE, Role.FREE, Role.INNER, Role.INNER
_SLOT: Final = Role.SLOT, Role.FREE, Role.INNER, Role.INNER


def _roles(graph: PlanarGraph, sides: Faces, parts: Parts) -> U8:
    """Return the role of each piece, (p,)."""
    kinds = (
        (parts.doubtful, [Role.OPEN] * 4),
        (parts.inside, _INSIDE),
        (parts.slot, _SLOT),
        (parts.small, _SMALL),
        (parts.flat, [Role.STRAY] * 4),
        (parts.speck, [Role.SPECK] * 4),
        (parts.legend, [Role.LEGEND] * 4),
        (parts.frame, [Role.FRAME] * 4),
        (parts.bleed, [Role.BLEED] * 4),
        (parts.around, [Role.AROUND] * 4),
        (parts.table, [Role.TABLE] * 4),
        (parts.letter, [Role.LETTER] * 4),
    )
    table = np.array([_BLANK, *(roles for _, roles in kinds)], np.uint8)
    kind = np.zeros(len(sides.outer_face), np.uint8)
    for number, (which, _) in enumerate(kinds, start=1):
        np.putmask(kind, which, number)
    role = np.empty(len(graph.component), np.uint8)

    def looked_up(run: tuple[int, int]) -> None:
        _look_up(
            table, kind, graph.component, sides.left, sides.right, sides.outer_face, role, *run
        )

    each(looked_up, runs(len(role), MIN_CHUNK))
    return role


@kernel(allocates=False)
def _look_up(
    table: U8_2,
    kind: U8_1,
    part: I32_1,
    left: I32_1,
    right: I32_1,
    outside: I32_1,
    role: OutU8_1,
    begin: int,
    end: int,
) -> None:
    for p in range(begin, end):
        out = outside[part[p]]
        if left[p] == right[p]:
            column = 1 if left[p] == out else 2
        else:
            column = 0 if left[p] == out or right[p] == out else 3
        role[p] = table[kind[part[p]], column]
