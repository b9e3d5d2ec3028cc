"""required_folds: find the edges that must be folds because a panel is attached by them alone.

A blank is cut out in one piece.  If one straight line alone connects a panel to the rest of the
blank, the line cannot be a cut, since the panel would fall off.  If panels are connected in a ring
round a corner, one of the lines between them is a slit.  A slit starts at the outline, so a
straight line between two corners inside the blank is no slit.

No edge is found in a component that consists of several equal blanks without space between them.
A tab, a slot or a window inside a blank is not a panel.  It is recognised by a bend in its
boundary: a vertex at which exactly two pieces of edges meet at an angle.
"""

from __future__ import annotations

import math
from itertools import pairwise
from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.roles import HOLES, Role
from knifetip.geometry.columns import F64, I64, U8, Bool
from knifetip.kernels import I64_1, I64_2, kernel
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: Greatest difference between the directions of two lines on one straight line (radians).
_STRAIGHT: Final = math.radians(1.0)
#: Greatest difference between the areas of equal panels, as a fraction.
_AREA_TOLERANCE: Final = 0.003
#: Fewer panels than this are a board, a cover or a card rather than a carton.
_FEWEST_PANELS: Final = 6
#: Greatest distance between the centres of equal panels, as a fraction of the largest panel's size.
_CENTRE_TOLERANCE: Final = 0.01
#: If more than this fraction of the panels repeats others, they may belong to further blanks: …
_REPEATED: Final = 0.4
#: … or to a row of blanks, if more than this fraction does and the rest is a carton.  Panels of
#: a square carton also repeat side by side.
_REPEATED_IN_ROW: Final = 0.55
#: A carton has no more equal panels than this; a living hinge has, and so has a sheet of cards.
_MOST_EQUAL: Final = 16
#: Least fraction of the length of a carton's dividers that is straight from face to face.
_STRAIGHT_FRACTION: Final = 0.6
#: A component with more panels than this counts as several blanks.
_MOST_PANELS: Final = 64
#: Largest number of components that are examined.
_MOST_COMPONENTS: Final = 200


def find_required_folds(
    graph: PlanarGraph, faces: Faces, role: U8, length: F64, count: int
) -> Bool:
    """Return the mask of edges that must be folds, because a panel is attached by them alone, (n,).

    A piece is the part of an edge between two neighbouring vertices of the graph.

    Parameters
    ----------
    graph, faces
        Planar graph of the edges, with p pieces, and its faces.
    role, length : (p,)
        Role and length of each piece of the graph.
    count
        Number of edges, n.
    """
    divider = np.flatnonzero(role == Role.DIVIDER)
    if len(divider) == 0:
        return np.zeros(count, np.bool_)
    outline = role == Role.OUTLINE
    at_rim = np.zeros(len(faces.area), np.bool_)
    at_rim[faces.left[outline]] = at_rim[faces.right[outline]] = True
    degree, bent = _vertex_shapes(graph)
    vertex_on_rim = np.zeros(len(graph.vertex), np.bool_)
    for end in (graph.start, graph.end):
        vertex_on_rim[end[outline | np.isin(role, HOLES)]] = True
    panel = _find_panels(graph, faces, divider, at_rim, (degree == 2) & bent)
    left, right = faces.left[divider], faces.right[divider]
    pair, number = _face_pairs(left, right)
    borders = _Borders(graph, divider, number, len(pair))
    straight = borders.straight()
    inner = straight & borders.between_inner_corners(vertex_on_rim, degree)
    bridge = _find_bridges(pair, len(faces.area)) & straight
    chosen = (bridge | inner)[number] & borders.longest(length, count)
    carton = _find_single_cartons(graph, faces, length, at_rim, panel)
    # Maps and floor plans have faces and dividers too, but few straight ones.
    components, component = len(faces.outer_face), graph.component[divider]
    total = np.bincount(component, length[divider], components)
    straight_length = np.bincount(component, length[divider] * straight[number], components)
    carton &= straight_length >= _STRAIGHT_FRACTION * total
    required = panel[left] & panel[right] & chosen & carton[component]
    edge = graph.edge[divider]
    real = edge >= 0
    whole = np.bincount(edge[real], length[divider][real], count)
    part = np.bincount(edge[real & required], length[divider][real & required], count)
    return (part > 0.9 * whole) & (whole > 0.0)


