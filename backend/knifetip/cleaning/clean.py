"""clean: remove duplicates, overlaps, debris and gaps, and merge edges that continue each other.

``clean`` converts a Dieline to a ``Cleaned``: the dieline from which the program is made, and the
outcome of every drawn edge.

Order of steps: remove overlaps, fit lines and arcs to flattened curves, remove debris, close gaps,
merge edges that continue each other.  The steps are repeated, at most four times, until no edge is
split, merged, moved or removed as debris.  An edge that was moved to close a gap is not moved a
second time.  At last the pieces of folds in the waste are dropped (``trim_folds``).

A drawn edge consists of stretches, each of which belongs to one cleaned edge or is dropped.  Every
step updates this assignment; outcomes and lengths are computed from it alone, so they always agree
with the geometry.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.cleaning.close_gaps import close_gaps, find_debris
from knifetip.cleaning.end_points import EndPoints, find_end_points
from knifetip.cleaning.merge_collinear import FINE, merge_collinear
from knifetip.cleaning.priority import PRIORITY
from knifetip.cleaning.remove_overlaps import Pieces, remove_overlaps
from knifetip.cleaning.trim_folds import trim_folds
from knifetip.errors import GeometryError
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import GAP, POINT
from knifetip.model.cleaned import Cleaned, CleaningReason, Stretches
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import ImportOutcome

#: Largest number of repetitions of all steps.
_ROUNDS: Final = 4
#: Lengths that differ by less are equal up to rounding (mm).
_HAIR: Final = 1e-9
#: Parts of a stretch up to this fraction of its length are rounding errors.
_SLIVER: Final = 1e-12
#: Coordinates beyond this are refused: they cannot resolve a micrometre (mm).
_FAR: Final = 1e9


class _FinalRows(NamedTuple):
    """Indices that relate n drawn edges, their q stretches and the k edges after cleaning.

    A stretch is a part of a drawn edge that belongs to one edge after cleaning, or is debris.  A
    row is the index of an edge in the drawn dieline or in the cleaned dieline.
    """

    row: I64  #: (q,) drawn edge of each stretch
    edge: I64  #: (q,) current edge of each stretch, -1 for debris
    overlapping: Bool  #: (q,) whether the stretch overlaps another edge
    slot: I64  #: (k,) row of each edge in the cleaned dieline
    source: I64  #: (k,) drawn row from which each edge takes its source, face and part
    target_row: I32  #: (n,) cleaned row that covers most of each drawn edge, -1 for none


class _Lengths(NamedTuple):
    """Lengths (mm) that decide the outcome of each of n drawn edges.

    They are the length that is kept, the length that is merged with other edges, the largest
    displacement of an end, and the length that is dropped because it is outside all panels.
    """

    kept: F64  #: length of stretches that overlap no other edge
    merged: F64  #: length of stretches that overlap other edges
    moved: F64  #: largest displacement of an end
    off_panel: F64  #: length of dropped stretches outside all panels


@dataclass(slots=True)
class _State:
    """State between two steps of cleaning: k current edges, and q stretches of drawn edges.

    A stretch is a part of a drawn edge that belongs to one current edge, or is dropped.
    """

    ends: F64  #: (k, 2, 2) mm
    bulge: F64  #: (k,)
    kind: U8  #: (k,) line type
    moved: F64  #: (k,) largest displacement of an end (mm)
    fitted: Bool  #: (k,) whether the edge replaces a flattened curve
    row: I64  #: (q,) drawn edge of each stretch
    begin: F64  #: (q,) start of each stretch, 0 … 1 of the drawn edge
    end: F64  #: (q,) end of each stretch
    edge: I64  #: (q,) current edge of each stretch, -1 if dropped
    overlapping: Bool  #: (q,) whether the stretch overlaps another edge
    off_panel: Bool  #: (q,) whether the stretch was dropped because it is outside all panels
    #: points of the ends of ``ends``, None before they are first used
    cached_end_points: EndPoints | None = None

    def end_points(self) -> EndPoints:
        """Return the points at which current edges meet, and the pairs of ends near each other.

        Two ends are near each other if they do not meet but are at most ``GAP`` (the largest gap
        that is closed) apart.  The result is computed again only if the ends have changed since the
        last call.
        """
        if self.cached_end_points is None or self.cached_end_points.ends is not self.ends:
            # A gap of exactly ``GAP`` is closed, however its ends are rounded.
            self.cached_end_points = find_end_points(self.ends, GAP + POINT)
        return self.cached_end_points

    def remove_overlaps(self, drawn: Dieline) -> bool:
        """Divide current edges where they overlap, and remove parts that another edge replaces.

        A drawn edge consists of stretches, each of which belongs to one current edge.  The
        stretches are divided at the same points and then belong to the edges that remain.
        ``drawn`` contains the drawn edges.  Returns whether any current edge was divided because
        only a part of it overlaps another edge.
        """
        pieces = remove_overlaps(self.ends, self.bulge, self.kind)
        if not pieces.is_foreign.any():
            return False
        split = len(pieces.edge) > len(self.bulge)
        self._divide(drawn, pieces)
        return split

    def trim_folds(self, drawn: Dieline) -> None:
        """Divide folds at the outlines of panels, and drop their pieces in the waste.

        ``drawn`` contains the drawn edges.
        """
        pieces = trim_folds(self.ends, self.bulge, self.kind)
        if pieces is not None:
            was_dropped = len(self.edge) - np.count_nonzero(self.edge >= 0)
            self._divide(drawn, pieces)
            self.off_panel = self.edge < 0
            # Stretches that were dropped before are the last rows.
            self.off_panel[len(self.edge) - was_dropped :] = False

    def _divide(self, drawn: Dieline, pieces: Pieces) -> None:
        """Replace the current edges by pieces of them.

        The stretches of drawn edges are divided at the same points and then belong to the pieces.
        A stretch without a piece is dropped.  ``drawn`` contains the drawn edges.
        """
        by_edge = np.lexsort((pieces.begin, pieces.edge))
        first = np.searchsorted(pieces.edge[by_edge], np.arange(len(self.bulge) + 1))
        live, lost = self.edge >= 0, self.edge < 0
        row, edge = self.row[live], self.edge[live]
        begin, end = self.begin[live], self.end[live]
        start, finish, bent = drawn.ends[row, 0], drawn.ends[row, 1], drawn.bulge[row]
        on, bow = self.ends[edge], self.bulge[edge]
        from_, to = (
            arc.nearest_fraction(
                on[:, 0], on[:, 1], bow, arc.point_at(start, finish, bent, fraction)
            )
            for fraction in (begin, end)
        )
        # One row for every part into which the edge of a stretch was split.
        part_count = first[edge + 1] - first[edge]
        old = np.repeat(np.arange(len(edge)), part_count)
        offset = np.arange(len(old)) - np.repeat(np.cumsum(part_count) - part_count, part_count)
        part = by_edge[first[edge[old]] + offset]
        low, high = np.minimum(from_, to)[old], np.maximum(from_, to)[old]
        span = np.maximum(high - low, 1e-12)
        one, two = (
            np.clip((place[part] - low) / span, 0.0, 1.0) for place in (pieces.begin, pieces.end)
        )
        one = np.where(offset == 0, 0.0, one)
        two = np.where(offset == part_count[old] - 1, 1.0, two)
        back = (from_ > to)[old]
        one, two = np.where(back, 1.0 - two, one), np.where(back, 1.0 - one, two)
        # Rounding leaves slivers of stretches that only touch a part.
        some = two - one > _SLIVER
        old, part, one, two = old[some], part[some], one[some], two[some]
        size = end[old] - begin[old]
        self.row = np.concatenate([row[old], self.row[lost]])
        self.begin = np.concatenate([begin[old] + one * size, self.begin[lost]])
        self.end = np.concatenate([begin[old] + two * size, self.end[lost]])
        self.edge = np.concatenate([pieces.piece[part], self.edge[lost]]).astype(np.int64)
        overlapping = self.overlapping[live][old] | pieces.is_foreign[part]
        self.overlapping = np.concatenate([overlapping, self.overlapping[lost]])
        self.ends, self.bulge, self.kind = pieces.ends, pieces.bulge, self.kind[pieces.owner]
        self.moved, self.fitted = self.moved[pieces.owner], self.fitted[pieces.owner]
        self.off_panel = np.zeros(len(self.edge), np.bool_)

    def ensure_owned(self) -> None:
        """Ensure that each current edge has a stretch that is not marked as overlapping.

        A stretch is a part of a drawn edge that belongs to one current edge.  If all stretches of a
        current edge are marked as overlapping another edge, the marks are removed.  A current edge
        without any stretch is removed.
        """
        live = self.edge >= 0
        count = len(self.bulge)
        owned = np.bincount(self.edge[live & ~self.overlapping], minlength=count) > 0
        if owned.all():
            return
        self.overlapping = self.overlapping & np.append(owned, True)[self.edge]
        keep = np.bincount(self.edge[live], minlength=count) > 0
        number = np.append(np.where(keep, np.cumsum(keep) - 1, -1), -1)
        self.edge = number[self.edge]
        self.ends, self.bulge, self.kind = self.ends[keep], self.bulge[keep], self.kind[keep]
        self.moved, self.fitted = self.moved[keep], self.fitted[keep]

    def merge(self, *, curves_only: bool = False) -> None:
        """Merge current edges that continue each other.

        The parts of drawn edges that belonged to the merged edges then belong to the new edge.  If
        ``curves_only`` is True, only the segments of flattened curves are merged.
        """
        merged = merge_collinear(
            self.ends, self.bulge, self.kind, self.end_points(), curves_only=curves_only
        )
        count = len(merged.bulge)
        if count == len(self.bulge):
            return
        moved, fitted = np.zeros(count), merged.fitted.copy()
        np.maximum.at(moved, merged.merged_edge, self.moved)
        np.logical_or.at(fitted, merged.merged_edge, self.fitted)
        self.ends, self.bulge, self.kind = merged.ends, merged.bulge, merged.kind
        self.moved, self.fitted = moved, fitted
        self.edge = np.where(self.edge < 0, -1, merged.merged_edge[self.edge])

    def remove_debris_and_gaps(self) -> None:
        """Remove current edges that are debris, then close gaps between the ends of edges."""
        length = arc.length(self.ends[:, 0], self.ends[:, 1], self.bulge)
        if (length < GAP).any() and (
            debris := find_debris(self.ends, length, self.end_points())
        ).any():
            keep = ~debris
            number = np.where(keep, np.cumsum(keep) - 1, -1)
            self.ends, self.bulge, self.kind = self.ends[keep], self.bulge[keep], self.kind[keep]
            self.moved, self.fitted = self.moved[keep], self.fitted[keep]
            self.edge = np.where(self.edge < 0, -1, number[self.edge])
        closed = close_gaps(self.ends, self.bulge, self.kind, self.moved > 0.0, self.end_points())
        self.moved = np.maximum(self.moved, closed.displacement)
        self.ends = closed.ends


def clean(dieline: Dieline) -> Cleaned:
    """Return the cleaned dieline, with the outcome of every drawn edge.

    Parameters
    ----------
    dieline
        n drawn edges with their line types, in the drawing's coordinates.

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
        raise GeometryError("edge.not-finite", edge=int(np.argmax(bad)))
    if np.abs(dieline.ends).max(initial=0.0) > _FAR:
        far = np.abs(dieline.ends).max(axis=(1, 2))
        raise GeometryError("edge.too-far", edge=int(far.argmax()), distance=far.max())
    length = arc.length(dieline.ends[:, 0], dieline.ends[:, 1], dieline.bulge)
    at_work = PRIORITY[dieline.line_type] > 0
    solid = np.flatnonzero(at_work & (length >= POINT))
    empty = np.flatnonzero(at_work & (length < POINT))
    count, every = len(solid), np.concatenate([solid, empty])
    state = _State(
        dieline.ends[solid],
        dieline.bulge[solid],
        dieline.line_type[solid],
        np.zeros(count),
        np.zeros(count, np.bool_),
        every,
        np.zeros(len(every)),
        np.ones(len(every)),
        np.where(np.arange(len(every)) < count, np.arange(len(every)), -1),
        np.zeros(len(every), np.bool_),
        np.zeros(len(every), np.bool_),
    )
    for _ in range(_ROUNDS):
        was_split = state.remove_overlaps(dieline)
        ends = state.ends
        if (length[solid] < FINE).any():
            state.merge(curves_only=True)
        state.remove_debris_and_gaps()
        state.merge()
        if state.ends is ends and not was_split:
            break
    state.trim_folds(dieline)
    return _report(dieline, length, at_work, state)


