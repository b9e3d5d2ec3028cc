"""enclosing: find components that surround blanks: frames, bleeds, outlines of whole cartons."""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.shape.measures import ComponentBoxes
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, I64_1, I64_2, OutBool_1, kernel
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph
from knifetip.topology.segment import distance_to, point_at

#: Least fraction of a frame's face that its contents cover, without and with a title block.
_MIN_COVERED: Final = 0.15
_MIN_COVERED_WITH_TITLE: Final = 0.01
#: Least and greatest distance of a bleed from its blank (mm).
_BLEED_DISTANCE: Final = (0.4, 20.0)
#: Greatest ratio of the distances of a bleed from its blank, since corners are farther away.
_MITRE_RATIO: Final = 2.2
#: Least number of panels of a carton.
_CARTON_PANELS: Final = 6
#: Largest number of components that are examined for bleeds.
_MAX_BLEEDS: Final = 300


class Enclosures(NamedTuple):
    """Masks of the components of a drawing that enclose other components, one mask for each kind.

    The kinds are frames, bleeds and outlines of whole cartons.
    """

    panels: I64  #: (c,) number of faces inside the outline
    parent: I32  #: (c,) component with a face that contains this component, -1 for none
    frame: Bool  #: (c,) whether it is a rectangle round blanks, perhaps with a title block
    bleed: Bool  #: (c,) whether it follows the outline of its contents
    carton: Bool  #: (c,) whether it encloses a whole carton, and is neither frame nor bleed

    @classmethod
    def find(
        cls, graph: PlanarGraph, faces: Faces, boxes: ComponentBoxes, unit: float
    ) -> Enclosures:
        """Return one mask of the components of a graph for each kind of enclosing component.

        The kinds are frames, bleeds and outlines of whole cartons; each encloses other components.

        Parameters
        ----------
        graph, faces, boxes
            Planar graph of a drawing, its faces, and the bounding boxes of its components.
        unit
            Number of drawing units in a millimetre.
        """
        count, owner = len(faces.outer_face), faces.component
        bounded = faces.area > unit * unit
        bounded[faces.outer_face] = False
        panels = np.bincount(owner[bounded], minlength=count)
        parent = np.where(faces.enclosing >= 0, owner[faces.enclosing], -1)
        bounded_area = np.asarray(
            np.bincount(owner[bounded], faces.area[bounded], count), np.float64
        )
        frame = _find_frames(faces, boxes, parent, panels, bounded_area)
        bleed = _find_bleeds(graph, boxes.box, parent, frame, panels, unit)
        carton = np.zeros(count, np.bool_)
        carton[parent[(parent >= 0) & (panels >= _CARTON_PANELS)]] = True
        carton &= (panels == 1) & ~frame & ~bleed
        carton &= (parent < 0) | (frame | bleed)[parent]
        return cls(panels, parent, frame, bleed, carton)


def _find_frames(
    faces: Faces, boxes: ComponentBoxes, parent: I32, panels: I64, bounded_area: F64
) -> Bool:
    """Return the mask of components that are rectangular frames round blanks, (c,).

    A frame may also contain a title block.

    ``faces``, ``boxes``: faces of the planar graph, and bounding boxes of its c components.
    ``parent`` (c,): index of the innermost component around each component, -1 for none.
    ``panels`` (c,): number of faces inside the outline of each component.
    ``bounded_area`` (c,): sum of the areas of the bounded faces of each component.
    """
    box, rectilinear = boxes
    count, owner = len(box), faces.component
    plain = rectilinear & (panels == 1)
    frame = np.zeros(count, np.bool_)
    box_area = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    while True:
        # A plain rectangle round a plain shape is no frame: it may be a blank with a hole.
        contents = np.flatnonzero((parent >= 0) & ((panels >= 2) | frame) & ~frame[parent])
        covered = np.bincount(faces.enclosing[contents], box_area[contents], len(faces.area))
        found = False
        for face in np.flatnonzero(covered).tolist():
            c = int(owner[face])
            other_faces = float(bounded_area[c]) - float(faces.area[face])
            # A frame with a title block may be far larger than its contents.
            least = _MIN_COVERED_WITH_TITLE if panels[c] >= 2 else _MIN_COVERED
            if (
                rectilinear[c]
                and faces.area[face] >= 0.6 * box_area[c]
                and other_faces <= 0.3 * faces.area[face]
                and covered[face] >= least * faces.area[face]
                and (parent[c] < 0 or frame[parent[c]] or plain[parent[c]])
            ):
                frame[c] = found = True
        # A frame around a frame is the outer line of a double frame.
        for c in np.flatnonzero(frame).tolist():
            if parent[c] >= 0 and not frame[parent[c]] and plain[parent[c]]:
                frame[parent[c]] = found = True
        if not found:
            return frame