def _find_panels(graph: PlanarGraph, faces: Faces, divider: I64, at_rim: Bool, bend: Bool) -> Bool:
    """Return the mask of faces that are panels, (f,).

    A bounded face inside a blank, away from its outline, is no panel if its boundary has a bend.
    Such a face is, for example, a tab or a window inside a panel.

    Parameters
    ----------
    graph, faces
        Planar graph with q vertices, and its f faces.
    divider : (d,)
        Indices of the pieces of edges between two faces of a blank; a bend is looked for at their
        ends.
    at_rim : (f,)
        Whether each face is at the outline of a blank.
    bend : (q,)
        Whether each vertex is a bend: exactly two pieces meet there, at an angle.
    """
    framed = np.zeros(len(faces.area), np.bool_)
    for side in (faces.left, faces.right):
        for end in (graph.start, graph.end):
            framed[side[divider][bend[end][divider]]] = True
    framed &= ~at_rim
    return ~framed & (faces.area > 0.0)


def _vertex_shapes(graph: PlanarGraph) -> tuple[I64, Bool]:
    """Return how many pieces meet at each vertex, (q,), and whether they form an angle there, (q,).

    A piece is the part of an edge between two neighbouring vertices of ``graph``.  Pieces form an
    angle if they are not all on one straight line.
    """
    vertices = len(graph.vertex)
    own = np.flatnonzero(graph.twin_piece == np.arange(len(graph.twin_piece)))
    ends = np.concatenate([graph.start[own], graph.end[own]])
    degree = np.bincount(ends, minlength=vertices)
    run = graph.vertex[graph.end[own]] - graph.vertex[graph.start[own]]
    # Twice the angle is independent of the direction in which a line is drawn.
    angle = np.arctan2(run[:, 1], run[:, 0]) * 2.0
    turn = 4.0 * np.arctan(graph.bulge[own])
    angles = np.concatenate([angle - turn, angle + turn])
    x = np.bincount(ends, np.cos(angles), vertices)
    y = np.bincount(ends, np.sin(angles), vertices)
    straight = np.hypot(x, y) >= degree * math.cos(_STRAIGHT)
    return degree, ~straight


def _face_pairs(left: Any, right: Any) -> tuple[I64, I64]:
    """Return the k pairs of neighbouring faces, (k, 2), and the pair of each piece, (d,).

    A piece is the part of an edge between two neighbouring vertices; its pair is the two faces on
    its sides.  The second array contains indices of pairs, 0 … k - 1.  ``left`` and ``right``,
    (d,), are the faces on the two sides of each of d pieces.
    """
    low, high = np.minimum(left, right).astype(np.int64), np.maximum(left, right).astype(np.int64)
    key = low * (int(high.max()) + 1) + high
    known, number = np.unique(key, return_inverse=True)
    return np.column_stack(np.divmod(known, int(high.max()) + 1)), number