def _is_ascending(column: I64) -> bool:
    """Return whether each entry of a column is greater than the one before it."""
    return bool((column[1:] > column[:-1]).all())


def _slots(state: _State, count: int) -> tuple[I64, I64]:
    """Return where each of the k current edges is placed in the cleaned dieline.

    Two arrays, (k,) each, are returned.  The first contains the row of each current edge in the
    cleaned dieline.  The second contains its source: the index of the first drawn edge of which the
    current edge contains a part.

    A current edge is placed in the row with the index of its source.  If several current edges have
    one source, only the one nearest to the start of the drawn edge is placed there, and the others
    are placed in rows after all drawn edges.  ``count`` is the number of drawn edges.
    """
    order = np.flatnonzero((state.edge >= 0) & ~state.overlapping)
    if not _is_ascending(state.edge[order]):
        order = order[np.lexsort((state.begin[order], state.row[order], state.edge[order]))]
    edge, row = state.edge[order], state.row[order]
    head = np.flatnonzero(np.append(True, edge[1:] != edge[:-1])) if len(edge) else edge
    slot = np.full(len(state.bulge), -1, np.int64)
    shown = row[head]
    source = np.empty(len(state.bulge), np.int64)
    source[edge[head]] = shown
    taken = np.full(count, -1, np.int64)
    # If a drawn edge has several pieces, the piece nearest to its start takes its row.
    by_row = head
    if not _is_ascending(row[head]):
        by_row = head[np.lexsort((state.begin[order[head]], row[head]))]
    first = by_row[np.append(True, row[by_row][1:] != row[by_row][:-1])] if len(by_row) else by_row
    slot[edge[first]] = row[first]
    taken[row[first]] = edge[first]
    free = np.flatnonzero(slot < 0)
    slot[free] = count + np.arange(len(free))
    return slot, source


