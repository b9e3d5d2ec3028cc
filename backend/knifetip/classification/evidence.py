"""evidence: what shape alone tells of each edge.

    ends, bulge, inscriptions -> Shape

The drawing is a net (``net``) with faces (``faces``).  The outside of a part that lies in no other
is the outline of a blank; what parts two faces of it divides panels; a closed part inside a face is
a hole; a line that leads nowhere is a slit, or lies free.  A rectangle round blanks is a frame, a
grid of boxes with texts in them a title block.  Where much of what lies round a part leads nowhere
its outline has a gap, and its shape tells nothing.

Measured over the whole part, never from a single line: a crease is known by its two panels.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.classification.faces import Faces, faces
from knifetip.classification.net import Net, built
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import GAP
from knifetip.model.drawing import Inscription

#: A loose end nearer than this to another line was meant to touch it (mm).
_REACH: Final = 1.0
#: A drawing whose unit is not known is taken to be so large across (mm): for tolerances only.
_ACROSS: Final = 500.0
#: A part smaller than this share of the largest is a mark or a letter, not a blank.
_SMALL: Final = 0.004
#: More of this share of an outline leading nowhere means that it has a gap.
_DOUBT: Final = 0.1
#: A face narrower than this lies between a pair of lines: a double crease, a slot (mm).
_NARROW: Final = 6.0
_MOST = 300


class Role(IntEnum):
    """What an edge is in its net."""

    UNKNOWN = 0
    OUTLINE = 1
    HOLE = 2
    DIVIDER = 3
    SLIT = 4
    FREE = 5
    STRAY = 6
    FRAME = 7
    TABLE = 8
    MARK = 9
    INNER = 10
    OPEN = 11

    @property
    def words(self) -> str:
        """What the page says of it."""
        return _SAID[self]


_SAID: Final = {
    Role.UNKNOWN: "its shape tells nothing",
    Role.OUTLINE: "closes the outline of a blank",
    Role.HOLE: "closes a hole in a panel",
    Role.DIVIDER: "divides two panels",
    Role.SLIT: "begins at another line and ends inside a panel",
    Role.FREE: "lies free inside a panel",
    Role.STRAY: "lies outside every blank",
    Role.FRAME: "frames the whole drawing",
    Role.TABLE: "stands beside a text: a title block, a dimension or a label",
    Role.MARK: "closes a shape much smaller than the blank",
    Role.INNER: "lies inside a hole, or divides one",
    Role.OPEN: "belongs to an outline that does not close",
}


@dataclass(frozen=True, eq=False, slots=True)
class Shape:
    """What shape tells of n edges."""

    tangled: bool  #: the drawing is too tangled to be looked at
    role: U8  #: (n,) Role of the greater part of each edge
    sure: F64  #: (n,) the share of its length that has this role
    paired: Bool  #: (n,) it bounds a face so narrow that it has a partner beside it
    dashed: Bool  #: (n,) it is one of a row of dashes
    annotated: Bool  #: (n,) a text stands beside the part that it belongs to
    part: I32  #: (n,) the connected part of the drawing that it belongs to, -1 for none
    sides: I32  #: (n, 2) the faces on its two sides, along most of its length
    area: F64  #: (f,) of each face, ≤ 0 for the outside of a part


def shape(
    ends: F64, bulge: F64, inscriptions: Sequence[Inscription] = (), unit_known: bool = True
) -> Shape:
    """Return what shape tells of n edges, (n, 2, 2) and (n,).

    Parameters
    ----------
    unit_known
        Whether the ends are in mm; otherwise tolerances go by the size of the whole.
    """
    count = len(bulge)
    ends, bulge = np.array(ends, np.float64), np.array(bulge, np.float64)
    unit = 1.0
    if not unit_known and count:
        across = ends.reshape(-1, 2)
        unit = float(np.hypot(*(across.max(axis=0) - across.min(axis=0)))) / _ACROSS or 1.0
    touch = GAP * unit
    net = built(ends, bulge, touch, _REACH * unit)
    if net is None:
        none = np.zeros(count, np.bool_)
        return Shape(
            count > 0,
            np.zeros(count, np.uint8),
            np.zeros(count),
            none,
            none,
            none,
            np.full(count, -1, np.int32),
            np.zeros((count, 2), np.int32),
            np.zeros(1),
        )
    sides = faces(net, ends, bulge, touch)
    real = net.edge >= 0
    length = arc.length(net.place[net.start], net.place[net.end], net.bulge)
    parts = _Parts.of(net, sides, length, inscriptions, unit)
    role = _roles(sides, parts)
    perimeter = np.bincount(sides.left, length, len(sides.area))
    perimeter += np.bincount(sides.right, length, len(sides.area))
    slender = 2.0 * sides.area < _NARROW * unit * perimeter
    slender &= (sides.area > 0.0) & (perimeter > 5.0 * _NARROW * unit)
    paired = slender[sides.left] != slender[sides.right]
    table = np.zeros((count, len(Role) + 2))
    beside_it = np.zeros((count, 2), np.int32)
    _gathered(net.edge, role, paired, length, sides.left, sides.right, table, beside_it)
    greatest = table[:, :-2].argmax(axis=1)
    whole = table[:, :-2].sum(axis=1)
    share = np.divide(
        table[np.arange(count), greatest], whole, out=np.zeros(count), where=whole > 0.0
    )
    part_of = np.full(count, -1, np.int32)
    part_of[net.edge[real]] = sides.part[real]
    # An edge too short to be a piece is what the edge before it is, which it goes on from.
    before = np.maximum.accumulate(np.where(whole > 0.0, np.arange(count), 0))
    gap = np.hypot(*(ends[before, 1] - ends[:, 0]).T)
    speck = (whole == 0.0) & (whole[before] > 0.0) & (gap <= 4.0 * touch)
    greatest[speck], share[speck] = greatest[before[speck]], share[before[speck]]
    part_of[speck] = part_of[before[speck]]
    whole[speck] = touch
    beside: Bool = np.where(part_of >= 0, parts.annotated[part_of], False)
    return Shape(
        False,
        np.where(whole > 0.0, greatest, Role.UNKNOWN).astype(np.uint8),
        share,
        table[:, -2] > 0.5 * whole,
        net.dashed,
        beside,
        part_of,
        beside_it,
        sides.area,
    )


@njit(cache=True, error_model="numpy")
def _gathered(
    edge: Any, role: Any, paired: Any, length: Any, left: Any, right: Any, table: Any, sides: Any
) -> None:
    longest = np.zeros(len(table))
    for p in range(len(edge)):
        i = edge[p]
        if i < 0:
            continue
        table[i, role[p]] += length[p]
        if paired[p]:
            table[i, -2] += length[p]
        if length[p] > longest[i]:
            longest[i] = length[p]
            sides[i, 0] = left[p]
            sides[i, 1] = right[p]


@dataclass(frozen=True, eq=False, slots=True)
class _Parts:
    """c connected parts."""

    inside: Bool  #: (c,) it lies inside a face of a blank
    frame: Bool  #: (c,)
    table: Bool  #: (c,)
    small: Bool  #: (c,)
    doubtful: Bool  #: (c,) its outline does not close
    annotated: Bool  #: (c,) a text stands in it, or beside it

    @classmethod
    def of(
        cls,
        net: Net,
        sides: Faces,
        length: F64,
        inscriptions: Sequence[Inscription],
        unit: float,
    ) -> _Parts:
        count = len(sides.outside)
        area = -sides.area[sides.outside]
        tiny = unit * unit
        owner = np.zeros(len(sides.area), np.int32)
        owner[sides.left], owner[sides.right] = sides.part, sides.part
        bounded = sides.area > tiny
        bounded[sides.outside] = False
        many = np.bincount(owner[bounded], minlength=count)
        box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (count, 1))
        _part_boxes(net.place, net.start, net.end, sides.part, box)
        level = _level(net, sides, count, 2.0 * GAP * unit)
        parent = np.where(sides.within >= 0, owner[sides.within], -1)
        frame = _frames(sides, parent, area, many, level, box, owner, bounded)
        inside = (parent >= 0) & ~frame[parent]
        deep = inside.copy()
        largest = area[~deep & ~frame].max(initial=0.0)
        holds, annotated = _texts(inscriptions, box)
        table = ~deep & ~frame & level & (area < 0.25 * largest)
        table &= (many >= 1) & (holds >= np.maximum(1, 0.4 * many))
        table |= ~deep & ~frame & annotated & (area > tiny) & (area < 0.25 * largest)
        small = ~deep & ~frame & ~table & (area > 0.0)
        small &= area < max(_SMALL * largest, 4.0 * tiny)
        return cls(
            deep,
            frame,
            table,
            small,
            _doubtful(net, sides, length, area, box, deep | frame | table, small, tiny),
            annotated,
        )


@njit(cache=True, error_model="numpy")
def _part_boxes(place: Any, start: Any, end: Any, part: Any, box: Any) -> None:
    for p in range(len(start)):
        c = part[p]
        for at in (start[p], end[p]):
            box[c, 0] = min(box[c, 0], place[at, 0])
            box[c, 1] = min(box[c, 1], place[at, 1])
            box[c, 2] = max(box[c, 2], place[at, 0])
            box[c, 3] = max(box[c, 3], place[at, 1])


def _level(net: Net, sides: Faces, count: int, off: float) -> Bool:
    """Return which parts are made of level and upright lines only, (c,)."""
    run = np.abs(net.place[net.end] - net.place[net.start])
    askew = run.min(axis=1) > np.maximum(0.001 * run.max(axis=1), off)
    askew |= np.abs(net.bulge) > 1e-6
    result: Bool = np.bincount(sides.part[askew], minlength=count) == 0
    return result


def _frames(
    sides: Faces,
    parent: I32,
    area: F64,
    many: I64,
    level: Bool,
    box: F64,
    owner: I32,
    bounded: Bool,
) -> Bool:
    """Return which parts are rectangles, perhaps with a title block, round blanks, (c,)."""
    count = len(area)
    frame = np.zeros(count, np.bool_)
    size = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    while True:
        # A plain rectangle round a plain shape may be a blank with a hole, and is no frame.
        told = np.flatnonzero((parent >= 0) & ((many >= 2) | frame) & ~frame[parent])
        held = np.bincount(sides.within[told], size[told], len(sides.area))
        found = False
        for face in np.flatnonzero(held).tolist():
            c = int(owner[face])
            around = float(sides.area[bounded & (owner == c)].sum()) - float(sides.area[face])
            if (
                level[c]
                and sides.area[face] >= 0.6 * size[c]
                and around <= 0.3 * sides.area[face]
                and held[face] >= 0.15 * sides.area[face]
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


def _texts(inscriptions: Sequence[Inscription], box: F64) -> tuple[I64, Bool]:
    """Return how many texts stand in the box of each part, and whether one stands near, (c,)."""
    holds = np.zeros(len(box), np.int64)
    near = np.zeros(len(box), np.bool_)
    for text in inscriptions[:_MOST]:
        margin = 2.0 * text.height
        inside = (box[:, 0] <= text.x) & (text.x <= box[:, 2])
        inside &= (box[:, 1] <= text.y) & (text.y <= box[:, 3])
        holds += inside
        # Letters stand above and to the right of where a text begins.
        width = 0.7 * text.height * len(text.text)
        near |= (
            (box[:, 0] <= text.x + width + margin)
            & (text.x - width - margin <= box[:, 2])
            & (box[:, 1] <= text.y + margin)
            & (text.y - margin <= box[:, 3])
        )
    return holds, near


def _doubtful(
    net: Net,
    sides: Faces,
    length: F64,
    area: F64,
    box: F64,
    other: Bool,
    small: Bool,
    tiny: float,
) -> Bool:
    """Return the parts beside whose outline too much leads nowhere, (c,)."""
    count = len(area)
    real = net.edge >= 0
    outside = sides.outside[sides.part]
    out_left, out_right = sides.left == outside, sides.right == outside
    nowhere = np.bincount(
        sides.part[real & out_left & out_right], length[real & out_left & out_right], count
    )
    closing = np.bincount(
        sides.part[real & (out_left != out_right)], length[real & (out_left != out_right)], count
    )
    blank = ~other & (area > tiny)
    lost = np.where(blank, nowhere, 0.0)
    # An open part that lies round a closed one is what is left of its outline.
    size = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    open_ = np.flatnonzero(~other & (nowhere > 0.5 * closing) & (size > tiny))
    open_ = open_[np.argsort(-size[open_], kind="stable")[:_MOST]]
    for c in open_.tolist():
        width = np.minimum(box[:, 2], box[c, 2]) - np.maximum(box[:, 0], box[c, 0])
        height = np.minimum(box[:, 3], box[c, 3]) - np.maximum(box[:, 1], box[c, 1])
        shared = np.maximum(width, 0.0) * np.maximum(height, 0.0)
        covered = blank & (shared > 0.5 * size)
        covered[c] = False
        lost[covered] += nowhere[c]
    return blank & ~small & (lost > _DOUBT * closing)


def _roles(sides: Faces, parts: _Parts) -> U8:
    """Return the role of each piece, (p,)."""
    part = sides.part
    outside = sides.outside[part]
    left, right = sides.left == outside, sides.right == outside
    same = sides.left == sides.right
    inside = parts.inside[part]
    role = np.full(len(part), Role.DIVIDER, np.uint8)
    role[left != right] = Role.OUTLINE
    role[same] = Role.SLIT
    role[same & left] = Role.STRAY
    role[parts.doubtful[part] & (role != Role.STRAY)] = Role.OPEN
    role[parts.doubtful[part] & (role == Role.STRAY)] = Role.OPEN
    role[inside] = Role.INNER
    role[inside & (left != right)] = Role.HOLE
    role[inside & same & left] = Role.FREE
    role[parts.small[part] & (left != right)] = Role.MARK
    role[parts.frame[part]] = Role.FRAME
    role[parts.table[part]] = Role.TABLE
    return role
