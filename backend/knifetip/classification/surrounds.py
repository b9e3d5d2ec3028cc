"""surrounds: what lies round blanks and is none: frames, bleeds, lines round whole cartons.

PlanarGraph, Faces, Extents -> Surrounds
"""

from __future__ import annotations

from typing import Any, Final, NamedTuple

import numpy as np

from knifetip.classification.measures import Extents
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.kernels import F64_1, F64_2, F64_3, I32_1, I64_1, I64_2, OutBool_1, kernel
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph
from knifetip.topology.segment import distance_to, point_at

#: A frame without a title block holds at least this share of its face, one with it this.
_HELD: Final = 0.15
_HELD_BESIDE_TITLE: Final = 0.01
#: A bleed is so far from its blank (mm), and its corners at most so many times as far.
_BLEED: Final = (0.4, 20.0)
_MITRE: Final = 2.2
#: A part of so many panels is a carton.
_CARTON: Final = 6
#: Of more parts than this bleeds are not looked for.
_MOST: Final = 300


class Surrounds(NamedTuple):
    """Which of c connected parts lie round others, and how many panels each has."""

    many: I64  #: (c,) faces inside its outline
    parent: I32  #: (c,) the part that it lies in, -1 for none
    frame: Bool  #: (c,)
    bleed: Bool  #: (c,) it follows the outline of what lies in it
    around: Bool  #: (c,) a whole carton lies in it, and it is neither frame nor bleed

    @classmethod
    def of(cls, graph: PlanarGraph, sides: Faces, extents: Extents, unit: float) -> Surrounds:
        """Return what lies round what; ``unit`` as for ``Parts``."""
        count, owner = len(sides.outer_face), sides.component
        bounded = sides.area > unit * unit
        bounded[sides.outer_face] = False
        many = np.bincount(owner[bounded], minlength=count)
        parent = np.where(sides.enclosing >= 0, owner[sides.enclosing], -1)
        box, level = extents
        frame = _frames(sides, parent, many, level, box, owner, bounded)
        bleed = _bleeds(graph, parent, frame, many, box, unit)
        around = np.zeros(count, np.bool_)
        around[parent[(parent >= 0) & (many >= _CARTON)]] = True
        around &= (many == 1) & ~frame & ~bleed
        around &= (parent < 0) | (frame | bleed)[parent]
        return cls(many, parent, frame, bleed, around)


def _frames(
    sides: Faces,
    parent: I32,
    many: I64,
    level: Bool,
    box: F64,
    owner: I32,
    bounded: Bool,
) -> Bool:
    """Return which parts are rectangles, perhaps with a title block, round blanks, (c,)."""
    count = len(box)
    frame = np.zeros(count, np.bool_)
    size = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    enclosed = np.bincount(owner[bounded], sides.area[bounded], count)
    while True:
        # A plain rectangle round a plain shape may be a blank with a hole, and is no frame.
        told = np.flatnonzero((parent >= 0) & ((many >= 2) | frame) & ~frame[parent])
        held = np.bincount(sides.enclosing[told], size[told], len(sides.area))
        found = False
        for face in np.flatnonzero(held).tolist():
            c = int(owner[face])
            around = float(enclosed[c]) - float(sides.area[face])
            # A frame with a title block may be far too large for what is in it.
            least = _HELD_BESIDE_TITLE if many[c] >= 2 else _HELD
            if (
                level[c]
                and sides.area[face] >= 0.6 * size[c]
                and around <= 0.3 * sides.area[face]
                and held[face] >= least * sides.area[face]
                and (parent[c] < 0 or frame[parent[c]] or _plain(int(parent[c]), level, many))
            ):
                frame[c] = found = True
        # A second line round the first.
        for c in np.flatnonzero(frame).tolist():
            if parent[c] >= 0 and not frame[parent[c]] and _plain(int(parent[c]), level, many):
                frame[parent[c]] = found = True
        if not found:
            return frame


def _plain(part: int, level: Bool, many: I64) -> bool:
    """Return whether a part is level lines round one face."""
    return bool(level[part]) and int(many[part]) == 1