def _report(dieline: Dieline, length: F64, at_work: Bool, state: _State) -> Cleaned:
    count = len(dieline)
    state.ensure_owned()
    slot, source = _slots(state, count)
    total = count + int((slot >= count).sum())
    ends = np.zeros((total, 2, 2))
    bulge = np.zeros(total)
    kinds = np.full(total, LineType.IGNORED, np.uint8)
    ends[:count], bulge[:count] = dieline.ends, dieline.bulge
    kinds[:count] = np.where(at_work, LineType.IGNORED, dieline.line_type)
    ends[slot], bulge[slot], kinds[slot] = state.ends, state.bulge, state.kind
    shown = np.arange(total)
    shown[slot] = source
    order: I64 | slice = slice(None)
    if not _is_ascending(state.row):
        order = np.lexsort((state.begin, state.row))
    row, edge, overlapping = state.row[order], state.edge[order], state.overlapping[order]
    low, high = state.begin[order], state.end[order]
    target = np.append(slot, -1)[edge]
    # A cleaned edge approximates the curves of all drawn edges that it replaces.
    fit_error = dieline.fit_error[shown]
    np.maximum.at(fit_error, target[target >= 0], dieline.fit_error[row[target >= 0]])
    cleaned = replace(
        dieline,
        ends=ends,
        bulge=bulge,
        line_type=kinds,
        source=dieline.source[shown],
        rule=dieline.rule[shown],
        confidence=dieline.confidence[shown],
        # A cleaned edge has the direction of the drawn edge that it is shown for.
        face=dieline.face[shown],
        part=dieline.part[shown],
        fit_error=fit_error,
    )
    size = (high - low) * length[row]

    def summed(mask: Bool) -> F64:
        return np.bincount(row[mask], size[mask], count).astype(np.float64)

    live = edge >= 0
    kept, merged, dropped = summed(live & ~overlapping), summed(live & overlapping), summed(~live)
    kept[~at_work] = length[~at_work]
    added = np.zeros(count)
    cleaned_length = arc.length(state.ends[:, 0], state.ends[:, 1], state.bulge)
    drawn_length = np.bincount(
        edge[live & ~overlapping], size[live & ~overlapping], len(cleaned_length)
    )
    np.add.at(
        added,
        source,
        np.where(np.abs(cleaned_length - drawn_length) < _HAIR, 0.0, cleaned_length - drawn_length),
    )
    moved = np.zeros(count)
    np.maximum.at(moved, source, state.moved)
    deviation = _deviation(dieline, ends, bulge, row, low, high, target)
    target_row = _main_row(row, size, target, overlapping, count)
    target_row[~at_work] = np.flatnonzero(~at_work)
    outcome, reason = _outcomes(
        state,
        _FinalRows(row, edge, overlapping, slot, source, target_row),
        _Lengths(kept, merged, moved, summed(state.off_panel[order])),
        at_work,
    )
    return Cleaned(
        cleaned,
        target_row,
        outcome,
        reason,
        kept,
        merged,
        dropped,
        added,
        moved,
        deviation,
        Stretches(row.astype(np.int32), low, high, target.astype(np.int32), overlapping),
    )


