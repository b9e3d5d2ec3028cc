"""measures: what is measured of each connected part of a drawing.

PlanarGraph, Faces, inscriptions -> Extents, Measures
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final, NamedTuple

import numpy as np

from knifetip.classification.letters import lettering
from knifetip.classification.words import hint
from knifetip.geometry.columns import F64, I64, Bool
from knifetip.geometry.cores import each, runs
from knifetip.geometry.tolerance import GAP
from knifetip.kernels import F64_1, F64_2, I32_1, OutBool_1, OutF64_1, OutF64_2, OutI64_1, kernel
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Inscription
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: The name of a kind of line has no more letters than this.
_NAME: Final = 30
#: A slot is no wider than this, a round hole in a panel no larger (mm).
_SLOT: Final = 6.0
_ROUND: Final = 50.0
_PLAIN: Final = 8
#: More texts than this are not looked at.
_MOST: Final = 300
#: Pairs of parts and texts that one core has looked at before another has begun.
_WORTH: Final = 300_000


class Extents(NamedTuple):
    """How far c connected parts reach."""

    box: F64  #: (c, 4) x min, y min, x max, y max; of arcs their ends and their middles
    level: Bool  #: (c,) it is made of level and upright lines only

    @classmethod
    def of(cls, graph: PlanarGraph, unit: float) -> Extents:
        """Return the extents of the parts of a graph; ``unit`` as for ``Parts``."""
        count = len(graph.leftmost)
        box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (count, 1))
        level = np.ones(count, np.bool_)
        off = 2.0 * GAP * unit
        _measure(
            graph.vertex, graph.start, graph.end, graph.bulge, graph.component, off, box, level
        )
        return cls(box, level)


class Measures(NamedTuple):
    """What is measured of c connected parts."""

    area: F64  #: (c,) inside its outline
    size: F64  #: (c,) of its box, from corner to corner
    drawn: F64  #: (c,) the length of its pieces
    nowhere: F64  #: (c,) the length of those that lead nowhere
    closing: F64  #: (c,) the length of those that close its outline
    narrow: Bool  #: (c,) it is plain, and as narrow as a slot, or round
    letter: Bool  #: (c,) it stands in a row of small parts that are not alike
    holds: I64  #: (c,) how many texts stand in it
    annotated: Bool  #: (c,) a text stands in it, or beside it
    named: Bool  #: (c,) a text beside it names a kind of line

    @classmethod
    def of(
        cls,
        graph: PlanarGraph,
        sides: Faces,
        length: F64,
        box: F64,
        inscriptions: Sequence[Inscription],
        unit: float,
    ) -> Measures:
        """Return what is measured of the parts of a graph; parameters as of ``Parts``."""
        count = len(box)
        area = -sides.area[sides.outer_face]
        wide, high = box[:, 2] - box[:, 0], box[:, 3] - box[:, 1]
        size = np.sqrt(wide * wide + high * high)
        drawn, nowhere, closing = np.zeros(count), np.zeros(count), np.zeros(count)
        pieces = np.zeros(count, np.int64)
        of = graph.edge, graph.component, sides.left, sides.right, sides.outer_face
        _drawn(*of, length, drawn, nowhere, closing, pieces)
        holds, annotated = _texts(inscriptions, box)
        kinds = [text for text in inscriptions[:_MOST] if _names_a_line(text.text)]
        return cls(
            area,
            size,
            drawn,
            nowhere,
            closing,
            _narrow(area, drawn, pieces, size, unit),
            lettering(box, drawn, pieces, unit),
            holds,
            annotated,
            _texts(kinds, box)[1],
        )


@kernel(allocates=False)
def _measure(
    place: F64_2,
    start: I32_1,
    end: I32_1,
    bulge: F64_1,
    part: I32_1,
    off: float,
    box: OutF64_2,
    level: OutBool_1,
) -> None:
    """Write the box of each part, and which are level but for ``off``."""
    for p in range(len(start)):
        c, a, b = part[p], start[p], end[p]
        dx, dy = place[b, 0] - place[a, 0], place[b, 1] - place[a, 1]
        less, more = min(abs(dx), abs(dy)), max(abs(dx), abs(dy))
        if abs(bulge[p]) > 1e-6 or less > max(0.001 * more, off):
            level[c] = False
        for share in (0.0, 0.5, 1.0):
            bow = 2.0 * share * (1.0 - share) * bulge[p]
            x = place[a, 0] + share * dx + bow * dy
            y = place[a, 1] + share * dy - bow * dx
            box[c, 0] = min(box[c, 0], x)
            box[c, 1] = min(box[c, 1], y)
            box[c, 2] = max(box[c, 2], x)
            box[c, 3] = max(box[c, 3], y)


@kernel(allocates=False)
def _drawn(
    edge: I32_1, part: I32_1, left: I32_1, right: I32_1, outside: I32_1, length: F64_1,
    drawn: OutF64_1, nowhere: OutF64_1, closing: OutF64_1, pieces: OutI64_1,
) -> None:  # fmt: skip
    """Add up what is drawn of each part, what leads nowhere, and what closes its outline."""
    for p in range(len(edge)):
        c = part[p]
        drawn[c] += length[p]
        pieces[c] += 1
        if edge[p] < 0:
            continue
        out = outside[c]
        if left[p] == out and right[p] == out:
            nowhere[c] += length[p]
        elif left[p] == out or right[p] == out:
            closing[c] += length[p]


def _narrow(area: F64, drawn: F64, pieces: I64, size: F64, unit: float) -> Bool:
    """Return which closed parts are plain and as narrow as a slot, or round, (c,)."""
    across = np.maximum(drawn, 1e-12)
    round_ = (4.0 * np.pi * area > 0.98 * across * across) & (size <= _ROUND * unit * 2.0**0.5)
    narrow = (2.0 * area < _SLOT * unit * across) & (size > 2.0 * _SLOT * unit)
    result: Bool = (round_ | narrow) & (pieces <= _PLAIN)
    return result


def _names_a_line(text: str) -> bool:
    """Return whether a text is the name of a kind of line, as in a legend, and no more."""
    return len(text) <= _NAME and hint(text).kind not in (None, LineType.IGNORED)


def _placed(inscriptions: Sequence[Inscription]) -> F64:
    """Return where texts stand, how high and how wide they are, (t, 4), from left to right."""
    # Letters stand above and to the right of where a text begins.
    placed = np.array(
        [
            (text.x, text.y, text.height, 0.7 * text.height * len(text.text))
            for text in inscriptions[:_MOST]
        ]
    ).reshape(-1, 4)
    return placed[np.argsort(placed[:, 0], kind="stable")]


def _texts(inscriptions: Sequence[Inscription], box: F64) -> tuple[I64, Bool]:
    """Return how many texts stand in the box of each part, and whether one stands near, (c,)."""
    text, holds, beside = (
        _placed(inscriptions),
        np.zeros(len(box), np.int64),
        np.zeros(len(box), np.bool_),
    )

    def read(run: tuple[int, int]) -> None:
        here = slice(*run)
        _read(text, box[here], holds[here], beside[here])

    each(read, runs(len(box), _WORTH // (len(text) + 1)))
    return holds, beside


@kernel
def _read(text: F64_2, box: F64_2, holds: OutI64_1, beside: OutBool_1) -> None:
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
                holds[c] += 1
            if (
                box[c, 0] <= x + width + margin
                and x - width - margin <= box[c, 2]
                and box[c, 1] <= y + margin
                and y - margin <= box[c, 3]
            ):
                beside[c] = True
