"""state: the edges between two steps of cleaning, and the parts of drawn edges that they replace.

A drawn edge consists of stretches, each of which belongs to one current edge or is dropped.  Every
step updates this assignment together with the edges.
"""

from __future__ import annotations

from dataclasses import dataclass, fields, replace
from typing import Final

import numpy as np

from knifetip.cleaning.close_gaps import close_gaps, find_debris
from knifetip.cleaning.copied_runs import merge_copied_runs
from knifetip.cleaning.corner_loops import SHORT, find_corner_loops
from knifetip.cleaning.deviation import measure_deviation, measured_edges
from knifetip.cleaning.end_points import EndPoints, connected_edges, find_end_points
from knifetip.cleaning.lost_length import lost_length
from knifetip.cleaning.merge_collinear import merge_collinear
from knifetip.cleaning.raise_to import raise_to
from knifetip.cleaning.reattach import MergedLines, reattach
from knifetip.cleaning.remove_overlaps import NearEdges, Pieces, remove_overlaps
from knifetip.cleaning.trim_folds import trim_folds
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import GAP, JOIN, POINT
from knifetip.model.dieline import Dieline

#: Parts of a stretch up to this fraction of its length are rounding errors.
_SLIVER: Final = 1e-12
#: How often edges that nearly coincide are merged, each time without those that moved too far.
_TRIALS: Final = 3
#: The same for curves that were drawn twice; all of them stay after the last one.
_COPY_TRIALS: Final = 2