def _main_row(row: I64, size: F64, target: I64, overlapping: Bool, count: int) -> I32:
    """Return the row of the cleaned edge that replaces each of n drawn edges, (n,); -1 if dropped.

    A drawn edge consists of stretches, each of which belongs to one cleaned edge or is debris.  The
    result is the row of the cleaned edge to which the longest stretch belongs.  A stretch that
    overlaps another edge is considered only if all stretches of the drawn edge do so.

    Parameters
    ----------
    row, size, target, overlapping : (q,)
        For each of q stretches: its drawn edge, its length (mm), the row of its cleaned edge (-1
        for debris), and whether it overlaps another edge.
    count
        Number n of drawn edges.
    """
    target_row = np.full(count, -1, np.int32)
    order = np.flatnonzero(target >= 0)
    if not _is_ascending(row[order]):
        order = order[np.lexsort((size[order], ~overlapping[order], row[order]))]
    # The last assignment to each row counts.
    target_row[row[order]] = target[order]
    return target_row


def _outcomes(
    state: _State, final_rows: _FinalRows, lengths: _Lengths, at_work: Bool
) -> tuple[U8, U8]:
    """Return the outcome and the reason for it, as codes, for each of n drawn edges, (n,) each.

    The outcomes are ``ImportOutcome`` codes (kept, merged or dropped), and the reasons are
    ``CleaningReason`` codes.

    Parameters
    ----------
    state
        The current edges after the last step of cleaning.
    final_rows
        Indices that relate the drawn edges to the current edges and to the cleaned edges.
    lengths
        Kept length, merged length and displacement of each drawn edge (mm).
    at_work : (n,)
        Mask of the drawn edges whose line type is cut or creased.
    """
    row, edge, overlapping, slot, source, target_row = final_rows
    kept, merged, moved, off_panel = lengths
    count = len(target_row)
    keeps_row = np.zeros(count, np.bool_)
    keeps_row[slot[slot < count]] = True
    owned = (edge >= 0) & ~overlapping
    # Edges that contain parts of several drawn edges.
    several = np.zeros(count, np.bool_)
    first = source[edge[owned]]
    several[first[first != row[owned]]] = True
    curve = np.zeros(count, np.bool_)
    curve[row[owned]] = state.fitted[edge[owned]]
    reason = np.full(count, CleaningReason.AS_DRAWN, np.uint8)
    reason[moved > 0.0] = CleaningReason.MOVED
    reason[several] = CleaningReason.LONGER
    reason[keeps_row & (merged > 0.0)] = CleaningReason.SHORTENED
    is_split = np.bincount(row[owned], minlength=count) > 1
    reason[keeps_row & is_split] = CleaningReason.SHORTENED
    reason[keeps_row & (off_panel > 0.0)] = CleaningReason.OFF_PANEL
    away = at_work & ~keeps_row & (target_row >= 0)
    reason[away] = np.where(
        kept[away] > 0.0,
        np.where(curve[away], CleaningReason.FITTED, CleaningReason.JOINED),
        CleaningReason.TWICE,
    )
    lost = at_work & (target_row < 0)
    reason[lost] = np.where(off_panel[lost] > 0.0, CleaningReason.OFF_PANEL, CleaningReason.SPECK)
    reason[~at_work] = CleaningReason.NO_WORK
    outcome = np.full(count, ImportOutcome.KEPT, np.uint8)
    outcome[away] = ImportOutcome.MERGED
    outcome[lost] = ImportOutcome.DROPPED
    return outcome, reason


