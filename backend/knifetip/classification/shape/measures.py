"""measures: measure boxes, areas, lengths and nearby texts of the components of a drawing."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.shape.lettering import find_letters
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.parallel import chunks, parallel_map
from knifetip.geometry.tolerance import GAP
from knifetip.kernels import F64_1, F64_2, I32_1, OutBool_1, OutF64_1, OutF64_2, OutI64_1, kernel
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Annotation
from knifetip.topology.faces import Faces, PieceSides, piece_sides
from knifetip.topology.planar_graph import PlanarGraph
from knifetip.vocabulary import name_meaning

#: Greatest number of letters in the name of a line type in a legend.
_MAX_NAME: Final = 30
#: Greatest width of a slot, and greatest diameter of a round hole, in a panel (mm).
_SLOT_WIDTH: Final = 6.0
_HOLE_DIAMETER: Final = 50.0
#: Greatest number of pieces of a slot or a round hole.
_MAX_PIECES: Final = 8
#: Largest number of texts that are compared with components.
_MAX_TEXTS: Final = 300
#: Fewest pairs of components and texts in a chunk for one core.
_MIN_PAIRS: Final = 300_000


class ComponentBoxes(NamedTuple):
    """Bounding boxes of c connected components, and whether each component is rectilinear.

    A rectilinear component consists of horizontal and vertical lines.
    """

    box: F64  #: (c, 4) x min, y min, x max, y max; of arcs only their ends and middles count
    rectilinear: Bool  #: (c,) whether all pieces are horizontal or vertical lines

    @classmethod
    def measure(cls, graph: PlanarGraph, unit: float) -> ComponentBoxes:
        """Return the bounding boxes of a graph's components; ``unit`` is drawing units per mm."""
        count = len(graph.leftmost)
        box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (count, 1))
        rectilinear = np.ones(count, np.bool_)
        tolerance = 2.0 * GAP * unit
        _measure_boxes(
            graph.vertex,
            graph.start,
            graph.end,
            graph.bulge,
            graph.component,
            tolerance,
            box,
            rectilinear,
        )
        return cls(box, rectilinear)


class Measures(NamedTuple):
    """Areas, lengths, nearby texts and other measures of c components, in drawing units."""

    area: F64  #: (c,) area inside the outline
    size: F64  #: (c,) diagonal of the bounding box
    length: F64  #: (c,) length of all pieces
    dangling: F64  #: (c,) length of the pieces that have the outside on both sides
    outline: F64  #: (c,) length of the pieces that have the outside on one side
    is_slot: Bool  #: (c,) whether it has the shape of a slot or a round hole
    is_letter: Bool  #: (c,) whether it is a letter, by its neighbours
    texts: I64  #: (c,) number of texts in the bounding box
    near_text: Bool  #: (c,) whether a text is in the bounding box or beside it
    near_type_name: Bool  #: (c,) whether a text beside it names a line type

    @classmethod
    def measure(
        cls,
        graph: PlanarGraph,
        faces: Faces,
        length: F64,
        box: F64,
        annotations: Sequence[Annotation],
        unit: float,
    ) -> Measures:
        """Return areas, lengths, nearby texts and other measures of a graph's components.

        A piece is the part of an edge between two neighbouring vertices of the graph.

        Parameters
        ----------
        graph, faces
            Planar graph of a drawing, with p pieces and c components, and its faces.
        length : (p,)
            Length of each piece.
        box : (c, 4)
            Bounding box of each component.
        annotations
            Texts and dimensions of the drawing.
        unit
            Number of drawing units in a millimetre.
        """
        count = len(box)
        area = -faces.area[faces.outer_face]
        width, height = box[:, 2] - box[:, 0], box[:, 3] - box[:, 1]
        size = np.sqrt(width * width + height * height)
        total, dangling, outline = np.zeros(count), np.zeros(count), np.zeros(count)
        pieces = np.zeros(count, np.int64)
        sides = piece_sides(graph, faces)
        _add_lengths(graph.edge, sides, length, total, dangling, outline, pieces)
        texts, near_text = _locate_texts(annotations, box)
        type_names = [text for text in annotations[:_MAX_TEXTS] if _is_type_name(text.text)]
        return cls(
            area,
            size,
            total,
            dangling,
            outline,
            _has_slot_shape(area, total, pieces, size, unit),
            find_letters(box, total, pieces, unit),
            texts,
            near_text,
            _locate_texts(type_names, box)[1],
        )


@kernel(allocates=False)
def _measure_boxes(
    vertex: F64_2,
    start: I32_1,
    end: I32_1,
    bulge: F64_1,
    component: I32_1,
    tolerance: float,
    box: OutF64_2,
    rectilinear: OutBool_1,
) -> None:
    """Write the bounding box of each of c components, and whether the component is rectilinear.

    A component is rectilinear if it has only lines that are horizontal or vertical within
    ``tolerance``.

    ``vertex`` (q, 2): position of each vertex.
    ``start``, ``end``, ``bulge``, ``component`` (p,): start vertex, end vertex, bulge and component
    of each piece of an edge.
    ``box`` (c, 4): gets x min, y min, x max, y max of each component.
    ``rectilinear`` (c,): set to False for components that are not rectilinear.
    """
    for p in range(len(start)):
        c, a, b = component[p], start[p], end[p]
        dx, dy = vertex[b, 0] - vertex[a, 0], vertex[b, 1] - vertex[a, 1]
        shorter, longer = min(abs(dx), abs(dy)), max(abs(dx), abs(dy))
        if abs(bulge[p]) > 1e-6 or shorter > max(0.001 * longer, tolerance):
            rectilinear[c] = False
        for fraction in (0.0, 0.5, 1.0):
            sagitta = 2.0 * fraction * (1.0 - fraction) * bulge[p]
            x = vertex[a, 0] + fraction * dx + sagitta * dy
            y = vertex[a, 1] + fraction * dy - sagitta * dx
            box[c, 0] = min(box[c, 0], x)
            box[c, 1] = min(box[c, 1], y)
            box[c, 2] = max(box[c, 2], x)
            box[c, 3] = max(box[c, 3], y)


