"""part_kinds: find what each component of a drawing is: a blank, a frame, a letter, a mark.

A component inside no other component is a blank.  A rectangle round blanks is a frame, and a
contour that follows a blank at a constant distance is its bleed.  A grid of boxes with texts is a
title block, and small shapes in a row are letters.  An outline with many dangling edges has a gap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.classification.shape.enclosing import Enclosures
from knifetip.classification.shape.measures import ComponentBoxes, Measures
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.parallel import chunks, parallel_map, parallel_pair
from knifetip.kernels import F64_1, F64_2, I64_1, OutF64_1, kernel
from knifetip.model.drawing import Annotation
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: A component below this fraction of the largest component's area is a mark or a letter.
_SMALL_SHARE: Final = 0.004
#: An outline has a gap if its dangling edges exceed this fraction of its length.
_MAX_DANGLING: Final = 0.1
#: Greatest size of debris (mm).
_DEBRIS_SIZE: Final = 30.0
#: Largest number of open components that are examined for what they enclose.
_MAX_OPEN: Final = 300
#: Fewest pairs of components in a chunk for one core.
_MIN_PAIRS: Final = 300_000


@dataclass(frozen=True, eq=False, slots=True)
class PartKinds:
    """The kinds of c connected components, as one mask for each kind, such as frame or letter.

    A component may be of several kinds; a blank is of none.  A further mask states which components
    are near a text.
    """

    inside: Bool  #: (c,) inside a face of a blank
    frame: Bool  #: (c,) a rectangle round blanks
    table: Bool  #: (c,) a title block
    labelled: Bool  #: (c,) a closed shape with a text in or beside it: a label, or a small part
    small: Bool  #: (c,) a mark, too small for a blank
    doubtful: Bool  #: (c,) an outline that does not close
    near_text: Bool  #: (c,) with a text in or beside its bounding box
    bleed: Bool  #: (c,) a contour that follows the outline of its contents
    letter: Bool  #: (c,) a letter of a text that was converted to lines
    debris: Bool  #: (c,) short lines that enclose nothing, outside all other components
    flat: Bool  #: (c,) lines that enclose no area
    slot: Bool  #: (c,) an empty slot or round hole in a panel
    legend: Bool  #: (c,) a sample line beside the name of a line type
    enclosing: Bool  #: (c,) a contour round a whole carton that is neither frame nor bleed

    @classmethod
    def find(
        cls,
        graph: PlanarGraph,
        faces: Faces,
        length: F64,
        boxes: ComponentBoxes,
        annotations: Sequence[Annotation],
        unit: float,
    ) -> PartKinds:
        """Return the kinds of the components of a graph; parameters as in ``Measures.measure``."""
        enclosures, measures = parallel_pair(
            lambda: Enclosures.find(graph, faces, boxes, unit),
            lambda: Measures.measure(graph, faces, length, boxes.box, annotations, unit),
        )
        panels, parent = enclosures.panels, enclosures.parent
        area, size, tiny = measures.area, measures.size, unit * unit
        surrounding = enclosures.frame | enclosures.bleed | enclosures.carton
        inside = (parent >= 0) & ~surrounding[parent]
        separate = ~inside & ~surrounding
        largest = area[separate].max(initial=0.0)
        table = separate & boxes.rectilinear & (area < 0.25 * largest)
        table &= (panels >= 2) & (measures.texts >= np.maximum(1, 0.4 * panels))
        labelled = separate & measures.near_text & (area > tiny) & (area < 0.25 * largest)
        labelled &= ~table
        small = separate & ~table & ~labelled & (area > 0.0)
        small &= area < max(_SMALL_SHARE * largest, 4.0 * tiny)
        debris = separate & (area <= tiny) & (size <= _DEBRIS_SIZE * unit)
        closed_length = measures.length[separate & (area > tiny)].sum()
        if measures.length[debris].sum() > 0.25 * closed_length:
            # So many open lines may be the rest of a carton.
            debris[:] = False
        # A registration mark: a cross in a ring.
        debris |= (
            separate & (panels >= 2) & (size <= 0.5 * _DEBRIS_SIZE * unit) & (area < 0.05 * largest)
        )
        legend = separate & (area <= tiny) & (size <= 2.0 * _DEBRIS_SIZE * unit)
        empty = np.bincount(parent[parent >= 0], minlength=len(area)) == 0
        outlines = separate & ~table & ~labelled & ~measures.is_letter
        return cls(
            inside=inside,
            frame=enclosures.frame,
            table=table,
            labelled=labelled,
            small=small,
            doubtful=_find_doubtful(measures, boxes.box, outlines, small, tiny),
            near_text=measures.near_text,
            bleed=enclosures.bleed,
            letter=measures.is_letter,
            debris=debris,
            flat=separate & (area <= tiny),
            slot=inside & (panels == 1) & empty & measures.is_slot,
            legend=legend & measures.near_type_name,
            enclosing=enclosures.carton,
        )


def _find_doubtful(measures: Measures, box: F64, outlines: Bool, small: Bool, tiny: float) -> Bool:
    """Return the mask of large components with too many dangling edges for a closed outline, (c,).

    If the bounding box of an open component covers most of that of a large component, the dangling
    edges of both are added, because the open component may be a part of the same outline.

    ``measures``: measures of the c components.
    ``box`` (c, 4): bounding box of each component.
    ``outlines`` (c,): mask of components that may be a blank or a part of the outline of a blank.
    ``small`` (c,): mask of small components; they are not in the result.
    ``tiny``: the area of a square millimetre, in square drawing units.
    """
    blank = outlines & ~small & (measures.area > tiny)
    dangling = np.where(blank, measures.dangling, 0.0)
    # An open component round a closed one is the rest of its outline.
    box_area = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    is_open = outlines & (measures.dangling > 0.5 * measures.outline) & (box_area > tiny)
    rows = np.flatnonzero(is_open)
    rows = rows[np.argsort(-box_area[rows], kind="stable")[:_MAX_OPEN]]
    open_box, open_dangling = box[rows], measures.dangling[rows]
    blanks = np.flatnonzero(blank)

    def add(chunk: tuple[int, int]) -> None:
        _add_open_outlines(
            rows, open_box, open_dangling, box, box_area, blanks[slice(*chunk)], dangling
        )

    parallel_map(add, chunks(len(blanks), _MIN_PAIRS // (len(rows) + 1)))
    return blank & (dangling > _MAX_DANGLING * measures.outline)


@kernel(allocates=False)
def _add_open_outlines(
    open_row: I64_1,
    open_box: F64_2,
    open_dangling: F64_1,
    box: F64_2,
    box_area: F64_1,
    blank: I64_1,
    dangling: OutF64_1,
) -> None:
    """Add the dangling length of open components to the blanks that they surround.

    An open component surrounds a blank if its bounding box covers more than half of the bounding
    box of the blank.

    ``open_row``, ``open_box``, ``open_dangling`` (k,), (k, 4) and (k,): indices of the open
    components, their bounding boxes, and the lengths of their dangling edges.
    ``box``, ``box_area`` (c, 4) and (c,): bounding box of each component, and its area.
    ``blank`` (b,): indices of the components that are blanks.
    ``dangling`` (c,): dangling length of each component; the entries of blanks are increased.
    """
    for m in range(len(blank)):
        b = blank[m]
        left, low, right, high = box[b, 0], box[b, 1], box[b, 2], box[b, 3]
        most = 0.5 * box_area[b]
        for k in range(len(open_row)):
            width = min(right, open_box[k, 2]) - max(left, open_box[k, 0])
            height = min(high, open_box[k, 3]) - max(low, open_box[k, 1])
            if width * height > most and width > 0.0 and open_row[k] != b:
                dangling[b] += open_dangling[k]
