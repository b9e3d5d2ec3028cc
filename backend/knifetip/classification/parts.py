"""parts: what each connected part of a drawing is: a blank, its frame, its bleed, a word, a mark.

    PlanarGraph, Faces, inscriptions -> Parts

A part in no other is a blank.  A rectangle round blanks is a frame, what follows a blank at the
same distance is its bleed (``surrounds``), a grid of boxes with texts in them is a title block,
small shapes in a row are letters (``measures``).  Where much of what lies round a part leads
nowhere its outline has a gap.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.classification.measures import Extents, Measures
from knifetip.classification.surrounds import Surrounds
from knifetip.geometry.columns import F64, Bool
from knifetip.geometry.cores import both, each, runs
from knifetip.kernels import F64_1, F64_2, I64_1, OutF64_1, kernel
from knifetip.model.drawing import Inscription
from knifetip.topology.faces import Faces
from knifetip.topology.planar_graph import PlanarGraph

#: A part smaller than this share of the largest is a mark or a letter, not a blank.
_SMALL: Final = 0.004
#: More of this share of an outline leading nowhere means that it has a gap.
_DOUBT: Final = 0.1
#: What closes nothing and is no larger than this is a mark (mm).
_SPECK: Final = 30.0
#: Of open parts only the largest are looked at for what they lie round.
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
        graph: PlanarGraph,
        sides: Faces,
        length: F64,
        extents: Extents,
        inscriptions: Sequence[Inscription],
        unit: float,
    ) -> Parts:
        """Return what the parts of a graph are.

        Parameters
        ----------
        length
            (p,) of each piece.
        unit
            How many units of the ends a millimetre has.
        """
        around, found = both(
            lambda: Surrounds.of(graph, sides, extents, unit),
            lambda: Measures.of(graph, sides, length, extents.box, inscriptions, unit),
        )
        many, parent = around.many, around.parent
        area, size, tiny = found.area, found.size, unit * unit
        beside = around.frame | around.bleed | around.around
        inside = (parent >= 0) & ~beside[parent]
        apart = ~inside & ~beside
        largest = area[apart].max(initial=0.0)
        table = apart & extents.level & (area < 0.25 * largest)
        table &= (many >= 1) & (found.holds >= np.maximum(1, 0.4 * many))
        table |= apart & found.annotated & (area > tiny) & (area < 0.25 * largest)
        small = apart & ~table & (area > 0.0)
        small &= area < max(_SMALL * largest, 4.0 * tiny)
        speck = apart & (area <= tiny) & (size <= _SPECK * unit)
        if found.drawn[speck].sum() > 0.25 * found.drawn[apart & (area > tiny)].sum():
            # So much that closes nothing may be what is left of a carton.
            speck[:] = False
        # A cross in a ring.
        speck |= apart & (many >= 2) & (size <= 0.5 * _SPECK * unit) & (area < 0.05 * largest)
        legend = apart & (area <= tiny) & (size <= 2.0 * _SPECK * unit)
        alone = np.bincount(parent[parent >= 0], minlength=len(area)) == 0
        return cls(
            inside=inside,
            frame=around.frame,
            table=table,
            small=small,
            doubtful=_doubtful(found, extents.box, apart & ~table & ~found.letter, small, tiny),
            annotated=found.annotated,
            bleed=around.bleed,
            letter=found.letter,
            speck=speck,
            flat=apart & (area <= tiny),
            slot=inside & (many == 1) & alone & found.narrow,
            legend=legend & found.named,
            around=around.around,
        )


def _doubtful(found: Measures, box: F64, some: Bool, small: Bool, tiny: float) -> Bool:
    """Return the parts, of some, beside whose outline too much leads nowhere, (c,).

    Small ones are not asked about, but what is left of an outline may be small.
    """
    blank = some & ~small & (found.area > tiny)
    lost = np.where(blank, found.nowhere, 0.0)
    # An open part that lies round a closed one is what is left of its outline.
    size = (box[:, 2] - box[:, 0]) * (box[:, 3] - box[:, 1])
    open_ = np.flatnonzero(some & (found.nowhere > 0.5 * found.closing) & (size > tiny))
    open_ = open_[np.argsort(-size[open_], kind="stable")[:_MOST]]
    around, leads = box[open_], found.nowhere[open_]
    blanks = np.flatnonzero(blank)

    def covered(run: tuple[int, int]) -> None:
        _covered(open_, around, leads, box, size, blanks[slice(*run)], lost)

    each(covered, runs(len(blanks), _WORTH // (len(open_) + 1)))
    return blank & (lost > _DOUBT * found.closing)


@kernel(allocates=False)
def _covered(
    open_: I64_1,
    around: F64_2,
    nowhere: F64_1,
    box: F64_2,
    size: F64_1,
    blank: I64_1,
    lost: OutF64_1,
) -> None:
    """Add to what each blank has lost the open parts that lie round most of it."""
    for m in range(len(blank)):
        b = blank[m]
        left, low, right, high = box[b, 0], box[b, 1], box[b, 2], box[b, 3]
        most = 0.5 * size[b]
        for k in range(len(open_)):
            width = min(right, around[k, 2]) - max(left, around[k, 0])
            height = min(high, around[k, 3]) - max(low, around[k, 1])
            if width * height > most and width > 0.0 and open_[k] != b:
                lost[b] += nowhere[k]