class _Borders(NamedTuple):
    """The borders between k pairs of neighbouring faces of a planar graph.

    The borders consist of d pieces of edges; a piece connects two neighbouring vertices.
    """

    graph: PlanarGraph
    piece: I64  #: (d,) pieces of the borders
    pair: I64  #: (d,) number of the pair of faces on the two sides of each piece
    pairs: int  #: k, the number of pairs of faces

    def straight(self) -> Bool:
        """Return the mask of borders that are straight, (k,).

        A border is the common boundary of two neighbouring faces.  It is straight if all its parts
        are on one straight line.
        """
        graph, rows, number = self.graph, self.piece, self.pair
        start, end = graph.vertex[graph.start[rows]], graph.vertex[graph.end[rows]]
        length = np.hypot(*(end - start).T)
        first = np.searchsorted(np.sort(number), np.arange(self.pairs))
        # The extreme points along the direction of the longest piece define the line: a dash is
        # too short to define the direction of all.
        longest = np.lexsort((-length, number))[first]
        points = np.concatenate([start, end])
        numbers = np.concatenate([number, number])
        direction = (end - start)[longest][numbers]
        along = (points * direction).sum(axis=1)
        order = np.lexsort((along, numbers))
        low = points[order[2 * first]][number]
        high = points[order[np.append(2 * first[1:], len(order)) - 1]][number]
        direction = (high - low) / np.maximum(np.hypot(*(high - low).T), 1e-12)[:, None]
        off = np.abs(graph.bulge[rows]) > 1e-6
        for point in (start, end):
            away = point - low
            distance = np.abs(away[:, 0] * direction[:, 1] - away[:, 1] * direction[:, 0])
            off |= distance > math.sin(_STRAIGHT) * np.maximum(length, 10.0)
        result: Bool = np.bincount(number[off], minlength=self.pairs) == 0
        return result

    def between_inner_corners(self, on_rim: Bool, degree: I64) -> Bool:
        """Return the mask of borders that start and end at corners that are not on the rim, (k,).

        A border is the common boundary of two neighbouring faces; the rim is the outline of a
        blank.

        Parameters
        ----------
        on_rim : (q,)
            Whether each vertex is on the rim.
        degree : (q,)
            Number of pieces of edges that meet at each vertex.
        """
        graph, vertices = self.graph, len(self.graph.vertex)
        key = np.concatenate(
            [
                self.pair * vertices + graph.start[self.piece],
                self.pair * vertices + graph.end[self.piece],
            ]
        )
        known, count = np.unique(key, return_counts=True)
        tip, pair = (known % vertices)[count == 1], (known // vertices)[count == 1]
        loose = on_rim[tip] | (degree[tip] < 3)
        result: Bool = (np.bincount(pair, minlength=self.pairs) == 2) & (
            np.bincount(pair[loose], minlength=self.pairs) == 0
        )
        return result

    def longest(self, length: F64, count: int) -> Bool:
        """Return the mask of the pieces that belong to the longest edge of their border, (d,).

        A border is the common boundary of two faces; the d pieces are the parts of edges that all
        borders consist of.  In a border that contains dashes, the mask marks the pieces of all its
        dashes instead.  Short edges at the ends of a fold are left out, because they may be slits
        that lock it.

        Parameters
        ----------
        length : (p,)
            Length of each piece of the whole graph.
        count
            Number of edges of the graph.
        """
        edge = self.graph.edge[self.piece]
        whole = np.bincount(edge[edge >= 0], length[self.piece][edge >= 0], count)
        own = np.where(edge >= 0, whole[edge], 0.0)
        most = np.zeros(int(self.pair.max()) + 1)
        np.maximum.at(most, self.pair, own)
        dash = (edge >= 0) & self.graph.dashed[edge]
        dashed = np.bincount(self.pair[dash], minlength=len(most)) > 0
        result: Bool = np.where(dashed[self.pair], dash, own >= 0.99 * most[self.pair])
        return result


class _Panels(NamedTuple):
    """Area, centre, bounding box and location (at the outline or not) of each of m faces."""

    area: F64  #: (m,) area of each panel
    centre: F64  #: (m, 2) mean of the contour
    box: F64  #: (m, 4) x min, y min, x max, y max
    at_rim: Bool  #: (m,) whether each panel is at the outline of a blank

    def take(self, rows: I64) -> _Panels:
        """Return the record of the faces with the indices ``rows``, in the order of ``rows``."""
        area, centre, box, at_rim = self
        return _Panels(area[rows], centre[rows], box[rows], at_rim[rows])


def _find_single_cartons(
    graph: PlanarGraph, faces: Faces, length: F64, at_rim: Bool, panel: Bool
) -> Bool:
    """Return the mask of components whose panels belong to one carton, not to several blanks, (c,).

    Equal blanks are beside each other, or head to tail: one translation, or one half-turn, maps
    every panel at the outline onto another panel.  In a single carton, the glue flap or the base
    has no such image.  Components with too few panels for a decision are not in the mask.

    Parameters
    ----------
    graph, faces
        Planar graph of the drawing, with p pieces and c components, and its f faces.
    length : (p,)
        Length of each piece, which is the part of an edge between two neighbouring vertices.
    at_rim, panel : (f,) and (f,)
        Whether each face is at the outline of a blank, and whether it is a panel.
    """
    measured = _measure_faces(graph, faces, length, at_rim)
    owner = faces.component
    chosen = np.flatnonzero(panel)
    single = np.zeros(len(faces.outer_face), np.bool_)
    order = chosen[np.argsort(owner[chosen], kind="stable")]
    bounds = np.flatnonzero(np.diff(owner[order], prepend=-1, append=-1))
    for first, last in list(pairwise(bounds.tolist()))[:_MOST_COMPONENTS]:
        rows = order[first:last]
        single[owner[rows[0]]] = not _has_repeated_blanks(measured.take(rows))
    panels = np.bincount(owner[panel], minlength=len(faces.outer_face))
    return single & (panels >= _FEWEST_PANELS)


def _measure_faces(graph: PlanarGraph, faces: Faces, length: F64, at_rim: Bool) -> _Panels:
    """Return the area, centre and bounding box of each of f faces, and whether it is at an outline.

    Parameters
    ----------
    graph, faces
        Planar graph with p pieces, which are parts of edges between neighbouring vertices, and its
        f faces.  Of coincident pieces only the first one is used.
    length : (p,)
        Length of each piece.
    at_rim : (f,)
        Whether each face is at the outline of a blank; copied to the result.
    """
    count = len(faces.area)
    own = np.flatnonzero(graph.twin_piece == np.arange(len(graph.twin_piece)))
    start, end, length = graph.vertex[graph.start[own]], graph.vertex[graph.end[own]], length[own]
    middle = 0.5 * (start + end)
    centre = np.zeros((count, 2))
    box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (count, 1))
    weight = np.zeros(count)
    for side in (faces.left[own], faces.right[own]):
        weight += np.bincount(side, length, count)
        for axis in range(2):
            centre[:, axis] += np.bincount(side, length * middle[:, axis], count)
        for point in (start, end):
            np.minimum.at(box[:, :2], side, point)
            np.maximum.at(box[:, 2:], side, point)
    centre /= np.maximum(weight, 1e-12)[:, None]
    return _Panels(faces.area, centre, box, at_rim)


