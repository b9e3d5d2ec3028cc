"""Check that the cleaned edges, which a program is verified against, match the drawn edges.

The cleaning stage divides each drawn edge into stretches, and records the cleaned edge that each
stretch became.  Each stretch must lie on that cleaned edge, and the cleaned edge must have the
stretch's line type or a line type that replaces it.  Each cleaned edge must lie on drawn edges.
Where an arc replaces chords of a curve, or an arc of another radius, the cleaned edge must state
the distance as a part of its ``fit_error``, which the deviation of the program includes.
Three things may be dropped: debris, which is edges and ends of edges shorter than the gap
tolerance, pieces of folds in the waste (``fold_trims``), and loops at corners
(``corner_loops``).  The distances are measured here without the
functions of the cleaning stage.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Final

import numpy as np

from knifetip.messages import Message
from knifetip.model.cleaned import Cleaned, Stretches
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.verdict import Finding
from knifetip.verification.checks.cleaning.corner_loops import are_corner_loops
from knifetip.verification.checks.cleaning.fold_trims import are_trimmed_folds
from knifetip.verification.columns import F64, I64, Bool

#: Greatest distance between a drawn stretch and its cleaned edge (mm).
SAME: Final = 0.01
#: Gap tolerance; shorter edges are debris (mm).
GAP: Final = 0.05
#: Positions at which a stretch is measured, as fractions of its length.
_PROBES: Final = (0.0, 0.2, 0.4, 0.5, 0.6, 0.8, 1.0)
_BULGE: Final = 1e-9
#: Tolerance for rounding (mm).
_ROUNDING: Final = 1e-6
#: Greatest number of findings.
_MAX_CLEANING_FINDINGS: Final = 50

_NO_WORK: Final = (LineType.UNCLASSIFIED, LineType.IGNORED)
#: Line types whose work is included in the work of another type.
_REPLACES: Final[dict[LineType, tuple[LineType, ...]]] = {
    LineType.CUT: (
        LineType.V_GROOVE,
        LineType.COMBI,
        LineType.PERFORATION,
        LineType.HALF_CUT,
        LineType.CREASE,
    ),
    LineType.V_GROOVE: (
        LineType.COMBI,
        LineType.PERFORATION,
        LineType.HALF_CUT,
        LineType.CREASE,
    ),
    LineType.COMBI: (LineType.PERFORATION, LineType.HALF_CUT, LineType.CREASE),
    LineType.PERFORATION: (LineType.HALF_CUT,),
    LineType.HALF_CUT: (LineType.CREASE,),
}


def check_cleaning(drawn: Dieline, cleaned: Cleaned) -> list[Finding]:
    """Return a finding for each difference between a cleaned dieline and the drawn edges.

    At most fifty findings are returned.  ``drawn`` is the dieline before cleaning; ``cleaned`` is
    the dieline after cleaning, with the cleaned edge that each drawn stretch became.
    """
    findings: list[Finding] = []
    if _is_unchanged(drawn, cleaned):
        return findings
    after, parts = cleaned.dieline, cleaned.stretches
    length = _edge_lengths(drawn.ends, drawn.bulge)
    has_work = ~np.isin(drawn.line_type, _NO_WORK)

    def report(edge: int, measure: float, message: Message) -> None:
        if len(findings) < _MAX_CLEANING_FINDINGS:
            findings.append(Finding("uncut", message, measure, edge))

    # The stretches of each edge that is cut or creased must add up to its length.
    recorded = np.bincount(parts.row, (parts.end - parts.begin) * length[parts.row], len(drawn))
    for edge in np.flatnonzero(
        np.abs(np.where(has_work, length, 0.0) - recorded) > _ROUNDING
    ).tolist():
        report(edge, float(length[edge] - recorded[edge]), Message("verify.cleaning-incomplete"))
    lost = parts.cleaned < 0
    size = (parts.end - parts.begin) * length[parts.row]
    gone = _lost_lengths(parts, lost, size, len(drawn))
    if (gone > GAP + _ROUNDING).any():
        dropped = np.flatnonzero(lost)
        lost[dropped[are_trimmed_folds(drawn, after, parts, dropped)]] = False
        lost[dropped[are_corner_loops(drawn, after, parts, dropped)]] = False
        gone = _lost_lengths(parts, lost, size, len(drawn))
    lost = parts.cleaned < 0
    for edge in np.flatnonzero(gone > GAP + _ROUNDING).tolist():
        report(edge, float(gone[edge]), Message("verify.cleaning-dropped", length=gone[edge]))
    there = np.flatnonzero(~lost)
    row, target = parts.row[there].astype(np.int64), parts.cleaned[there].astype(np.int64)
    first, second = after.line_type[target], drawn.line_type[row]
    table = np.zeros((len(LineType), len(LineType)), np.bool_)
    for one, others in _REPLACES.items():
        table[one, list(others)] = True
    right = (first == second) | (parts.by_other_edge[there] & table[first, second])
    for at in np.flatnonzero(~right):
        cleaned_type, drawn_type = LineType(first[at]).word, LineType(second[at]).word
        message = Message("verify.cleaning-type", drawn=drawn_type, worked=cleaned_type)
        report(int(row[at]), float(length[row[at]]), message)
    limit = np.where(cleaned.moved[row] > 0.0, GAP, SAME) + np.where(
        cleaned.moved[after.source[target]] > 0.0, GAP, 0.0
    )
    far, along = _measure_stretches(drawn, after, row, target, parts.begin[there], parts.end[there])
    for at in np.flatnonzero(far > limit + _ROUNDING):
        report(int(row[at]), float(far[at]), Message("verify.cleaning-moved", distance=far[at]))
    own = ~parts.by_other_edge[there]
    stated = after.fit_error[target] - drawn.fit_error[row]
    # An edge that overlaps others may be moved by SAME to their ends, which is no error of a curve.
    overlaps = np.bincount(parts.row[parts.by_other_edge], minlength=len(drawn)) > 0
    is_fitted = own & ~overlaps[row] & (limit == SAME) & (far <= SAME + _ROUNDING)
    is_fitted[is_fitted] = _are_bent(
        drawn, after, row[is_fitted], target[is_fitted], size[there][is_fitted]
    )
    for at in np.flatnonzero(is_fitted & (far > stated + _ROUNDING)):
        message = Message("verify.cleaning-fit", distance=far[at], stated=stated[at])
        report(int(row[at]), float(far[at]), message)
    _check_added_work(after, target[own], along[own], report)
    return findings


def _is_unchanged(drawn: Dieline, cleaned: Cleaned) -> bool:
    """Return whether the cleaned edges are the drawn edges, and the whole of each drawn edge that
    is cut or creased became the same edge.
    """
    after, parts = cleaned.dieline, cleaned.stretches
    worked = np.flatnonzero(~np.isin(drawn.line_type, _NO_WORK))
    return (
        np.array_equal(after.ends, drawn.ends)
        and np.array_equal(after.bulge, drawn.bulge)
        and np.array_equal(after.line_type, drawn.line_type)
        and np.array_equal(after.source, np.arange(len(drawn)))
        and np.array_equal(parts.row, worked)
        and np.array_equal(parts.cleaned, worked)
        and not parts.by_other_edge.any()
        and not parts.begin.any()
        and bool((parts.end == 1.0).all())
    )


def _lost_lengths(parts: Stretches, is_lost: Bool, size: F64, count: int) -> F64:
    """Return how much each of ``count`` drawn edges lost in one place or inside, (count,) mm.

    What an edge lost at its two ends leaves two gaps, so only the longer of them is counted.

    ``parts``: the q stretches of the drawn edges.
    ``is_lost``, ``size`` (q,): which stretches are lost, and the length of each (mm).
    """
    total = np.bincount(parts.row[is_lost], size[is_lost], count)
    at_ends = np.zeros((2, count))
    for side, place in enumerate((parts.begin, -parts.end)):
        order = np.lexsort((place, parts.row))
        row = parts.row[order]
        begins = np.searchsorted(row, np.arange(count))
        # The lost stretches before the first one that is kept.
        kept = np.cumsum(~is_lost[order])
        before = np.append(0, kept)[begins[row]]
        outer = kept == before
        at_ends[side] = np.bincount(row[outer], size[order][outer], count)
    is_whole = at_ends[0] + at_ends[1] > total + _ROUNDING
    return np.asarray(total - np.where(is_whole, 0.0, at_ends.min(axis=0)), np.float64)


def _edge_lengths(ends: F64, bulge: F64) -> F64:
    chord = np.hypot(*(ends[:, 1] - ends[:, 0]).T)
    half = 2.0 * np.arctan(np.abs(bulge))
    bent = half > 2.0 * _BULGE
    length: F64 = np.where(bent, chord * half / np.sin(np.where(bent, half, 1.0)), chord)
    return length


def _points_at(ends: F64, bulge: F64, fraction: F64) -> F64:
    """Return one point on each of n lines and arcs, (n, 2) mm.

    ``ends`` are the start and end points of the lines and arcs, (n, 2, 2) mm, and ``bulge`` their
    bulges, (n,).  ``fraction`` is the position of each point as a fraction of the length of its
    line or arc, (n,).
    """
    start, chord = ends[:, 0], ends[:, 1] - ends[:, 0]
    half = 2.0 * np.arctan(bulge)
    bent = np.abs(bulge) > _BULGE
    # Complex numbers: the chord to the point is the whole chord, scaled and turned.
    vector = chord[:, 0] + 1j * chord[:, 1]
    size = np.where(bent, np.sin(fraction * half) / np.sin(np.where(bent, half, 1.0)), fraction)
    point = vector * size * np.exp(1j * (fraction - 1.0) * half)
    placed: F64 = start + np.column_stack([point.real, point.imag])
    return placed


def _measure_stretches(
    drawn: Dieline, after: Dieline, row: I64, target: I64, begin: F64, end: F64
) -> tuple[F64, F64]:
    """Measure the distances of q stretches of drawn edges from the cleaned edges that they became.

    ``drawn``, ``after``: dieline before and after cleaning.
    ``row``, ``target`` (q,): row in ``drawn`` of each stretch's edge, and row in ``after`` of its
    cleaned edge.
    ``begin``, ``end`` (q,): start and end of each stretch, as fractions of the drawn edge's length.
    Returns the greatest distance of each stretch from its cleaned edge, (q,) mm, and the start and
    end of the stretch on the cleaned edge, as fractions of that edge's length, (q, 2).
    """
    far = np.zeros(len(row))
    along = np.zeros((len(row), 2))
    if len(row) == 0:
        return far, along
    same = (after.ends[target] == drawn.ends[row]).all(axis=(1, 2)) & (
        after.bulge[target] == drawn.bulge[row]
    )
    along[same, 0], along[same, 1] = begin[same], end[same]
    moved = np.flatnonzero(~same)
    ends, bulge = drawn.ends[row[moved]], drawn.bulge[row[moved]]
    target_ends, bow = after.ends[target[moved]], after.bulge[target[moved]]
    chord = target_ends[:, 1] - target_ends[:, 0]
    square = (chord**2).sum(axis=1)
    bent = np.abs(bow) > _BULGE
    safe = np.where(bent, bow, 1.0)
    left = np.column_stack([-chord[:, 1], chord[:, 0]])
    centre = target_ends.mean(axis=1) + left * ((1.0 - safe * safe) / (4.0 * safe))[:, None]
    first = np.arctan2(*(target_ends[:, 0] - centre).T[::-1])
    sweep = 4.0 * np.arctan(safe)
    for probe in _PROBES:
        point = _points_at(ends, bulge, begin[moved] + probe * (end[moved] - begin[moved]))
        place = ((point - target_ends[:, 0]) * chord).sum(axis=1) / square
        angle = (np.arctan2(*(point - centre).T[::-1]) - first) * np.sign(sweep)
        # Centre the range of angles on the arc, so that angles before its start are negative.
        middle = np.abs(sweep) / 2.0
        angle = (angle - middle + math.pi) % (2.0 * math.pi) - math.pi + middle
        place = np.clip(np.where(bent, angle / np.abs(sweep), place), 0.0, 1.0)
        gap = np.hypot(*(point - _points_at(target_ends, bow, place)).T)
        far[moved] = np.maximum(far[moved], gap)
        if probe in (0.0, 1.0):
            along[moved, int(probe)] = place
    return far, along


def _are_bent(drawn: Dieline, after: Dieline, row: I64, target: I64, size: F64) -> Bool:
    """Return the mask of the stretches whose cleaned edge has another curvature, (q,).

    ``drawn``, ``after``: dieline before and after cleaning.
    ``row``, ``target``, ``size`` (q,): for each of q stretches: the row of its edge in ``drawn``,
    the row of its cleaned edge in ``after``, and its length (mm).
    """
    sweep = 4.0 * np.arctan(drawn.bulge[row]), 4.0 * np.arctan(after.bulge[target])
    length = _edge_lengths(drawn.ends[row], drawn.bulge[row])
    cleaned_length = _edge_lengths(after.ends[target], after.bulge[target])
    change = np.abs(np.abs(sweep[1]) / cleaned_length - np.abs(sweep[0]) / length)
    # The sagitta of the stretch changes by this.
    return np.asarray(change * size**2 / 8.0 > _ROUNDING)


def _check_added_work(
    after: Dieline, target: I64, along: F64, report: Callable[[int, float, Message], None]
) -> None:
    """Report each length of a cleaned edge that no drawn stretch covers, if the length is more than
    twice the gap tolerance.

    A cleaned edge that no drawn stretch became is reported too, whatever its length, unless it is
    unclassified or ignored.

    ``after``: dieline after cleaning.
    ``target`` (q,): row in ``after`` of the cleaned edge that each of q drawn stretches became.
    ``along`` (q, 2): start and end of each stretch as fractions of the length of its cleaned edge.
    ``report``: function that is called for each fault with the row of the drawn edge from which the
    cleaned edge was made, the length of the fault (mm), and a message.
    """
    length = _edge_lengths(after.ends, after.bulge)
    work_rows = np.flatnonzero(~np.isin(after.line_type, _NO_WORK))
    low, high = np.minimum(*along.T), np.maximum(*along.T)
    order = np.lexsort((low, target))
    edge, low, high = target[order], low[order], high[order]
    new = np.append(True, edge[1:] != edge[:-1]) if len(edge) else np.zeros(0, np.bool_)
    # Greatest position that earlier stretches of the same edge cover.
    reach = np.maximum.accumulate(edge + 0.5 * high) if len(edge) else high
    before = np.where(new, 0.0, np.append(0.0, (reach[:-1] - edge[1:]) * 2.0)) if len(edge) else low
    open_ = (low - before) * length[edge]
    last = np.append(new[1:], True) if len(edge) else new
    beyond = np.where(last, (1.0 - (reach - edge) * 2.0) * length[edge], 0.0)
    for at in np.flatnonzero(np.maximum(open_, beyond) > 2.0 * GAP + _ROUNDING):
        shown = int(after.source[edge[at]])
        report(shown, float(max(open_[at], beyond[at])), Message("verify.cleaning-beyond"))
    is_made = np.zeros(len(length), np.bool_)
    is_made[edge] = True
    for row in work_rows[~is_made[work_rows]]:
        report(int(after.source[row]), float(length[row]), Message("verify.cleaning-invented"))
