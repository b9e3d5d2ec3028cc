"""features: find the role of each edge in the shape of a drawing, and other features of its shape.

The drawing becomes a planar graph with faces.  The outer contour of a component that is inside no
other component is the outline of a blank.  A line between two faces of a blank divides panels, a
closed line inside a face is a hole, and a line with a dangling end is a slit or touches nothing.
``part_kinds`` finds components that are not blanks.  Arrows are removed first, since they would
divide panels.

A role depends on the whole component and never on a single line: a crease is recognised by the two
panels on its sides.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, fields
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.arrows import find_arrow_edges
from knifetip.classification.shape.measures import ComponentBoxes
from knifetip.classification.shape.part_kinds import PartKinds
from knifetip.classification.shape.required_folds import find_required_folds
from knifetip.classification.shape.roles import Role
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.parallel import chunks, parallel_map, parallel_pair
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
from knifetip.model.drawing import Annotation
from knifetip.topology.coincident import coincident_edges
from knifetip.topology.faces import Faces, trace_faces
from knifetip.topology.intersections import MIN_CHUNK
from knifetip.topology.morton_order import spatial_order
from knifetip.topology.planar_graph import PlanarGraph, build_graph

#: A dangling end nearer than this to another line is linked to it (mm).
_REACH: Final = 1.0
#: Assumed diagonal of a drawing whose unit is unknown (mm); only tolerances depend on it.
_ASSUMED_SIZE: Final = 500.0
#: Greatest width of a face between a pair of lines, such as a double crease or a slot (mm).
_NARROW: Final = 6.0


@dataclass(frozen=True, eq=False, slots=True)
class ShapeFeatures:
    """Features of the shape of a drawing with n edges, such as the role of each edge.

    The planar graph of the edges has f faces.
    """

    role: U8  #: (n,) Role of the greatest part of each edge's length
    role_fraction: F64  #: (n,) fraction of the edge's length that has this role, 0 … 1
    paired: Bool  #: (n,) whether a narrow face on one side separates it from a parallel line
    dashed: Bool  #: (n,) whether it is one of a row of dashes
    must_fold: Bool  #: (n,) whether a panel is attached by this edge alone
    near_text: Bool  #: (n,) whether a text is in or beside the bounding box of its component
    coincident: I32  #: (n,) edge that covers the whole length of each edge, -1 for none
    component: I32  #: (n,) connected component of the graph, -1 for none
    faces: I32  #: (n, 2) faces on the left and on the right of the longest piece of each edge
    face_area: F64  #: (f,) signed area of each face, ≤ 0 for the outer face of a component
    sides: I32  #: (n, 2) as ``faces``, with the face round its component for an outer face, or -1
    part: I32  #: (n,) outermost component that the edge belongs to or lies in, -1 for none

    def spread(self, count: int, rows: I64, role: Role) -> ShapeFeatures:
        """Return the features of all edges of a drawing, given the features of n of them.

        The other edges get the role ``role`` and belong to no component.

        Parameters
        ----------
        count
            Number of all edges of the drawing.
        rows : (n,)
            Index, among all edges, of each of the n edges in this record.
        role
            Role of all other edges.
        """
        columns: dict[str, Any] = {}
        for field in fields(self):
            column = getattr(self, field.name)
            if field.name == "face_area":
                columns[field.name] = column
                continue
            filled = np.zeros((count, *column.shape[1:]), column.dtype)
            if field.name in ("component", "coincident", "sides", "part"):
                filled[:] = -1
            elif field.name == "role":
                filled[:] = role
            elif field.name == "role_fraction":
                filled[:] = role != Role.UNKNOWN
            if field.name == "coincident":
                column = np.where(column < 0, -1, rows[column])
            filled[rows] = column
            columns[field.name] = filled
        return ShapeFeatures(**columns)


def extract_shape_features(
    ends: F64,
    bulge: F64,
    annotations: Sequence[Annotation] = (),
    unit_known: bool = True,
    with_folds: bool = True,
) -> ShapeFeatures:
    """Return the shape features of n edges.

    Parameters
    ----------
    ends, bulge : (n, 2, 2) and (n,)
        Ends and bulges of the edges.
    annotations
        Texts and dimensions of the drawing.
    unit_known
        Whether the ends are in mm.  Otherwise tolerances are proportional to the drawing's size.
    with_folds
        Whether to find the edges that must be folds; otherwise ``must_fold`` is False everywhere.
    """
    count = len(bulge)
    ends, bulge = np.array(ends, np.float64), np.array(bulge, np.float64)
    unit = 1.0
    if not unit_known and count:
        points = ends.reshape(-1, 2)
        diagonal = float(np.hypot(*(points.max(axis=0) - points.min(axis=0))))
        unit = diagonal / _ASSUMED_SIZE or 1.0
    order = spatial_order(ends)
    if order is None:
        return _Extraction(ends, bulge, annotations, unit, with_folds).features()
    ordered = _Extraction(ends[order], bulge[order], annotations, unit, with_folds)
    return ordered.features().spread(count, order, Role.UNKNOWN)


def _no_features(count: int) -> ShapeFeatures:
    """Return shape features of ``count`` edges in which every role is unknown.

    They are used if no planar graph is built, because there are no edges, or they are too crowded
    or cross too often.
    """
    none = np.zeros(count, np.bool_)
    return ShapeFeatures(
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
        np.full((count, 2), -1, np.int32),
        np.full(count, -1, np.int32),
    )


class _Extraction(NamedTuple):
    """The edges of a drawing, and the options with which their shape features are computed."""

    ends: F64  #: (n, 2, 2)
    bulge: F64  #: (n,)
    annotations: Sequence[Annotation]
    unit: float
    with_folds: bool

    def features(self) -> ShapeFeatures:
        """Return the shape features of all edges.

        Edges of arrows are found first; the other edges are examined without them.
        """
        count = len(self.bulge)
        graph = self._graph()
        if graph is None:
            return _no_features(count)
        arrow = find_arrow_edges(graph, count, self.unit)
        if not arrow.any():
            return self._features_in(graph)
        rows = np.flatnonzero(~arrow)
        rest = self._replace(ends=self.ends[rows], bulge=self.bulge[rows])
        graph = rest._graph()
        if graph is None:
            return _no_features(len(rows)).spread(count, rows, Role.ARROW)
        return rest._features_in(graph).spread(count, rows, Role.ARROW)

    def _graph(self) -> PlanarGraph | None:
        """Return the planar graph of the edges.

        Returns None if there are no edges, or if the graph would take too long to build because the
        edges are too crowded or cross too often.
        """
        return build_graph(self.ends, self.bulge, GAP * self.unit, _REACH * self.unit)

    def _features_in(self, graph: PlanarGraph) -> ShapeFeatures:
        """Return the features of all edges, from their planar graph.

        The edges of arrows must not be in the graph.
        """
        count, unit, tolerance = len(self.bulge), self.unit, GAP * self.unit
        (length, boxes), faces = parallel_pair(
            lambda: (
                arc.length_from_chord(graph.chords(), graph.bulge),
                ComponentBoxes.measure(graph, unit),
            ),
            lambda: trace_faces(graph, self.ends, self.bulge, tolerance),
        )
        kinds = PartKinds.find(graph, faces, length, boxes, self.annotations, unit)
        role = _piece_roles(graph, faces, kinds)
        narrow = _find_narrow_faces(faces.left, faces.right, length, faces.area, _NARROW * unit)
        edges = _EdgeSums.allocate(count)
        pieces = _Pieces(graph.component, length, role, faces.left, faces.right)

        def sum_up(chunk: tuple[int, int]) -> None:
            _sum_pieces(graph.first, pieces, narrow, edges, *chunk)

        parallel_map(sum_up, chunks(count, MIN_CHUNK))
        sides = np.where(edges.length[:, None] > 0.0, _bounded_faces(faces)[edges.faces], -1)
        _fill_short_edges(edges, graph, self.ends, length, tolerance)
        # Component -1 takes the last entry: a drawing of only very short edges has no component.
        near_text: Bool = np.append(kinds.near_text, np.False_)[edges.component]
        none = np.zeros(count, np.bool_)
        return ShapeFeatures(
            np.where(edges.length > 0.0, edges.role, np.uint8(Role.UNKNOWN)),
            edges.fraction,
            edges.paired,
            graph.dashed,
            find_required_folds(graph, faces, role, length, count) if self.with_folds else none,
            near_text,
            coincident_edges(graph, length),
            edges.component,
            edges.faces,
            faces.area,
            sides,
            np.append(_outermost_components(faces, kinds.inside), np.int32(-1))[edges.component],
        )


def _bounded_faces(faces: Faces) -> I32:
    """Return the bounded face for each of f faces, (f,): the face itself or the face around it.

    The entry of a bounded face is the face itself.  The entry of the outer face of a component is
    the bounded face that contains the component, or -1 if there is none.
    """
    bounded = np.arange(len(faces.area), dtype=np.int32)
    bounded[faces.outer_face] = faces.enclosing
    return bounded


def _outermost_components(faces: Faces, inside: Bool) -> I32:
    """Return the outermost component around each of c components, (c,).

    The entry of a component that is not inside a blank is the component itself.

    Parameters
    ----------
    faces
        Faces of the planar graph, which state the face around each component.
    inside : (c,)
        Whether each component is inside a face of a blank.
    """
    own = np.arange(len(inside), dtype=np.int32)
    outermost = np.where(
        inside & (faces.enclosing >= 0), faces.component[faces.enclosing], own
    ).astype(np.int32)
    # Each round doubles the number of levels that are skipped.
    while (farther := outermost[outermost]).tobytes() != outermost.tobytes():
        outermost = farther
    return outermost


class _Pieces(NamedTuple):
    """Component, length, role and adjacent faces of each of the p pieces of a planar graph.

    A piece is the part of an edge between two neighbouring vertices.
    """

    component: I32_1  #: (p,) connected component
    length: F64_1  #: (p,)
    role: U8_1  #: (p,) Role
    left: I32_1  #: (p,) face on the left
    right: I32_1  #: (p,) face on the right


class _EdgeSums(NamedTuple):
    """Role, length, component and other features of each of n edges.

    They are computed from the pieces into which the vertices of a planar graph divide the edge.
    """

    role: OutU8_1  #: (n,) Role of the greatest part of the length
    fraction: OutF64_1  #: (n,) fraction of the length that has this role
    length: OutF64_1  #: (n,) length of all pieces; 0 for edges without pieces
    paired: OutBool_1  #: (n,) whether most of the edge has a narrow face on exactly one side
    component: OutI32_1  #: (n,) connected component, -1 for edges without pieces
    faces: OutI32_2  #: (n, 2) faces on both sides of the longest piece

    @classmethod
    def allocate(cls, count: int) -> _EdgeSums:
        """Return a record with uninitialised columns for ``count`` edges."""
        return cls(
            np.empty(count, np.uint8),
            np.empty(count),
            np.empty(count),
            np.empty(count, np.bool_),
            np.empty(count, np.int32),
            np.empty((count, 2), np.int32),
        )


def _fill_short_edges(
    edges: _EdgeSums, graph: PlanarGraph, ends: F64, length: F64, tolerance: float
) -> None:
    """Give each edge that is too short for the planar graph the role and component of a neighbour.

    An edge shorter than ``tolerance`` is not in the graph.  The neighbour is an edge in the graph
    that touches the start of the short edge: the preceding edge in the file, or else the longest
    one.  If there is no neighbour, the features of the short edge do not change.

    Parameters
    ----------
    edges
        Features of the n edges, to which the function writes.
    graph
        Planar graph of the edges; its vertices divide the edges into p pieces.
    ends : (n, 2, 2)
        Start and end points of the n edges.
    length : (p,)
        Length of each piece.
    tolerance
        Largest distance between ends of edges that became one vertex (drawing units).
    """
    short_edges = np.flatnonzero(edges.length == 0.0)
    with_pieces = np.where(edges.length > 0.0, np.arange(len(edges.length)), 0)
    previous = np.maximum.accumulate(with_pieces)[short_edges]
    gap = np.hypot(*(ends[previous, 1] - ends[short_edges, 0]).T)
    # If the edge before in the file does not end there: the edge of the longest piece that does.
    model = np.where(
        (edges.length[previous] > 0.0) & (gap <= 4.0 * tolerance),
        previous,
        _longest_neighbours(graph, length, short_edges),
    )
    short_edges, model = short_edges[model >= 0], model[model >= 0]
    edges.role[short_edges], edges.fraction[short_edges] = edges.role[model], edges.fraction[model]
    edges.component[short_edges] = edges.component[model]
    edges.length[short_edges] = tolerance


@kernel
def _find_narrow_faces(left: I32_1, right: I32_1, length: F64_1, area: F64_1, width: float) -> Any:
    """Return the mask of the faces of a planar graph that are long and narrow, (f,).

    A face is narrow if its mean width is less than ``width``.  The p pieces are the parts of edges
    between neighbouring vertices.

    Parameters
    ----------
    left, right : (p,)
        Index of the face on the left and of the face on the right of each piece.
    length : (p,)
        Length of each piece.
    area : (f,)
        Signed area of each face.
    width
        Limit of the mean width, in the unit of the lengths.
    """
    left_length, right_length = np.zeros(len(area)), np.zeros(len(area))
    for p in range(len(length)):
        left_length[left[p]] += length[p]
        right_length[right[p]] += length[p]
    result = np.empty(len(area), np.bool_)
    for f in range(len(area)):
        perimeter = left_length[f] + right_length[f]
        long = perimeter > 5.0 * width
        result[f] = area[f] > 0.0 and long and 2.0 * area[f] < width * perimeter
    return result


@kernel
def _sum_pieces(
    first: I32_1, pieces: _Pieces, narrow: Bool_1, edges: _EdgeSums, begin: int, end: int
) -> None:
    """Compute the features of edges ``begin`` … ``end`` - 1 from the pieces of each edge.

    The vertices of the planar graph divide each edge into pieces.

    Parameters
    ----------
    first : (n + 1,)
        Index of the first piece of each edge.
    pieces
        Length, role, component and adjacent faces of each piece.
    narrow : (f,)
        Whether each face is narrow.
    edges
        Features of the n edges, to which the function writes.
    """
    component, length, role, left, right = pieces
    by_role = np.zeros(256)
    for i in range(begin, end):
        edges.component[i] = component[first[i]] if first[i] < first[i + 1] else -1
        longest = total = paired = 0.0
        best = 0
        edges.faces[i, 0] = edges.faces[i, 1] = 0
        for p in range(first[i], first[i + 1]):
            by_role[role[p]] += length[p]
            total += length[p]
            if narrow[left[p]] != narrow[right[p]]:
                paired += length[p]
            if length[p] > longest:
                longest = length[p]
                edges.faces[i, 0], edges.faces[i, 1] = left[p], right[p]
        for p in range(first[i], first[i + 1]):
            kind = role[p]
            if by_role[kind] > by_role[best] or (by_role[kind] == by_role[best] and kind < best):
                best = kind
        edges.role[i] = best
        edges.fraction[i] = by_role[best] / total if total > 0.0 else 0.0
        edges.length[i], edges.paired[i] = total, paired > 0.5 * total
        for p in range(first[i], first[i + 1]):
            by_role[role[p]] = 0.0


def _longest_neighbours(graph: PlanarGraph, length: F64, short_edges: I64) -> I32:
    """Return for each of k short edges the neighbour that has the longest piece at its start, (k,).

    The short edges are so short that they are not in the planar graph.  A neighbour is an edge with
    a piece that starts or ends at the start vertex of the short edge; the entry is its index, or -1
    if there is no neighbour.  A piece is the part of an edge between two neighbouring vertices.

    Parameters
    ----------
    graph
        Planar graph of all edges, with p pieces.
    length : (p,)
        Length of each piece.
    short_edges : (k,)
        Indices of the short edges.
    """
    found = np.full(len(graph.vertex), -1, np.int32)
    if len(short_edges) == 0:
        return found[:0]
    wanted = np.zeros(len(graph.vertex), np.bool_)
    wanted[graph.end_vertex[2 * short_edges]] = True
    vertex = np.concatenate([graph.start, graph.end])
    edge = np.tile(graph.edge, 2)
    piece = np.flatnonzero(wanted[vertex] & (edge >= 0))
    piece = piece[np.argsort(np.tile(length, 2)[piece], kind="stable")]
    # Pieces are assigned by length, so that the longest one at a vertex remains.
    found[vertex[piece]] = edge[piece]
    return found[graph.end_vertex[2 * short_edges]]


#: Roles of a piece by the kind of its component: with the outer face on one side, on both sides,
#: with one bounded face on both sides, and with two bounded faces.
_BLANK: Final = Role.OUTLINE, Role.STRAY, Role.SLIT, Role.DIVIDER
_SMALL: Final = Role.MARK, Role.STRAY, Role.MARK, Role.MARK
_INSIDE: Final = Role.HOLE, Role.FREE, Role.INNER, Role.INNER
_SLOT: Final = Role.SLOT, Role.FREE, Role.INNER, Role.INNER


def _piece_roles(graph: PlanarGraph, faces: Faces, kinds: PartKinds) -> U8:
    """Return the role of each of the p pieces of a planar graph, (p,).

    A piece is the part of an edge between two neighbouring vertices.  Its role follows from the
    kind of its connected component, which ``kinds`` contains, and from the faces on its two sides.
    """
    # A component of several kinds gets the roles of the last of these rows.
    rows = (
        (kinds.doubtful, [Role.OPEN] * 4),
        (kinds.inside, _INSIDE),
        (kinds.slot, _SLOT),
        (kinds.small, _SMALL),
        (kinds.flat, [Role.STRAY] * 4),
        (kinds.debris, [Role.DEBRIS] * 4),
        (kinds.legend, [Role.LEGEND] * 4),
        (kinds.frame, [Role.FRAME] * 4),
        (kinds.bleed, [Role.BLEED] * 4),
        (kinds.enclosing, [Role.ENCLOSING] * 4),
        (kinds.table, [Role.TABLE] * 4),
        (kinds.letter, [Role.LETTER] * 4),
    )
    table = np.array([_BLANK, *(roles for _, roles in rows)], np.uint8)
    row = np.zeros(len(faces.outer_face), np.uint8)
    for number, (mask, _) in enumerate(rows, start=1):
        np.putmask(row, mask, number)
    role = np.empty(len(graph.component), np.uint8)

    def look_up(chunk: tuple[int, int]) -> None:
        _look_up_roles(
            table, row, graph.component, faces.left, faces.right, faces.outer_face, role, *chunk
        )

    parallel_map(look_up, chunks(len(role), MIN_CHUNK))
    return role


@kernel(allocates=False)
def _look_up_roles(
    table: U8_2,
    row: U8_1,
    component: I32_1,
    left: I32_1,
    right: I32_1,
    outer_face: I32_1,
    role: OutU8_1,
    begin: int,
    end: int,
) -> None:
    """Write the roles of pieces ``begin`` … ``end`` - 1 to ``role``, (p,).

    A piece is the part of an edge between two neighbouring vertices of a planar graph.

    Parameters
    ----------
    table : (kinds, 4)
        Role of a piece, by the kind of its component (row) and by the faces on its two sides
        (column).  Column 0: one of them is the outer face of the component; column 1: both are the
        outer face; column 2: both are the same bounded face; column 3: they are two different
        bounded faces.
    row : (c,)
        Row of ``table`` for each component.
    component, left, right : (p,)
        Component of each piece, and the faces on its left and on its right.
    outer_face : (c,)
        Outer face of each component.
    """
    for p in range(begin, end):
        outside = outer_face[component[p]]
        if left[p] == right[p]:
            column = 1 if left[p] == outside else 2
        else:
            column = 0 if left[p] == outside or right[p] == outside else 3
        role[p] = table[row[component[p]], column]
