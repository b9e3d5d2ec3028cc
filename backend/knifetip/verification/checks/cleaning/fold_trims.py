"""Find which dropped stretches of folds lie in the waste, as cleaning may drop them there.

Contours are cuts that enclose an area.  A point is on a panel if an odd number of contours enclose
it, otherwise it is in the waste.  The rule is in ``docs/contacts.md``; the verifier comes to it by
the cycles of half-edges around the faces between the cuts, and by the ends of the folds that
remain.

Dropped stretches that continue each other form a group.  A group that continues one fold is an
overshoot of that fold; a group between two folds is a passage.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.model.cleaned import Stretches
from knifetip.model.dieline import Dieline, LineType
from knifetip.verification.checks.order.cut_faces import find_cut_faces
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.curves.curve import line_curves, point_at
from knifetip.verification.curves.overlap import find_overlaps
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    TOUCH_DISTANCE,
    Edges,
    angle_between,
    edges_from_curves,
    pairs_within,
    place_edges,
    without_duplicates,
)
from knifetip.verification.expectation.outline import (
    CutOutlines,
    count_enclosing,
    find_outlines,
    lowest_connected,
)

#: Greatest length of an overshoot (mm).
MAX_OVERSHOOT: Final = 20.05
#: A cut outside all contours that is attached to one and at most this long is an overshoot of that
#: cut (mm).
_MAX_CUT_STUB: Final = 2.0
#: Greatest distance of a drawn stretch from the fold that it continues: cleaning moves ends (mm).
_CONTINUE_DISTANCE: Final = TOUCH_DISTANCE + 0.01
#: Greatest turn from a stretch to the fold that it continues (degrees).
_CONTINUE_ANGLE: Final = 5.0
#: Two ends that are nearer to each other touch (mm); half of the distance that joins edges.
_ON_DISTANCE: Final = 0.5 * JOIN_DISTANCE
_FOLDS: Final = (LineType.CREASE, LineType.COMBI, LineType.V_GROOVE)


@dataclass(frozen=True, slots=True)
class _Contours:
    """The contours of cuts, and the rectangle in which the outlines of panels may be open."""

    outlines: CutOutlines
    low: F64  #: (2,) mm, lower left corner of the rectangle
    high: F64  #: (2,) mm, upper right corner

    def count_around(self, points: F64) -> I64:
        """Return the number of contours around each of m points, (m,)."""
        return count_enclosing(points, self.outlines)

    def is_doubtful(self, points: F64) -> Bool:
        """Return the mask of the points in the rectangle, (m,)."""
        inside: Bool = np.all((points >= self.low) & (points <= self.high), axis=1)
        return inside


def are_trimmed_folds(drawn: Dieline, after: Dieline, parts: Stretches, dropped: I64) -> Bool:
    """Return the mask of the m dropped stretches that are pieces of folds in the waste, (m,).

    Parameters
    ----------
    drawn, after
        Dieline before and after cleaning.
    parts, dropped
        Stretches of the drawn edges, and the indices of the m dropped ones.
    """
    result = np.zeros(len(dropped), np.bool_)
    rows = parts.row[dropped]
    folds = np.flatnonzero(drawn.line_type[rows] != LineType.CUT)
    if len(folds) == 0 or not (after.line_type == LineType.CUT).any():
        return result
    at = dropped[folds]
    stretches = place_edges(_sub_dieline(drawn, parts, at), (0.0, 0.0))
    folds = folds[stretches.row]
    worked = place_edges(after, (0.0, 0.0))
    worked = worked.select(
        np.flatnonzero(~np.isin(worked.line_type, (LineType.UNCLASSIFIED, LineType.IGNORED)))
    )
    cuts, _, _ = without_duplicates(worked.with_types(LineType.CUT))
    kept = worked.with_types(*_FOLDS)
    waste = _are_in_waste(stretches, cuts, kept) & ~_touch_cuts(stretches, cuts, TOUCH_DISTANCE)
    group, count = _group_stretches(stretches)
    fine = np.ones(count, np.bool_)
    fine[group[~waste]] = False
    fine &= _look_like_trims(stretches, group, kept, worked, count)
    result[folds] = fine[group]
    return result


def _sub_dieline(drawn: Dieline, parts: Stretches, at: I64) -> Dieline:
    """Return the stretches with the indices ``at`` as edges of a dieline."""
    row = parts.row[at]
    start, chord = drawn.ends[row, 0], drawn.ends[row, 1] - drawn.ends[row, 0]
    half = 2.0 * np.arctan(drawn.bulge[row])
    bent = np.abs(drawn.bulge[row]) > 1e-9
    # Complex numbers: the chord to a point is the whole chord, scaled and turned.
    vector = chord[:, 0] + 1j * chord[:, 1]
    points = []
    for fraction in (parts.begin[at], parts.end[at]):
        size = np.where(bent, np.sin(fraction * half) / np.sin(np.where(bent, half, 1.0)), fraction)
        point = vector * size * np.exp(1j * (fraction - 1.0) * half)
        points.append(start + np.column_stack([point.real, point.imag]))
    return Dieline(
        np.stack(points, axis=1),
        np.tan((parts.end - parts.begin)[at] * np.arctan(drawn.bulge[row])),
        drawn.line_type[row],
        row,
        np.zeros(len(at), np.int32),
        np.zeros(len(at)),
        drawn.rules,
    )


def _touch_cuts(stretches: Edges, cuts: Edges, margin: float) -> Bool:
    """Return the mask of the stretches that cuts touch between their ends, (n,).

    A cut that touches a stretch at most ``margin`` mm from one of its ends does not count, even if
    it leaves the stretch at so small an angle that it touches more of the stretch.
    """
    size = stretches.curve[:, 5]
    near = find_overlaps(
        stretches.curve, cuts.curve, np.zeros(len(cuts)), cuts.curve[:, 5], JOIN_DISTANCE
    )
    inset = np.minimum(margin, 0.5 * size)[near.curve]
    inner = (near.along[:, 0] > inset) & (near.along[:, 1] < size[near.curve] - inset)
    result = np.zeros(len(stretches), np.bool_)
    result[near.curve[inner]] = True
    return result


def _are_in_waste(stretches: Edges, cuts: Edges, kept: Edges) -> Bool:
    """Return the mask of the stretches whose midpoints surely lie in the waste, (n,).

    ``cuts`` and ``kept`` are the cuts and the folds that remain after cleaning.
    """
    faces = find_cut_faces(cuts)
    pieces = edges_from_curves(faces.curve[faces.unique])
    is_cut = np.flatnonzero(faces.edge[faces.unique] >= 0)
    whole = ~_touch_cuts(kept, cuts, JOIN_DISTANCE)
    whole[_continuing_ends(stretches, kept)[1] // 2] = False
    folds = kept.select(np.flatnonzero(whole))
    linked = _mark_doubtful_area(pieces, is_cut, folds)
    exact = linked
    if len(is_cut) < len(pieces):
        exact = _mark_doubtful_area(pieces.select(is_cut), np.arange(len(is_cut)), folds)
    middle = point_at(stretches.curve, 0.5 * stretches.curve[:, 5])
    count = linked.count_around(middle)
    in_hole = (exact.count_around(middle) % 2 == 0) & ~exact.is_doubtful(middle)
    outside = (count == 0) & ~linked.is_doubtful(middle)
    result: Bool = outside | ((count > 0) & (count % 2 == 0) & in_hole)
    return result


def _mark_doubtful_area(pieces: Edges, is_cut: I64, folds: Edges) -> _Contours:
    """Return the contours of pieces of cuts, with the rectangle in which outlines may be open.

    The rectangle contains the cuts in the waste that enclose nothing, and the folds in the waste.

    ``pieces``, ``is_cut``: pieces of cuts and of links that close gaps, and the indices of the
    pieces of cuts.
    """
    outlines = find_outlines(pieces)
    loose = pieces.select(is_cut[outlines.loose[is_cut]])
    middle = point_at(loose.curve, 0.5 * loose.curve[:, 5])
    loose = loose.select(np.flatnonzero(count_enclosing(middle, outlines) % 2 == 0))
    closing = pieces.select(np.flatnonzero(outlines.closing))
    attached = np.zeros(len(loose), np.bool_)
    attached[pairs_within(loose.ends, closing.ends, JOIN_DISTANCE)[0] // 2] = True
    loose = loose.select(np.flatnonzero(~attached | (loose.curve[:, 5] > _MAX_CUT_STUB)))
    middle = point_at(folds.curve, 0.5 * folds.curve[:, 5])
    lost = np.flatnonzero(count_enclosing(middle, outlines) % 2 == 0)
    curve = np.concatenate([loose.curve, folds.curve[lost]])
    signs = np.concatenate(
        [point_at(curve, part * curve[:, 5]) for part in (0.0, 0.25, 0.5, 0.75, 1.0)]
    )
    return _Contours(
        outlines,
        signs.min(axis=0, initial=np.inf),
        signs.max(axis=0, initial=-np.inf),
    )


def _group_stretches(stretches: Edges) -> tuple[I64, int]:
    """Return the group of each of n stretches, (n,), and the number of groups.

    Stretches that continue each other are in one group.
    """
    one, other = _continuing_ends(stretches, stretches)
    name = lowest_connected(one // 2, other // 2, len(stretches))
    numbers, group = np.unique(name, return_inverse=True)
    return group.ravel().astype(np.int64), len(numbers)


def _continuing_ends(edges: Edges, others: Edges) -> tuple[I64, I64]:
    """Return the pairs of an end of ``edges`` and an end of ``others`` that continue each other."""
    one, other = pairs_within(edges.ends, others.ends, _CONTINUE_DISTANCE)
    turn = angle_between(edges.outward[one], others.outward[other] + 180.0)
    straight = turn <= _CONTINUE_ANGLE
    return one[straight], other[straight]


def _look_like_trims(stretches: Edges, group: I64, kept: Edges, worked: Edges, count: int) -> Bool:
    """Return the mask of the ``count`` groups that look like overshoots, or like passages between
    panels.

    ``stretches``, ``group`` n edges and (n,): the dropped stretches, and the group of each.
    ``kept``, ``worked``: the folds and all edges that remain after cleaning.
    """
    end, fold_end = _continuing_ends(stretches, kept)
    pairs = np.unique(np.stack([group[end // 2], fold_end], axis=1), axis=0)
    owner, fold_end = pairs[:, 0], pairs[:, 1]
    neighbours = np.bincount(owner, minlength=count)
    # The distance from the end of the fold to the farthest end of its group.
    first = np.full(count, -1)
    first[owner[::-1]] = fold_end[::-1]
    has_fold = (neighbours == 1)[group]
    reach = np.zeros(count)
    for side in range(2):
        tip = stretches.ends[side::2][has_fold]
        away = np.hypot(*(tip - kept.ends[first[group[has_fold]]]).T)
        np.maximum.at(reach, group[has_fold], away)
    size = np.zeros(len(stretches))
    size[has_fold] = stretches.curve[has_fold, 5]
    np.maximum.at(reach, group[has_fold], size[has_fold])
    overshoot = (neighbours == 1) & (reach <= MAX_OVERSHOOT + _CONTINUE_DISTANCE)
    beyond = np.zeros(2 * len(kept))
    np.maximum.at(beyond, first[overshoot], reach[overshoot])
    both = beyond[0::2] + beyond[1::2]
    overshoot[overshoot] &= (both < kept.curve[:, 5] + _CONTINUE_DISTANCE)[first[overshoot] // 2]
    # A short fold with a free end on the other side of a passage is itself an overshoot.
    free = ~_touch_others(kept.ends[fold_end ^ 1], kept.row[fold_end // 2], worked)
    formed = free & (kept.curve[fold_end // 2, 5] < MAX_OVERSHOOT - _CONTINUE_DISTANCE)
    passage = neighbours == 2
    passage[owner[formed]] = False
    result: Bool = overshoot | passage
    return result


def _touch_others(points: F64, row: I32, worked: Edges) -> Bool:
    """Return the mask of the points that lie on worked edges other than their own, (m,).

    ``points`` is (m, 2) mm, and ``row`` is the row of the edge to which each point belongs, (m,).
    """
    near = find_overlaps(
        line_curves(points, points),
        worked.curve,
        np.zeros(len(worked)),
        worked.curve[:, 5],
        _ON_DISTANCE,
    )
    other = worked.row[near.edge] != row[near.curve]
    result = np.zeros(len(points), np.bool_)
    result[near.curve[other]] = True
    return result