@kernel(allocates=False)
def _add_lengths(
    edge: I32_1,
    sides: PieceSides,
    length: F64_1,
    total: OutF64_1,
    dangling: OutF64_1,
    outline: OutF64_1,
    pieces: OutI64_1,
) -> None:
    """Add the lengths and the number of p pieces to the totals of their c components.

    A piece is the part of an edge between two neighbouring vertices of a planar graph; a component
    is a set of connected pieces.

    ``edge``, ``length`` (p,): edge and length of each piece.
    ``total`` (c,): total length of all pieces of each component; increased.
    ``dangling`` (c,): total length of the pieces with the outer face on both sides; increased.
    ``outline`` (c,): total length of the pieces with the outer face on one side; increased.
    ``pieces`` (c,): number of pieces of each component; increased.
    """
    component, left, right, outer_face = sides
    for p in range(len(edge)):
        c = component[p]
        total[c] += length[p]
        pieces[c] += 1
        if edge[p] < 0:
            continue
        outside = outer_face[c]
        if left[p] == outside and right[p] == outside:
            dangling[c] += length[p]
        elif left[p] == outside or right[p] == outside:
            outline[c] += length[p]


def _has_slot_shape(area: F64, perimeter: F64, pieces: I64, size: F64, unit: float) -> Bool:
    """Return the mask of components that are narrow, or round like a hole, and of few pieces, (c,).

    A piece is the part of an edge between two neighbouring vertices of the planar graph.

    ``area`` (c,): area inside the outline of each component.
    ``perimeter`` (c,): total length of the pieces of each component.
    ``pieces`` (c,): number of pieces of each component.
    ``size`` (c,): diagonal of the bounding box of each component.
    ``unit``: number of drawing units in a millimetre.
    """
    length = np.maximum(perimeter, 1e-12)
    is_round = 4.0 * np.pi * area > 0.98 * length * length
    is_round &= size <= _HOLE_DIAMETER * unit * 2.0**0.5
    narrow = (2.0 * area < _SLOT_WIDTH * unit * length) & (size > 2.0 * _SLOT_WIDTH * unit)
    result: Bool = (is_round | narrow) & (pieces <= _MAX_PIECES)
    return result


def _is_type_name(text: str) -> bool:
    """Return whether a text consists of the name of a line type, as in a legend."""
    return len(text) <= _MAX_NAME and name_meaning(text).kind not in (None, LineType.IGNORED)


def _text_positions(annotations: Sequence[Annotation]) -> F64:
    """Return the position and the size of each text, (t, 4), sorted by x.

    The columns are x and y of the lower left corner, height and width.
    """
    # The insertion point of a text is its lower left corner; a letter's width is 0.7 of its height.
    positions = np.array(
        [
            (text.x, text.y, text.height, 0.7 * text.height * len(text.text))
            for text in annotations[:_MAX_TEXTS]
        ]
    ).reshape(-1, 4)
    return positions[np.argsort(positions[:, 0], kind="stable")]


def _locate_texts(annotations: Sequence[Annotation], box: F64) -> tuple[I64, Bool]:
    """Return how many texts are in each of c boxes, (c,), and whether one is in or beside it, (c,).

    ``box`` (c, 4) are the boxes, and ``annotations`` are the texts and dimensions of the drawing.
    """
    positions = _text_positions(annotations)
    inside, near_text = np.zeros(len(box), np.int64), np.zeros(len(box), np.bool_)

    def locate(chunk: tuple[int, int]) -> None:
        rows = slice(*chunk)
        _count_texts(positions, box[rows], inside[rows], near_text[rows])

    parallel_map(locate, chunks(len(box), _MIN_PAIRS // (len(positions) + 1)))
    return inside, near_text


@kernel
def _count_texts(text: F64_2, box: F64_2, inside: OutI64_1, near_text: OutBool_1) -> None:
    """Count the texts in each box, and mark the boxes with a text in or beside them.

    ``text`` (t, 4): x, y, height and width of each text, sorted by x.
    ``box`` (c, 4): x min, y min, x max, y max of each box.
    ``inside``, ``near_text`` (c,) and (c,): receive the number of texts in each box, and whether a
    text is in or beside it.
    """
    widest, lowest, highest = 0.0, np.inf, -np.inf
    for t in range(len(text)):
        widest = max(widest, text[t, 3] + 2.0 * text[t, 2])
        lowest = min(lowest, text[t, 1] - 2.0 * abs(text[t, 2]))
        highest = max(highest, text[t, 1] + 2.0 * abs(text[t, 2]))
    for c in range(len(box)):
        if not (box[c, 1] <= highest and lowest <= box[c, 3]):
            continue
        for t in range(np.searchsorted(text[:, 0], box[c, 0] - widest), len(text)):
            x, y, height, width = text[t]
            if x - widest > box[c, 2]:
                break
            margin = 2.0 * height
            if box[c, 0] <= x <= box[c, 2] and box[c, 1] <= y <= box[c, 3]:
                inside[c] += 1
            if (
                box[c, 0] <= x + width + margin
                and x - width - margin <= box[c, 2]
                and box[c, 1] <= y + margin
                and y - margin <= box[c, 3]
            ):
                near_text[c] = True
