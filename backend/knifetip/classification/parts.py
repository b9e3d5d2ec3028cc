"""parts: what each connected part of a drawing is: a blank, its frame, its bleed, a word, a mark.

    Net, Faces, inscriptions -> Parts

A part in no other is a blank.  A rectangle round blanks is a frame, what follows a blank at the
same distance is its bleed, a grid of boxes with texts in them is a title block, small shapes in
a row are letters.  Where much of what lies round a part leads nowhere its outline has a gap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Any, Final

import numpy as np
from numba import njit

from knifetip.classification.faces import Faces
from knifetip.classification.letters import lettering
from knifetip.classification.net import Net
from knifetip.classification.segment import near, point_at
from knifetip.classification.words import hint
from knifetip.geometry.columns import F64, I32, I64, Bool
from knifetip.geometry.compiled import whole
from knifetip.geometry.cores import each, runs
from knifetip.geometry.tolerance import GAP
from knifetip.model.dieline import LineType
from knifetip.model.drawing import Inscription

#: A part smaller than this share of the largest is a mark or a letter, not a blank.
_SMALL: Final = 0.004
#: More of this share of an outline leading nowhere means that it has a gap.
_DOUBT: Final = 0.1
#: A frame without a title block holds at least this share of its face, one with it this.
_HELD: Final = 0.15
_HELD_BESIDE_TITLE: Final = 0.01
#: A bleed is so far from its blank (mm), and its corners at most so many times as far.
_BLEED: Final = (0.4, 20.0)
_MITRE: Final = 2.2
#: What closes nothing and is no larger than this is a mark (mm).
_SPECK: Final = 30.0
#: The name of a kind of line has no more letters than this.
_NAME: Final = 30
#: A slot is no wider than this, a round hole in a panel no larger (mm).
_SLOT: Final = 6.0
_ROUND: Final = 50.0
_PLAIN: Final = 8
#: A part of so many panels is a carton.
_CARTON: Final = 6
_MOST: Final = 300
#: Pairs of parts that one core has looked at before another has begun.
_WORTH: Final = 300_000


@dataclass(frozen=True, eq=False, slots=True)
class Parts:
    """c connected parts."""

    inside: Bool  #: (c,) it lies inside a face of a blank
    frame: Bool  #: (c,)
    table: Bool  #: (c,)
    small: Bool  #: (c,)
    doubtful: Bool  #: (c,) its outline does not close
    annotated: Bool  #: (c,) a text stands in it, or beside it
    bleed: Bool  #: (c,) it follows the outline of what lies in it
    letter: Bool  #: (c,) it stands in a row of small parts that are not alike
    speck: Bool  #: (c,) it is short, closes nothing, and lies outside all others
    flat: Bool  #: (c,) it encloses nothing but what lies between a line and the same line again
    slot: Bool  #: (c,) it is narrow or round, and nothing lies in it
    legend: Bool  #: (c,) it is open, outside all others, and a text beside it names a kind of line
    around: Bool  #: (c,) a whole carton lies in it, and it is neither frame nor bleed

    @classmethod
    def of(
        cls,
        net: Net,
        sides: Faces,
        length: F64,
        inscriptions: Sequence[Inscription],
        unit: float,
    ) -> Parts:
        """Return what the parts of a net are.

        Parameters
        ----------
        length
            (p,) of each piece.
        unit
            How many units of the ends a millimetre has.
        """
        count = len(sides.outside)
        area = -sides.area[sides.outside]
        tiny = unit * unit
        owner = sides.owner
        bounded = sides.area > tiny
        bounded[sides.outside] = False
        many = np.bincount(owner[bounded], minlength=count)
        box = np.tile([np.inf, np.inf, -np.inf, -np.inf], (count, 1))
        level = np.ones(count, np.bool_)
        off = 2.0 * GAP * unit
        _measure(net.place, net.start, net.end, net.bulge, net.part, off, box, level)
        parent = np.where(sides.within >= 0, owner[sides.within], -1)
        frame = _frames(sides, parent, area, many, level, box, owner, bounded)
        bleed = _bleeds(net, parent, frame, many, box, unit)
        around = np.zeros(count, np.bool_)
        around[parent[(parent >= 0) & (many >= _CARTON)]] = True
        around &= (many == 1) & ~frame & ~bleed
        around &= (parent < 0) | (frame | bleed)[parent]
        beside = frame | bleed | around
        inside = (parent >= 0) & ~beside[parent]
        letter = lettering(net, box, length, unit)
        largest = area[~inside & ~beside].max(initial=0.0)
        holds = np.zeros(count, np.int64)
        annotated = np.zeros(count, np.bool_)
        _read(_placed(inscriptions), box, holds, annotated)
        apart = ~inside & ~beside
        table = apart & level & (area < 0.25 * largest)
        table &= (many >= 1) & (holds >= np.maximum(1, 0.4 * many))
        table |= apart & annotated & (area > tiny) & (area < 0.25 * largest)
        small = apart & ~table & (area > 0.0)
        small &= area < max(_SMALL * largest, 4.0 * tiny)
        doubtful = _doubtful(
            net, sides, length, area, box, inside | beside | table | letter, small, tiny
        )
        wide, high = box[:, 2] - box[:, 0], box[:, 3] - box[:, 1]
        size = np.sqrt(wide * wide + high * high)
        speck = apart & (area <= tiny) & (size <= _SPECK * unit)
        drawn = np.bincount(net.part, length, count).astype(np.float64)
        if drawn[speck].sum() > 0.25 * drawn[apart & (area > tiny)].sum():
            # So much that closes nothing may be what is left of a carton.
            speck[:] = False
        # A cross in a ring.
        speck |= apart & (many >= 2) & (size <= 0.5 * _SPECK * unit) & (area < 0.05 * largest)
        legend = apart & (area <= tiny) & (size <= 2.0 * _SPECK * unit)
        if legend.any():
            named = np.zeros(count, np.bool_)
            kinds = [text for text in inscriptions[:_MOST] if _names_a_line(text.text)]
            _read(_placed(kinds), box, np.zeros(count, np.int64), named)
            legend &= named
        slot = inside & (many == 1) & (np.bincount(parent[parent >= 0], minlength=count) == 0)
        slot &= _narrow(area, drawn, np.bincount(net.part, minlength=count), size, unit)
        return cls(
            inside, frame, table, small, doubtful, annotated,
            bleed, letter, speck, apart & (area <= tiny), slot, legend, around,
        )  # fmt: skip


@whole
def _measure(
    place: Any, start: Any, end: Any, bulge: Any, part: Any, off: float, box: Any, level: Any
) -> None:
    """Write the box of each part, arcs by their ends and their middles, and which are level.

    Level parts are made of level and upright lines only, but for ``off``.
    """
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


def _narrow(area: F64, drawn: F64, pieces: I64, size: F64, unit: float) -> Bool:
    """Return which closed parts are plain and as narrow as a slot, or round, (c,)."""
    across = np.maximum(drawn, 1e-12)
    round_ = (4.0 * np.pi * area > 0.98 * across * across) & (size <= _ROUND * unit * 2.0**0.5)
    narrow = (2.0 * area < _SLOT * unit * across) & (size > 2.0 * _SLOT * unit)
    result: Bool = (round_ | narrow) & (pieces <= _PLAIN)
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
    enclosed = np.bincount(owner[bounded], sides.area[bounded], count)
    while True:
        # A plain rectangle round a plain shape may be a blank with a hole, and is no frame.
        told = np.flatnonzero((parent >= 0) & ((many >= 2) | frame) & ~frame[parent])
        held = np.bincount(sides.within[told], size[told], len(sides.area))
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


def _bleeds(net: Net, parent: I32, frame: Bool, many: I64, box: F64, unit: float) -> Bool:
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
    order, first = _by_part(net.part, count)
    for c in around[np.argsort(-np.diff(first)[around], kind="stable")[:_MOST]].tolist():
        mine = held[slice(*np.searchsorted(holder, [c, c + 1]))]
        rows = np.concatenate([order[first[i] : first[i + 1]] for i in mine.tolist()])
        own = order[first[c] : first[c + 1]]
        held_ends = net.place[np.column_stack([net.start[rows], net.end[rows]])]
        own_ends = net.place[np.column_stack([net.start[own], net.end[own]])]
        least, most = _distances(own_ends, net.bulge[own], held_ends, net.bulge[rows])
        bleed[c] = low <= least and most <= _MITRE * least
    return bleed


@njit(cache=True, error_model="numpy")
def _by_part(part: Any, count: int) -> Any:
    """Return the pieces, part by part, and where those of each part begin."""
    first = np.zeros(count + 1, np.int64)
    for p in range(len(part)):
        first[part[p] + 1] += 1
    first = np.cumsum(first)
    put = first[:-1].copy()
    order = np.empty(len(part), np.int32)
    for p in range(len(part)):
        order[put[part[p]]] = p
        put[part[p]] += 1
    return order, first


@whole
def _distances(ends: Any, bulge: Any, among: Any, bent: Any) -> tuple[float, float]:
    """How near to, and how far from, other lines the beginnings and middles of lines are."""
    least, most = np.inf, 0.0
    for p in range(len(bulge)):
        for share in (0.0, 0.5):
            x, y = point_at(ends, bulge, p, share)
            best = np.inf
            for q in range(len(bent)):
                best = min(best, near(among, bent, q, x, y, best)[0])
            least, most = min(least, best), max(most, best)
    return least, most


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


def _read(text: F64, box: F64, holds: I64, beside: Bool) -> None:
    """Write how many texts stand in the box of each part, and whether one stands near, (c,)."""

    def read(run: tuple[int, int]) -> None:
        here = slice(*run)
        _texts(text, box[here], holds[here], beside[here])

    each(read, runs(len(box), _WORTH // (len(text) + 1)))


@njit(cache=True, error_model="numpy", nogil=True)
def _texts(text: Any, box: Any, holds: Any, beside: Any) -> None:
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
    nowhere, closing = np.zeros(count), np.zeros(count)
    _drawn(net.edge, net.part, sides.left, sides.right, sides.outside, length, nowhere, closing)
    blank = ~other & (area > tiny)
    lost = np.where(blank, nowhere, 0.0)
    # An open part that lies round a closed one is what is left of its outline.
    size = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    open_ = np.flatnonzero(~other & (nowhere > 0.5 * closing) & (size > tiny))
    open_ = open_[np.argsort(-size[open_], kind="stable")[:_MOST]]
    blanks = np.flatnonzero(blank)

    def covered(run: tuple[int, int]) -> None:
        _covered(open_, box, size, blanks[slice(*run)], nowhere, lost)

    each(covered, runs(len(blanks), _WORTH // (len(open_) + 1)))
    return blank & ~small & (lost > _DOUBT * closing)


@whole
def _drawn(
    edge: Any, part: Any, left: Any, right: Any, outside: Any, length: Any,
    nowhere: Any, closing: Any,
) -> None:  # fmt: skip
    """Add up what of each part leads nowhere, and what closes its outline."""
    for p in range(len(edge)):
        if edge[p] < 0:
            continue
        out = outside[part[p]]
        if left[p] == out and right[p] == out:
            nowhere[part[p]] += length[p]
        elif left[p] == out or right[p] == out:
            closing[part[p]] += length[p]


@whole
def _covered(open_: Any, box: Any, size: Any, blank: Any, nowhere: Any, lost: Any) -> None:
    """Add to what each blank has lost the open parts that lie round most of it."""
    for k in range(len(open_)):
        c = open_[k]
        for m in range(len(blank)):
            b = blank[m]
            width = min(box[b, 2], box[c, 2]) - max(box[b, 0], box[c, 0])
            height = min(box[b, 3], box[c, 3]) - max(box[b, 1], box[c, 1])
            if b != c and max(width, 0.0) * max(height, 0.0) > 0.5 * size[b]:
                lost[b] += nowhere[c]
