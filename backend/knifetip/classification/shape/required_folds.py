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
from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.shape.face_pairs import face_pairs, find_bridges
from knifetip.classification.shape.panels import Panels, measure_faces
from knifetip.classification.shape.roles import HOLES, Role
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.topology.connected_faces import label_connected_faces
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
#: A line inside a blank is a fold if it is at least this fraction of the width of both panels.
_MIN_HINGE: Final = 0.25
#: A blank with more panels than this counts as several ones.
_MOST_PANELS: Final = 64
#: Largest number of blanks that are examined.
_MOST_BLANKS: Final = 200


def find_required_folds(
    graph: PlanarGraph,
    faces: Faces,
    role: U8,
    is_slot: Bool,
    length: F64,
    count: int,
    blanks: I32,
) -> Bool:
    """Return the mask of edges that must be folds, because a panel is attached by them alone, (n,).

    A piece is the part of an edge between two neighbouring vertices of the graph.

    Parameters
    ----------
    graph, faces
        Planar graph of the edges, with p pieces, and its faces.
    role, length : (p,)
        Role and length of each piece of the graph.
    is_slot : (f,)
        Whether each face is a slot at a fold, which is no panel.
    count
        Number of edges, n.
    blanks : (c,)
        Number of equal blanks that each component consists of.
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
    panel = _find_panels(graph, faces, divider, at_rim, (degree == 2) & bent) & ~is_slot
    around = _faces_around_slots(faces, role, is_slot)
    left, right = around[faces.left[divider]], around[faces.right[divider]]
    pair, number = face_pairs(left, right)
    borders = _Borders(graph, divider, number, len(pair))
    straight = borders.straight()
    inner = straight & borders.between_inner_corners(vertex_on_rim, degree)
    panel_width = np.sqrt(np.maximum(faces.area[pair].min(axis=1), 0.0))
    inner &= np.bincount(number, length[divider], len(pair)) >= _MIN_HINGE * panel_width
    bridge = find_bridges(pair, len(faces.area)) & straight
    chosen = (bridge | inner)[number] & borders.longest(length, count)
    blank: I64 = faces.component.astype(np.int64)
    if (blanks > 1).any():
        # The numbers of the groups of panels are unlike those of components.
        group = label_connected_faces(len(faces.area), np.column_stack([left, right]))
        blank = np.where(blanks[blank] > 1, len(blanks) + group, blank)
        blank = np.unique(blank, return_inverse=True)[1]
    carton = _find_single_cartons(measure_faces(graph, faces, length, at_rim), panel, blank)
    # Maps and floor plans have faces and dividers too, but few straight ones.
    total = np.bincount(blank[left], length[divider], len(blank))
    straight_length = np.bincount(blank[left], length[divider] * straight[number], len(blank))
    carton &= straight_length >= _STRAIGHT_FRACTION * total
    required = panel[left] & panel[right] & chosen & carton[blank[left]]
    edge = graph.edge[divider]
    real = edge >= 0
    # A fold may be drawn along the sides of slots that lie at it.
    folded = real & ~(is_slot[faces.left[divider]] | is_slot[faces.right[divider]])
    whole = np.bincount(edge[folded], length[divider][folded], count)
    part = np.bincount(edge[real & required], length[divider][real & required], count)
    return (part > 0.9 * whole) & (whole > 0.0)


def _faces_around_slots(faces: Faces, role: U8, is_slot: Bool) -> I32:
    """Return for each face the face itself, and for a slot at a fold the panel beside it, (f,)."""
    around = np.arange(len(faces.area), dtype=np.int32)
    if is_slot.any():
        side = np.flatnonzero(role == Role.SLOT)
        for slot, panel in ((faces.left, faces.right), (faces.right, faces.left)):
            rows = side[is_slot[slot[side]] & ~is_slot[panel[side]]]
            around[slot[rows]] = panel[rows]
    return around


def _find_panels(graph: PlanarGraph, faces: Faces, divider: I64, at_rim: Bool, bend: Bool) -> Bool:
    """Return the mask of faces that are panels, (f,).

    A bounded face inside a blank, away from its outline, is no panel if its boundary has a bend.
    Such a face is, for example, a tab or a window inside a panel.

    ``graph``, ``faces``: planar graph with q vertices, and its f faces.
    ``divider`` (d,): indices of the pieces of edges between two faces of a blank; a bend is looked
    for at their ends.
    ``at_rim`` (f,): whether each face is at the outline of a blank.
    ``bend`` (q,): whether each vertex is a bend: exactly two pieces meet there, at an angle.
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

        ``on_rim`` (q,): whether each vertex is on the rim.
        ``degree`` (q,): number of pieces of edges that meet at each vertex.
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

        ``length`` (p,): length of each piece of the whole graph.
        ``count``: number of edges of the graph.
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


def _find_single_cartons(faces: Panels, panel: Bool, blank: I64) -> Bool:
    """Return the mask of blanks whose panels belong to one carton, not to several blanks, (f,).

    Equal blanks are beside each other, or head to tail: one translation, or one half-turn, maps
    every panel at the outline onto another panel.  In a single carton, the glue flap or the base
    has no such image.  Blanks with too few panels for a decision are not in the mask.

    ``faces``: measures of the f faces.
    ``panel``, ``blank`` (f,) and (f,): whether each face is a panel, and the number of the blank
    that it belongs to, 0 … f - 1.
    """
    chosen = np.flatnonzero(panel)
    single = np.zeros(len(panel), np.bool_)
    order = chosen[np.argsort(blank[chosen], kind="stable")]
    bounds = np.flatnonzero(np.diff(blank[order], prepend=-1, append=-1))
    ranges = [one for one in pairwise(bounds.tolist()) if one[1] - one[0] >= _FEWEST_PANELS]
    for first, last in ranges[:_MOST_BLANKS]:
        rows = order[first:last]
        single[blank[rows[0]]] = not _has_repeated_blanks(faces.take(rows))
    return single


def _has_repeated_blanks(panels: Panels) -> bool:
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