def _find_bleeds(
    graph: PlanarGraph, box: F64, parent: I32, frame: Bool, panels: I64, unit: float
) -> Bool:
    """Return the mask of components that follow the outline of a blank inside them, (c,).

    The blank must have several panels, because a ring inside a ring may be a gasket.

    ``graph``: planar graph of the drawing, with c components.
    ``box`` (c, 4): bounding box of each component: x min, y min, x max, y max.
    ``parent`` (c,): index of the innermost component around each component, -1 for none.
    ``frame`` (c,): whether each component is a frame.
    ``panels`` (c,): number of faces inside the outline of each component.
    ``unit``: number of drawing units in a millimetre.
    """
    count = len(parent)
    bleed = np.zeros(count, np.bool_)
    inner = np.flatnonzero((parent >= 0) & (panels >= 2))
    inner = inner[np.argsort(parent[inner], kind="stable")]
    outer_of_inner = parent[inner]
    if len(inner) == 0:
        return bleed
    outer, begins = np.unique(outer_of_inner, return_index=True)
    # The boxes of a blank and its bleed differ by little on each side.
    nearest, farthest = _BLEED_DISTANCE[0] * unit, _BLEED_DISTANCE[1] * unit
    margin = np.hstack(
        [
            np.abs(np.minimum.reduceat(box[inner, :2], begins) - box[outer, :2]),
            np.abs(np.maximum.reduceat(box[inner, 2:], begins) - box[outer, 2:]),
        ]
    )
    fits = (margin.min(axis=1) >= nearest) & (margin.max(axis=1) <= farthest)
    outer = outer[fits & (panels[outer] == 1) & ~frame[outer]]
    if len(outer) == 0:
        return bleed
    pieces = _pieces_by_component(graph.component, count)
    order = np.argsort(-np.diff(pieces.first)[outer], kind="stable")
    outer = outer[order[:_MAX_BLEEDS]]
    contents = np.column_stack(
        [
            np.searchsorted(outer_of_inner, outer),
            np.searchsorted(outer_of_inner, outer, side="right"),
        ]
    )
    lines = _Lines(graph.vertex, graph.start, graph.end, graph.bulge)
    _mark_bleeds(lines, pieces, outer.astype(np.int64), contents, inner, nearest, bleed)
    return bleed


class _Lines(NamedTuple):
    """A planar graph of q vertices and p pieces, reduced to the arrays that the bleed search needs.

    A piece is the part of an edge between two neighbouring vertices.
    """

    vertex: F64_2  #: (q, 2) position of each vertex
    start: I32_1  #: (p,) vertex at which each piece starts
    end: I32_1  #: (p,) vertex at which each piece ends
    bulge: F64_1  #: (p,) tan(sweep / 4) of each piece


class _ComponentPieces(NamedTuple):
    """For each connected component of a planar graph, the list of its pieces.

    A piece is the part of an edge between two neighbouring vertices.  The indices of the pieces of
    component c are ``piece[first[c] : first[c + 1]]``.
    """

    piece: I32_1  #: (p,) pieces sorted by component
    first: I64_1  #: (c + 1,) index of the first piece of each component


