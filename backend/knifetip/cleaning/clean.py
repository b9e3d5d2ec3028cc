"""clean: remove duplicates, overlaps, debris and gaps, and merge edges that continue each other.

``clean`` converts a Dieline to a ``Cleaned``: the dieline from which the program is made, and the
outcome of every drawn edge.

Order of steps: remove overlaps, remove loops at corners, fit lines and arcs to flattened curves,
remove debris, close gaps, merge edges that continue each other, merge edges that nearly coincide.
The steps are repeated, at most four times, until no edge is split, merged, moved or removed as
debris.  An edge that was moved to close a gap is not moved a second time.  At last the pieces of
folds in the waste are dropped (``trim_folds``).  A caller that doubts a result repeats the cleaning
with a smaller ``Extent``.

The module ``state`` assigns the parts of drawn edges to cleaned edges in every step; ``outcomes``
reports from that assignment what happened to each drawn edge.
"""

from __future__ import annotations

from enum import IntEnum
from typing import Final

import numpy as np

from knifetip.cleaning.fit_curves import FINE
from knifetip.cleaning.outcomes import report_outcomes
from knifetip.cleaning.priority import PRIORITY
from knifetip.cleaning.state import CleaningState
from knifetip.errors import GeometryError
from knifetip.geometry import arc
from knifetip.geometry.tolerance import BULGE, POINT
from knifetip.model.cleaned import Cleaned
from knifetip.model.dieline import Dieline

#: Largest number of repetitions of all steps.
_ROUNDS: Final = 4
#: Coordinates beyond this are refused: they cannot resolve a micrometre (mm).
_FAR: Final = 1e9


class Extent(IntEnum):
    """How much cleaning may change; each extent omits one step of the extent after it."""

    NOTHING = 0  #: all edges stay as they are drawn
    SEPARATE = 1  #: edges that nearly coincide stay two edges
    UNTRIMMED = 2  #: pieces of folds in the waste stay
    LOOPED = 3  #: loops of short edges at corners stay
    ALL = 4


def clean(dieline: Dieline, extent: Extent = Extent.ALL) -> Cleaned:
    """Return the cleaned dieline, with the outcome of every drawn edge.

    Parameters
    ----------
    dieline
        n drawn edges with their line types, in the drawing's coordinates.
    extent
        The steps that are made.

    Returns
    -------
    Cleaned
        The cleaned edges, and for each drawn edge its outcome (kept, merged or dropped), the reason
        for the outcome, and the lengths of the edge that were kept, merged, dropped and added (mm).
        An edge that needs no cleaning keeps its ends and bulge, bit for bit.

    Raises
    ------
    GeometryError
        A coordinate is not finite or is too far from the origin.
    DrawingTooLarge
        Too many edges overlap.
    """
    if not (np.isfinite(dieline.ends).all() and np.isfinite(dieline.bulge).all()):
        bad = ~(np.isfinite(dieline.ends).all(axis=(1, 2)) & np.isfinite(dieline.bulge))
        raise GeometryError(
            "edge.not-finite", edge=int(np.argmax(bad)), at_edges=np.flatnonzero(bad)
        )
    if np.abs(dieline.ends).max(initial=0.0) > _FAR:
        far = np.abs(dieline.ends).max(axis=(1, 2))
        raise GeometryError(
            "edge.too-far",
            edge=int(far.argmax()),
            distance=far.max(),
            at_edges=np.flatnonzero(far > _FAR),
        )
    length = arc.length(dieline.ends[:, 0], dieline.ends[:, 1], dieline.bulge)
    at_work = PRIORITY[dieline.line_type] > 0
    solid = np.flatnonzero(at_work & (length >= POINT))
    empty = np.flatnonzero(at_work & (length < POINT))
    count, every = len(solid), np.concatenate([solid, empty])
    state = CleaningState(
        dieline.ends[solid],
        dieline.bulge[solid],
        dieline.line_type[solid],
        np.zeros(count),
        np.zeros(count, np.bool_),
        # Readings of older versions do not state how far an edge is from its curve.
        np.where(np.isfinite(dieline.fit_error[solid]), dieline.fit_error[solid], 0.0),
        every,
        np.zeros(len(every)),
        np.ones(len(every)),
        np.where(np.arange(len(every)) < count, np.arange(len(every)), -1),
        np.zeros(len(every), np.bool_),
        np.zeros(len(every), np.bool_),
        np.zeros(len(dieline), np.bool_),
        merges_near=extent > Extent.SEPARATE,
    )
    if extent > Extent.SEPARATE:
        state.merge_copied_runs(dieline)
    for turn in range(_ROUNDS if extent > Extent.NOTHING else 0):
        was_split = state.remove_overlaps(dieline)
        if extent > Extent.LOOPED:
            state.remove_corner_loops(length)
        ends = state.ends
        if (length[solid] < FINE).any():
            # Of a drawn arc and its chords the arc remains: no curve is fitted to these chords.
            has_arcs = turn == 0 and (np.abs(state.bulge) >= BULGE).any()
            if has_arcs and state.has_near and state.merges_near:
                was_split |= state.merge_near(dieline)
            state.merge(curves_only=True)
        state.remove_debris_and_gaps(length)
        state.merge()
        if state.has_near and state.merges_near:
            was_split |= state.merge_near(dieline)
        if state.ends is ends and not was_split:
            break
    if extent > Extent.UNTRIMMED:
        state.trim_folds(dieline)
    return report_outcomes(dieline, length, at_work, state)