def _deviation(
    dieline: Dieline, ends: F64, bulge: F64, row: I64, low: F64, high: F64, target: I64
) -> F64:
    """Return the greatest distance of each drawn edge from its cleaned edges, (n,) mm.

    The distance is measured at five points of each stretch of the drawn edge.  It is 0 for a drawn
    edge that is unchanged, or that became debris.

    Parameters
    ----------
    dieline
        The n drawn edges.
    ends, bulge : (m, 2, 2) mm and (m,)
        The cleaned edges.
    row, low, high, target : (q,)
        For each of q stretches: its drawn edge, its start and its end as fractions of that edge's
        length, and the row of its cleaned edge (-1 for debris).
    """
    off = np.zeros(len(dieline))
    live = target >= 0
    same = bulge[target] == dieline.bulge[row]
    # By column, since reductions of rows of four numbers are slow.
    for after, before in zip(ends.reshape(-1, 4).T, dieline.ends.reshape(-1, 4).T, strict=True):
        same &= after[target] == before[row]
    some = np.flatnonzero(live & ~same)
    start, end, bent = (
        dieline.ends[row[some], 0],
        dieline.ends[row[some], 1],
        dieline.bulge[row[some]],
    )
    at, to = ends[target[some]], bulge[target[some]]
    for fraction in (0.0, 0.25, 0.5, 0.75, 1.0):
        place = low[some] + fraction * (high[some] - low[some])
        point = arc.point_at(start, end, bent, place)
        along = arc.nearest_fraction(at[:, 0], at[:, 1], to, point)
        gap = point - arc.point_at(at[:, 0], at[:, 1], to, along)
        np.maximum.at(off, row[some], np.hypot(*gap.T))
    return off