@kernel
def _pieces_by_component(component: I32_1, count: int) -> _ComponentPieces:
    """Return for each of ``count`` connected components of a planar graph the list of its pieces.

    A piece is the part of an edge between two neighbouring vertices.  ``component`` (p,) is the
    index of the component of each piece.
    """
    first = np.zeros(count + 1, np.int64)
    for p in range(len(component)):
        first[component[p] + 1] += 1
    first = np.cumsum(first)
    position = first[:-1].copy()
    order = np.empty(len(component), np.int32)
    for p in range(len(component)):
        order[position[component[p]]] = p
        position[component[p]] += 1
    return _ComponentPieces(order, first)


@kernel
def _mark_bleeds(
    lines: _Lines,
    pieces: _ComponentPieces,
    outer: I64_1,
    contents: I64_2,
    inner: I64_1,
    nearest: float,
    bleed: OutBool_1,
) -> None:
    """Write to ``bleed`` whether components follow the outlines of the components inside them.

    ``lines``: the planar graph of the drawing.
    ``pieces``: for each component of the graph, the pieces of edges that it consists of.
    ``outer`` (k,): indices of the components to check.
    ``contents`` (k, 2): index in ``inner`` of the first component inside each component to check,
    and the index after the last one.
    ``inner``: indices of the components inside the components ``outer``, sorted by the component
    around them.
    ``nearest``: least distance between a bleed and a component inside it (drawing units).
    ``bleed`` (c,): mask of all components of the graph; the entries of the components ``outer`` are
    written.
    """
    for k in range(len(outer)):
        ends, bulge = _segments_of(lines, pieces, outer[k : k + 1])
        other_ends, other_bulge = _segments_of(
            lines, pieces, inner[contents[k, 0] : contents[k, 1]]
        )
        least, most = _distance_range(ends, bulge, other_ends, other_bulge)
        bleed[outer[k]] = nearest <= least and most <= _MITRE_RATIO * least


@kernel
def _segments_of(lines: _Lines, pieces: _ComponentPieces, components: I64_1) -> Any:
    """Return the end points, (m, 2, 2), and the bulges, (m,), of all pieces of some components.

    A piece is the part of an edge between two neighbouring vertices of the planar graph ``lines``.
    ``pieces`` lists the pieces of each component, and ``components`` are the indices of the
    components.
    """
    vertex, start, end, bulge = lines
    count = 0
    for c in components:
        count += pieces.first[c + 1] - pieces.first[c]
    ends, bulges = np.empty((count, 2, 2)), np.empty(count)
    row = 0
    for c in components:
        for k in range(pieces.first[c], pieces.first[c + 1]):
            p = pieces.piece[k]
            for axis in range(2):
                ends[row, 0, axis] = vertex[start[p], axis]
                ends[row, 1, axis] = vertex[end[p], axis]
            bulges[row] = bulge[p]
            row += 1
    return ends, bulges


@kernel(allocates=False)
def _distance_range(
    ends: F64_3, bulge: F64_1, other_ends: F64_3, other_bulge: F64_1
) -> tuple[float, float]:
    """Return the least and the greatest distance of points of some segments from other segments.

    The points are the start and the middle of each segment; the distance of a point is measured to
    the nearest of the other segments.

    ``ends``, ``bulge`` (m, 2, 2) and (m,): start and end points and bulges of the segments.
    ``other_ends``, ``other_bulge`` (k, 2, 2) and (k,): start and end points and bulges of the other
    segments.
    """
    least, most = np.inf, 0.0
    for p in range(len(bulge)):
        for fraction in (0.0, 0.5):
            x, y = point_at(ends, bulge, p, fraction)
            best = np.inf
            for q in range(len(other_bulge)):
                best = min(best, distance_to(other_ends, other_bulge, q, x, y, best)[0])
            least, most = min(least, best), max(most, best)
    return least, most