@dataclass(slots=True)
class CleaningState:
    """State between two steps of cleaning: k current edges, and q stretches of drawn edges.

    A stretch is a part of a drawn edge that belongs to one current edge, or is dropped.
    """

    ends: F64  #: (k, 2, 2) mm
    bulge: F64  #: (k,)
    kind: U8  #: (k,) line type
    moved: F64  #: (k,) largest displacement of an end (mm)
    fitted: Bool  #: (k,) whether the edge replaces chords of a curve
    fit_error: F64  #: (k,) distance of the edge from the curve that was drawn or read (mm)
    row: I64  #: (q,) drawn edge of each stretch
    begin: F64  #: (q,) start of each stretch, 0 … 1 of the drawn edge
    end: F64  #: (q,) end of each stretch
    edge: I64  #: (q,) current edge of each stretch, -1 if dropped
    overlapping: Bool  #: (q,) whether the stretch overlaps another edge
    off_panel: Bool  #: (q,) whether the stretch was dropped because it is outside all panels
    looped: (
        Bool  #: (n,) whether the drawn edge was dropped because it belongs to a loop at a corner
    )
    #: whether current edges nearly coincided when overlaps were removed last
    has_near: bool = False
    #: whether edges that nearly coincide may be merged; False after it failed
    merges_near: bool = True
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

    def remove_overlaps(self, drawn: Dieline, near: NearEdges | None = None) -> bool:
        """Divide current edges where they overlap, and remove parts that another edge replaces.

        With ``near``, edges that nearly coincide, within ``GAP``, overlap.

        A drawn edge consists of stretches, each of which belongs to one current edge.  The
        stretches are divided at the same points and then belong to the edges that remain.
        ``drawn`` contains the drawn edges.  Returns whether any current edge was divided because
        only a part of it overlaps another edge.
        """
        pieces = remove_overlaps(self.ends, self.bulge, self.kind, near)
        self.has_near = pieces.has_near
        if not pieces.is_foreign.any():
            return False
        split = len(pieces.edge) > len(self.bulge)
        self._divide(drawn, pieces)
        return split

    def merge_copied_runs(self, drawn: Dieline) -> None:
        """Merge curves that were drawn twice as chords with other vertices.

        A run that would move by more than ``GAP`` stays.  ``drawn`` contains the drawn edges.
        """
        place = self.end_points().place
        before = replace(self)
        is_fixed = np.zeros(len(self.bulge), np.bool_)
        for _ in range(_COPY_TRIALS):
            pieces = merge_copied_runs(self.ends, self.bulge, self.kind, place, is_fixed)
            if pieces is None:
                return
            self._divide(drawn, pieces)
            self._reattach(drawn, self.overlapping)
            far = self._deviation(drawn) > GAP + POINT
            if not far.any():
                return
            too_far = np.isin(before.row, self.row[far]) & (before.edge >= 0)
            for column in fields(before):
                setattr(self, column.name, getattr(before, column.name))
            is_fixed[self.edge[too_far]] = True

    def merge_near(self, drawn: Dieline) -> bool:
        """Merge current edges that nearly coincide, within ``GAP``.

        No part of a drawn edge moves by more than ``GAP`` in all steps together: an edge that would
        carry it farther stays.  ``drawn`` contains the drawn edges.  Returns whether any current
        edge was divided.
        """
        before = replace(self)
        chain_of = connected_edges(self.end_points().place)
        is_fixed = np.zeros(len(self.bulge), np.bool_)
        for _ in range(_TRIALS):
            was_split = self.remove_overlaps(drawn, NearEdges(chain_of, is_fixed))
            far = self._deviation(drawn)
            if self._reattach(drawn, (far > JOIN) & self.overlapping):
                far = self._deviation(drawn)
            too_far = np.isin(before.row, self.row[far > GAP + POINT]) & (before.edge >= 0)
            if not too_far.any():
                return was_split
            is_fixed[before.edge[too_far]] = True
            for column in fields(before):
                setattr(self, column.name, getattr(before, column.name))
        self.merges_near = False
        return False

    def _deviation(self, drawn: Dieline) -> F64:
        """Return the greatest distance of each stretch from its current edge, (q,) mm."""
        return measure_deviation(
            measured_edges(drawn.ends, drawn.bulge),
            measured_edges(self.ends, self.bulge),
            self.row,
            self.begin,
            self.end,
            self.edge,
        )

    def _reattach(self, drawn: Dieline, merged: Bool) -> bool:
        """Move ends that touched stretches that were merged, and return whether any was moved.

        ``merged`` (q,) is the mask of these stretches of the drawn edges ``drawn``.
        """
        rows = np.flatnonzero(merged)
        if len(rows) == 0:
            return False
        edge = self.row[rows]
        parts = arc.sub_arc(
            drawn.ends[edge, 0],
            drawn.ends[edge, 1],
            drawn.bulge[edge],
            self.begin[rows],
            self.end[rows],
        )
        ends = reattach(
            self.ends, self.bulge, self.end_points().place, MergedLines(*parts, self.edge[rows])
        )
        moved = np.hypot(*(ends - self.ends).transpose(2, 0, 1)).max(axis=1, initial=0.0)
        if not moved.any():
            return False
        self.ends, self.moved = ends, np.maximum(self.moved, moved)
        return True

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
        self._select(pieces.owner)
        self.moved = np.maximum(self.moved, pieces.moved)
        self.off_panel = np.zeros(len(self.edge), np.bool_)

    def _select(self, rows: I64 | I32 | Bool) -> None:
        """Select rows of the columns that follow a current edge through every step."""
        self.moved, self.fitted = self.moved[rows], self.fitted[rows]
        self.fit_error = self.fit_error[rows]

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
        self._select(keep)

    def _drop(self, edges: Bool) -> None:
        """Remove the current edges of a mask, (k,); their stretches are dropped."""
        keep = ~edges
        number = np.where(keep, np.cumsum(keep) - 1, -1)
        self.ends, self.bulge, self.kind = self.ends[keep], self.bulge[keep], self.kind[keep]
        self._select(keep)
        self.edge = np.where(self.edge < 0, -1, number[self.edge])

    def remove_corner_loops(self, drawn_length: F64) -> None:
        """Remove loops of short edges at the corners of outlines.

        ``drawn_length`` (n,) are the lengths of the drawn edges (mm).
        """
        length = arc.length(self.ends[:, 0], self.ends[:, 1], self.bulge)
        if length.min(initial=SHORT) >= SHORT:
            return
        live = np.flatnonzero(self.edge >= 0)
        longest = np.zeros(len(self.bulge))
        raise_to(longest, self.edge[live], drawn_length[self.row[live]])
        loops = find_corner_loops(self.ends, self.kind, length, longest, self.end_points().place)
        if loops.any():
            self.looped[self.row[live[loops[self.edge[live]]]]] = True
            self._drop(loops)

    def merge(self, *, curves_only: bool = False) -> None:
        """Merge current edges that continue each other.

        The parts of drawn edges that belonged to the merged edges then belong to the new edge.  If
        ``curves_only`` is True, only edges shorter than the gap tolerance are merged.
        """
        merged = merge_collinear(
            self.ends,
            self.bulge,
            self.kind,
            self.fit_error,
            self.end_points(),
            curves_only=curves_only,
        )
        count = len(merged.bulge)
        if count == len(self.bulge):
            return
        moved, fitted = np.zeros(count), merged.fitted.copy()
        raise_to(moved, merged.merged_edge.astype(np.int64), self.moved)
        fitted[merged.merged_edge[self.fitted]] = True
        self.ends, self.bulge, self.kind = merged.ends, merged.bulge, merged.kind
        self.moved, self.fitted, self.fit_error = moved, fitted, merged.fit_error
        self.edge = np.where(self.edge < 0, -1, merged.merged_edge[self.edge]).astype(np.int64)

    def remove_debris_and_gaps(self, drawn_length: F64) -> None:
        """Remove current edges that are debris, then close gaps between the ends of edges.

        ``drawn_length`` (n,) are the lengths of the drawn edges (mm).  No drawn edge loses more
        than ``GAP``: if others divide it into pieces of debris, these stay.
        """
        length = arc.length(self.ends[:, 0], self.ends[:, 1], self.bulge)
        if (length < GAP).any() and (
            debris := find_debris(self.ends, length, self.end_points())
        ).any():
            is_lost = np.append(debris, True)[self.edge]
            lost = lost_length(self.row, self.begin, self.end, is_lost, drawn_length)
            debris[self.edge[is_lost & (lost > GAP)[self.row] & (self.edge >= 0)]] = False
            self._drop(debris)
        closed = close_gaps(self.ends, self.bulge, self.kind, self.moved > 0.0, self.end_points())
        self.moved = np.maximum(self.moved, closed.displacement)
        self.ends = closed.ends