def _bleeds(graph: PlanarGraph, parent: I32, frame: Bool, many: I64, box: F64, unit: float) -> Bool:
    """Return which parts follow the outline of what lies in them, and hold a blank, (c,).

    A ring in a ring may be a gasket: what is held must have panels.
    """
    count = len(parent)
    bleed = np.zeros(count, np.bool_)
    held = np.flatnonzero((parent >= 0) & (many >= 2))
    held = held[np.argsort(parent[held], kind="stable")]
    holder = parent[held]
    if len(held) == 0:
        return bleed
    around, begins = np.unique(holder, return_index=True)
    # Only what is about as large as its bleed has one.
    low, high = _BLEED[0] * unit, _BLEED[1] * unit
    off = np.hstack(
        [
            np.abs(np.minimum.reduceat(box[held, :2], begins) - box[around, :2]),
            np.abs(np.maximum.reduceat(box[held, 2:], begins) - box[around, 2:]),
        ]
    )
    fits = (off.min(axis=1) >= low) & (off.max(axis=1) <= high)
    around = around[fits & (many[around] == 1) & ~frame[around]]
    if len(around) == 0:
        return bleed
    pieces = _by_part(graph.component, count)
    around = around[np.argsort(-np.diff(pieces.first)[around], kind="stable")[:_MOST]]
    of = np.searchsorted(holder, around), np.searchsorted(holder, around, side="right")
    lines = graph.vertex, graph.start, graph.end, graph.bulge
    _follow(lines, pieces, around.astype(np.int64), np.column_stack(of), held, low, bleed)
    return bleed


class _Pieces(NamedTuple):
    """The pieces of c parts."""

    listed: I32_1  #: (p,) part by part
    first: I64_1  #: (c + 1,) those of each part are first … first + 1 - 1


@kernel
def _by_part(part: I32_1, count: int) -> _Pieces:
    """Return the pieces, part by part."""
    first = np.zeros(count + 1, np.int64)
    for p in range(len(part)):
        first[part[p] + 1] += 1
    first = np.cumsum(first)
    put = first[:-1].copy()
    order = np.empty(len(part), np.int32)
    for p in range(len(part)):
        order[put[part[p]]] = p
        put[part[p]] += 1
    return _Pieces(order, first)


@kernel
def _follow(
    lines: tuple[F64_2, I32_1, I32_1, F64_1],
    pieces: _Pieces,
    around: I64_1,
    of: I64_2,
    held: I64_1,
    nearest: float,
    bleed: OutBool_1,
) -> None:
    """Write which of some parts follow the outlines of those in them.

    Parameters
    ----------
    of : (k, 2)
        What lies in the k parts are the rows of ``held`` from the one to before the other.
    nearest
        No nearer than this is such a part to what lies in it (file units).
    """
    for k in range(len(around)):
        own, bent = _drawn_by(lines, pieces, around[k : k + 1])
        among, bends = _drawn_by(lines, pieces, held[of[k, 0] : of[k, 1]])
        least, most = _distances(own, bent, among, bends)
        bleed[around[k]] = nearest <= least and most <= _MITRE * least


@kernel
def _drawn_by(lines: tuple[F64_2, I32_1, I32_1, F64_1], pieces: _Pieces, parts: I64_1) -> Any:
    """Return the pieces of some parts as lines, (m, 2, 2), and their bulges, (m,)."""
    place, start, end, bulge = lines
    count = 0
    for c in parts:
        count += pieces.first[c + 1] - pieces.first[c]
    ends, bent = np.empty((count, 2, 2)), np.empty(count)
    row = 0
    for c in parts:
        for k in range(pieces.first[c], pieces.first[c + 1]):
            p = pieces.listed[k]
            for axis in range(2):
                ends[row, 0, axis] = place[start[p], axis]
                ends[row, 1, axis] = place[end[p], axis]
            bent[row] = bulge[p]
            row += 1
    return ends, bent


@kernel(allocates=False)
def _distances(ends: F64_3, bulge: F64_1, among: F64_3, bent: F64_1) -> tuple[float, float]:
    """How near to, and how far from, other lines the beginnings and middles of lines are."""
    least, most = np.inf, 0.0
    for p in range(len(bulge)):
        for share in (0.0, 0.5):
            x, y = point_at(ends, bulge, p, share)
            best = np.inf
            for q in range(len(bent)):
                best = min(best, distance_to(among, bent, q, x, y, best)[0])
            least, most = min(least, best), max(most, best)
    return least, most
