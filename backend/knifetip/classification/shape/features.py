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
from dataclasses import dataclass, fields, replace
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.arrows import find_arrow_edges
from knifetip.classification.shape.dimension_lines import find_dimension_edges
from knifetip.classification.shape.edge_sums import (
    EdgeSums,
    Pieces,
    fill_short_edges,
    find_narrow_faces,
    sum_pieces,
)
from knifetip.classification.shape.fold_slots import mark_fold_slots
from knifetip.classification.shape.measures import ComponentBoxes
from knifetip.classification.shape.micro_loops import contract_micro_loops
from knifetip.classification.shape.missing_lines import (
    MOST_TRIALS,
    PanelGroups,
    find_missing_lines,
)
from knifetip.classification.shape.missing_pieces import find_missing_pieces
from knifetip.classification.shape.open_dividers import DividerKind, find_divider_kinds
from knifetip.classification.shape.open_flaps import find_open_flaps
from knifetip.classification.shape.outline_slits import mark_outline_slits
from knifetip.classification.shape.part_kinds import PartKinds
from knifetip.classification.shape.piece_roles import piece_roles
from knifetip.classification.shape.required_folds import find_required_folds
from knifetip.classification.shape.roles import Role
from knifetip.classification.shape.shared_outlines import mark_shared_outlines
from knifetip.classification.shape.splinters import find_splinters
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.parallel import chunks, parallel_map, parallel_pair
from knifetip.geometry.tolerance import GAP
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
#: Least area of a panel beside a missing line, as a fraction of the square of the line's length.
_MIN_PANEL: Final = 0.1


@dataclass(frozen=True, eq=False, slots=True)
class ShapeFeatures:
    """Features of the shape of a drawing with n edges, such as the role of each edge.

    The planar graph of the edges has f faces.
    """

    role: U8  #: (n,) Role of the greatest part of each edge's length
    role_fraction: F64  #: (n,) fraction of the edge's length that has this role, 0 … 1
    second_role: U8  #: (n,) Role of most of the rest of its length, ``role`` if there is no rest
    paired: Bool  #: (n,) whether a narrow face on one side separates it from a parallel line
    dashed: Bool  #: (n,) whether it is one of a row of dashes
    must_fold: Bool  #: (n,) whether a panel is attached by this edge alone
    divider_kind: U8  #: (n,) DividerKind of edges that may be slits or folds
    beside_gap: Bool  #: (n,) whether it divides panels only if the outline lacks a straight line
    near_text: Bool  #: (n,) whether a text is in or beside the bounding box of its component
    coincident: I32  #: (n,) edge that covers the whole length of each edge, -1 for none
    component: I32  #: (n,) connected component of the graph, -1 for none
    blanks: I32  #: (n,) number of equal blanks that its component consists of, 1 for others
    faces: I32  #: (n, 2) faces on the left and on the right of the longest piece of each edge
    #: (k, 3) an edge, and the faces beside another piece of it than the longest, where they differ
    further_faces: I32
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
            if field.name == "further_faces":
                columns[field.name] = np.column_stack([rows[column[:, 0]], column[:, 1:]]).astype(
                    np.int32
                )
                continue
            filled = np.zeros((count, *column.shape[1:]), column.dtype)
            if field.name in ("component", "coincident", "sides", "part"):
                filled[:] = -1
            elif field.name == "blanks":
                filled[:] = 1
            elif field.name in ("role", "second_role"):
                filled[:] = role
            elif field.name == "role_fraction":
                filled[:] = role != Role.UNKNOWN
            if field.name == "coincident":
                column = np.where(column < 0, -1, rows[column])
            filled[rows] = column
            columns[field.name] = filled
        return ShapeFeatures(**columns)

    def first(self, count: int) -> ShapeFeatures:
        """Return the features of the first ``count`` edges, examined together with the others."""
        columns: dict[str, Any] = {field.name: getattr(self, field.name) for field in fields(self)}
        for name, column in columns.items():
            if name == "further_faces":
                columns[name] = column[column[:, 0] < count]
            elif name != "face_area":
                columns[name] = column[:count]
        covered = columns["coincident"]
        columns["coincident"] = np.where(covered < count, covered, -1).astype(np.int32)
        return ShapeFeatures(**columns)

    def of_pieces(self, row: I64, first: I64) -> ShapeFeatures:
        """Return the features of n edges that are pieces of the m lines in this record.

        Parameters
        ----------
        row : (n,)
            The line that each edge is a piece of.
        first : (m,)
            The first edge of each line.
        """
        columns: dict[str, Any] = {}
        for field in fields(self):
            column = getattr(self, field.name)
            if field.name == "face_area":
                columns[field.name] = column
            elif field.name == "further_faces":
                columns[field.name] = np.column_stack([first[column[:, 0]], column[:, 1:]]).astype(
                    np.int32
                )
            else:
                columns[field.name] = column[row]
        covering = columns["coincident"]
        columns["coincident"] = np.where(covering < 0, -1, first[covering]).astype(np.int32)
        return ShapeFeatures(**columns)

    def like(self, rows: I64, host: I64) -> ShapeFeatures:
        """Return a copy of the record in which some edges get the features of other edges.

        ``rows`` (k,) are the indices of the edges, and ``host`` (k,) those of the other edges.
        """
        columns: dict[str, Any] = {field.name: getattr(self, field.name) for field in fields(self)}
        for name, column in columns.items():
            if name not in ("face_area", "further_faces", "coincident", "must_fold", "dashed"):
                columns[name] = column.copy()
                columns[name][rows] = column[host]
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
    contracted = contract_micro_loops(ends, bulge, unit)
    if contracted is None:
        return _in_order(_Extraction(ends, bulge, annotations, unit, with_folds))
    rows = contracted.rows
    rest = _Extraction(contracted.ends, bulge[rows], annotations, unit, with_folds)
    return _in_order(rest).spread(count, rows, Role.UNKNOWN).like(contracted.loop, contracted.host)