def _has_repeated_blanks(panels: _Panels) -> bool:
    """Return whether the panels belong to several equal blanks.

    This is assumed if one translation or one half-turn maps all or most panels onto other panels,
    or if there are too many panels to check.
    """
    area, centre, box, at_rim = panels
    if len(area) > _MOST_PANELS:
        return True
    equal = np.abs(area[:, None] - area) <= _AREA_TOLERANCE * np.maximum(area[:, None], area)
    if equal.sum(axis=0).max() > _MOST_EQUAL:
        return True
    largest = int(area.argmax())
    tolerance = _CENTRE_TOLERANCE * math.sqrt(float(area.max()))
    sums = centre[:, None] + centre
    differences = centre - centre[:, None]
    for other in np.flatnonzero(equal[largest]).tolist():
        if other == largest:
            continue
        translation = centre[other] - centre[largest]
        mapped = equal & (np.abs(differences - translation) <= tolerance).all(axis=2)
        image, source = mapped.any(axis=0), mapped.any(axis=1)
        if (image | source)[at_rim].all():
            return True
        # Glue flaps look different where the next blank begins; other panels do not.  The front
        # and back of a single carton are equal too, but the glue flap lies beyond their images.
        if image.mean() > _REPEATED_IN_ROW and int((source & ~image).sum()) >= _FEWEST_PANELS:
            return True
        if image.mean() > _REPEATED and not image.all():
            axis = int(np.abs(translation).argmax())
            low, high = box[~image, axis].min(), box[~image, axis + 2].max()
            if high - low <= 1.002 * abs(translation[axis]):
                return True
        centre_sum = centre[other] + centre[largest]
        mapped = equal & (np.abs(sums - centre_sum) <= tolerance).all(axis=2)
        if mapped.any(axis=0)[at_rim].all() and not mapped.diagonal().any():
            return True
    return False


def _find_bridges(pair: I64, faces: int) -> Bool:
    """Return the mask of the k pairs of neighbouring faces that are bridges, (k,).

    The faces are the nodes of a graph, and each pair of neighbouring faces is an edge of that
    graph.  A pair is a bridge if its two faces would not be connected in the graph without it.
    ``pair`` (k, 2) are the two faces of each pair, and ``faces`` is the number of faces.
    """
    ends = np.concatenate([pair[:, 0], pair[:, 1]])
    order = np.argsort(ends, kind="stable")
    first = np.searchsorted(ends[order], np.arange(faces + 1))
    bridge: Bool = _mark_bridges(pair, first, order % len(pair), faces)
    return bridge


@kernel
def _mark_bridges(pair: I64_2, first: I64_1, incident: I64_1, faces: int) -> Any:
    """Return the mask of the k pairs of neighbouring faces that are bridges, (k,).

    The faces are the nodes of a graph, and each pair of neighbouring faces is an edge of that
    graph.  A pair is a bridge if its two faces would not be connected in the graph without it.  The
    bridges are found by depth-first search (Tarjan 1974).

    Parameters
    ----------
    pair : (k, 2)
        The two faces of each pair.
    first, incident : (faces + 1,) and (2k,)
        The pairs with face f are ``incident[first[f] : first[f + 1]]``.
    faces
        Number of faces.
    """
    bridge = np.zeros(len(pair), np.bool_)
    entered = np.full(faces, -1, np.int64)
    lowest = np.zeros(faces, np.int64)
    parent_pair = np.full(faces, -1, np.int64)
    position = first[:-1].copy()
    stack = np.empty(faces, np.int64)
    time = 0
    for root in range(faces):
        if entered[root] >= 0 or first[root] == first[root + 1]:
            continue
        depth = 0
        stack[0] = root
        entered[root] = lowest[root] = time
        time += 1
        while depth >= 0:
            face = stack[depth]
            if position[face] < first[face + 1]:
                k = incident[position[face]]
                position[face] += 1
                if k == parent_pair[face]:
                    continue
                other = pair[k, 1] if pair[k, 0] == face else pair[k, 0]
                if entered[other] >= 0:
                    lowest[face] = min(lowest[face], entered[other])
                    continue
                parent_pair[other] = k
                entered[other] = lowest[other] = time
                time += 1
                depth += 1
                stack[depth] = other
                continue
            depth -= 1
            if depth >= 0:
                parent = stack[depth]
                lowest[parent] = min(lowest[parent], lowest[face])
                if lowest[face] > entered[parent]:
                    bridge[parent_pair[face]] = True
    return bridge