def _in_order(edges: _Extraction) -> ShapeFeatures:
    """Return the shape features of edges; neighbours are examined together, which is faster."""
    order = spatial_order(edges.ends)
    if order is None:
        return edges.features()
    ordered = edges._replace(ends=edges.ends[order], bulge=edges.bulge[order])
    return ordered.features().spread(len(order), order, Role.UNKNOWN)


def _no_features(count: int) -> ShapeFeatures:
    """Return shape features of ``count`` edges in which every role is unknown.

    They are used if no planar graph is built, because there are no edges, or they are too crowded
    or cross too often.
    """
    none = np.zeros(count, np.bool_)
    return ShapeFeatures(
        np.zeros(count, np.uint8),
        np.zeros(count),
        np.zeros(count, np.uint8),
        none,
        none,
        none,
        np.zeros(count, np.uint8),
        none,
        none,
        np.full(count, -1, np.int32),
        np.full(count, -1, np.int32),
        np.ones(count, np.int32),
        np.zeros((count, 2), np.int32),
        np.empty((0, 3), np.int32),
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

        Edges of dimensions and arrows are found first; the other edges are examined without them.
        """
        dimension = find_dimension_edges(self.ends, self.bulge, self.annotations, self.unit)
        if dimension is None:
            return self._features_without_arrows()
        count = len(self.bulge)
        rows = np.flatnonzero(~(dimension.certain | dimension.possible))
        rest = self._replace(ends=self.ends[rows], bulge=self.bulge[rows])
        features = rest._features_without_arrows().spread(count, rows, Role.DIMENSION)
        features.role[dimension.possible] = Role.MEASURED
        return features

    def _features_without_arrows(self) -> ShapeFeatures:
        """Return the shape features of all edges, examined without the edges of arrows."""
        count = len(self.bulge)
        graph = self._graph()
        if graph is None:
            return _no_features(count)
        arrow = find_arrow_edges(graph, count, self.unit)
        if not arrow.any():
            return self._features_of_closed(graph)
        rows = np.flatnonzero(~arrow)
        rest = self._replace(ends=self.ends[rows], bulge=self.bulge[rows])
        graph = rest._graph()
        if graph is None:
            return _no_features(len(rows)).spread(count, rows, Role.ARROW)
        return rest._features_of_closed(graph).spread(count, rows, Role.ARROW)

    def _features_of_closed(self, graph: PlanarGraph) -> ShapeFeatures:
        """Return the features of all edges, examined with lines that are missing in outlines."""
        features = self._features_in(graph)
        if Role.OPEN in features.role:
            return self._with_missing_pieces(graph, features)
        return self._with_missing_lines(features)

    def _with_missing_pieces(self, graph: PlanarGraph, features: ShapeFeatures) -> ShapeFeatures:
        """Return the features of all edges, examined with pieces that are missing in outlines.

        Pieces are added only if they close all open outlines and lie on outlines themselves.
        ``features`` are those without the pieces.
        """
        pieces, count = find_missing_pieces(graph, self.ends, self.bulge), len(self.bulge)
        while len(pieces):
            with_pieces = self._features_with(pieces)
            if with_pieces is None:
                break
            closes = with_pieces.role[count:] == Role.OUTLINE
            if closes.all():
                return features if Role.OPEN in with_pieces.role else with_pieces.first(count)
            pieces = pieces[closes]
        return features

    def _with_missing_lines(self, features: ShapeFeatures) -> ShapeFeatures:
        """Return the features of all edges, examined with straight lines that outlines lack.

        A line is added only if it lies on an outline, and joins all panels of its blank.
        ``features`` are those without the lines.
        """
        groups = self._panel_groups(features)
        blanks = find_missing_lines(self.ends, self.bulge, features.component, groups, self.unit)
        accepted = np.empty((0, 2, 2))
        for rank in range(MOST_TRIALS):
            blanks = [lines for lines in blanks if rank < len(lines)]
            if not blanks:
                break
            trial = np.concatenate([accepted, [lines[rank] for lines in blanks]])
            with_lines = self._features_with(trial)
            if with_lines is None:
                break
            joins = self._join(with_lines, trial)
            blanks = [blanks[k] for k in np.flatnonzero(~joins[len(accepted) :]).tolist()]
            accepted = trial[joins]
        if len(accepted) == 0:
            return features
        with_lines = self._features_with(accepted)
        if with_lines is None or not self._join(with_lines, accepted).all():
            return features
        joined = with_lines.first(len(self.bulge))
        beside_gap = (features.role == Role.OUTLINE) & (joined.role == Role.DIVIDER)
        # The drawing has no panel beside a line that it does not contain.
        sides, part = features.sides, features.part
        return replace(joined, beside_gap=beside_gap, sides=sides, part=part)

    def _join(self, features: ShapeFeatures, lines: F64) -> Bool:
        """Return the mask of the lines that lie on an outline and join all panels of a blank, (k,).

        ``lines`` (k, 2, 2) are the last of the edges that ``features`` are about.
        """
        count = len(self.bulge)
        groups = self._panel_groups(features).number[features.component[count:]]
        beside = features.face_area[features.faces[count:]].max(axis=1)
        panel = beside >= _MIN_PANEL * ((lines[:, 1] - lines[:, 0]) ** 2).sum(axis=1)
        join: Bool = (features.role[count:] == Role.OUTLINE) & (groups == 1) & panel
        return join

    def _panel_groups(self, features: ShapeFeatures) -> PanelGroups:
        """Return the groups of panels that dividers join."""
        return PanelGroups.find(
            features.role,
            features.component,
            features.blanks,
            features.faces,
            features.further_faces,
            features.face_area,
            self.unit * self.unit,
        )

    def _features_with(self, lines: F64) -> ShapeFeatures | None:
        """Return the features of all edges and of k straight lines, (k, 2, 2), after them.

        Returns None if no planar graph is built.
        """
        ends = np.concatenate([self.ends, lines])
        more = self._replace(ends=ends, bulge=np.append(self.bulge, np.zeros(len(lines))))
        graph = more._graph()
        return None if graph is None else more._features_in(graph)

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
        role = piece_roles(graph, faces, kinds)
        blanks, shared = mark_shared_outlines(graph, faces, length, role, unit)
        sides = faces.left, faces.right
        is_splinter = find_splinters(*sides, graph.twin_piece, length, faces.area)
        mark_outline_slits(graph, faces, is_splinter, length, role, count)
        is_slot = mark_fold_slots(graph, faces, length, role, unit) | is_splinter
        narrow = find_narrow_faces(faces.left, faces.right, length, faces.area, _NARROW * unit)
        edges = EdgeSums.allocate(count)
        pieces = Pieces(graph.component, length, role, faces.left, faces.right)

        def sum_up(chunk: tuple[int, int]) -> None:
            sum_pieces(graph.first, pieces, narrow, edges, *chunk)

        parallel_map(sum_up, chunks(count, MIN_CHUNK))
        inside = np.where(edges.length[:, None] > 0.0, _bounded_faces(faces)[edges.faces], -1)
        fill_short_edges(edges, graph, self.ends, length, tolerance)
        # Component -1 takes the last entry: a drawing of only very short edges has no component.
        near_text: Bool = np.append(kinds.near_text, np.False_)[edges.component]
        none = np.zeros(count, np.bool_)
        edge_role = np.where(edges.length > 0.0, edges.role, np.uint8(Role.UNKNOWN))
        must_fold, kind = none, np.zeros(count, np.uint8)
        if self.with_folds:
            must_fold = find_required_folds(graph, faces, role, is_slot, length, count, blanks)
            kind = find_divider_kinds(graph, faces, role, is_slot, shared, must_fold, length)
            kind[find_open_flaps(graph, role, length, edge_role)] = DividerKind.OPEN_FLAP
        return ShapeFeatures(
            edge_role,
            edges.fraction,
            edges.second_role,
            edges.paired,
            graph.dashed,
            must_fold,
            kind,
            none,
            near_text,
            coincident_edges(graph, length),
            edges.component,
            np.append(blanks, np.int32(1))[edges.component],
            edges.faces,
            _further_faces(graph, faces, edges.faces),
            faces.area,
            inside,
            np.append(_outermost_components(faces, kinds.inside), np.int32(-1))[edges.component],
        )


def _further_faces(graph: PlanarGraph, faces: Faces, longest: I32) -> I32:
    """Return, for each piece whose faces differ from those in ``longest``, its edge and its two
    faces.

    ``graph``, ``faces``: planar graph of n edges, and its faces.
    ``longest`` (n, 2): faces on both sides of the longest piece of each edge.
    Returns (k, 3) int32: index of the edge, face on the left, and face on the right.
    """
    edge, left, right = graph.edge, faces.left, faces.right
    differ = (left != longest[edge, 0]) | (right != longest[edge, 1])
    rows = np.flatnonzero((edge >= 0) & differ)
    return np.column_stack([edge[rows], left[rows], right[rows]]).astype(np.int32)


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

    ``faces``: faces of the planar graph, which state the face around each component.
    ``inside`` (c,): whether each component is inside a face of a blank.
    """
    own = np.arange(len(inside), dtype=np.int32)
    outermost = np.where(
        inside & (faces.enclosing >= 0), faces.component[faces.enclosing], own
    ).astype(np.int32)
    # Each round doubles the number of levels that are skipped.
    while (farther := outermost[outermost]).tobytes() != outermost.tobytes():
        outermost = farther
    return outermost
