"""outcomes: report the outcome of cleaning for every drawn edge.

Outcomes and lengths are computed from the assignment of stretches of drawn edges to current edges
alone, so they always agree with the geometry.
"""

from __future__ import annotations

from dataclasses import replace
from typing import Final, NamedTuple

import numpy as np

from knifetip.cleaning.deviation import measure_deviation, measured_edges
from knifetip.cleaning.raise_to import raise_to
from knifetip.cleaning.state import CleaningState
from knifetip.geometry import arc
from knifetip.geometry.columns import F64, I32, I64, U8, Bool
from knifetip.geometry.tolerance import SAME
from knifetip.model.cleaned import Cleaned, CleaningReason, Stretches
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.drawing import ImportOutcome

#: Lengths that differ by less are equal up to rounding (mm).
_HAIR: Final = 1e-9


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


def report_outcomes(dieline: Dieline, length: F64, at_work: Bool, state: CleaningState) -> Cleaned:
    """Return the cleaned dieline, with the outcome of every drawn edge.

    Current edges whose stretches all overlap another edge get them back: ``state`` is changed.

    Parameters
    ----------
    dieline
        The n drawn edges.
    length : (n,) mm
        Their lengths.
    at_work : (n,)
        Mask of the drawn edges whose line type is cut or creased.
    state
        The current edges after the last step of cleaning.
    """
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
    fit_error[slot] = state.fit_error
    raise_to(fit_error, target[target >= 0], dieline.fit_error[row[target >= 0]])
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
    longer = np.flatnonzero(np.abs(cleaned_length - drawn_length) >= _HAIR)
    np.add.at(added, source[longer], (cleaned_length - drawn_length)[longer])
    moved = np.zeros(count)
    raise_to(moved, source, state.moved)
    deviation = np.zeros(count)
    far = measure_deviation(
        measured_edges(dieline.ends, dieline.bulge),
        measured_edges(ends, bulge),
        row,
        low,
        high,
        target,
    )
    raise_to(deviation, row, far)
    # A stretch that nearly coincides with another edge is moved to it.
    near = live & overlapping & (far > SAME)
    raise_to(moved, row[near], far[near])
    is_near = np.zeros(count, np.bool_)
    is_near[row[near]] = True
    target_row = _main_row(row, size, target, overlapping, count)
    target_row[~at_work] = np.flatnonzero(~at_work)
    outcome, reason = _outcomes(
        state,
        _FinalRows(row, edge, overlapping, slot, source, target_row),
        _Lengths(kept, merged, moved, summed(state.off_panel[order])),
        at_work,
        is_near,
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


def _is_ascending(column: I64) -> bool:
    """Return whether each entry of a column is greater than the one before it."""
    return bool((column[1:] > column[:-1]).all())


def _slots(state: CleaningState, count: int) -> tuple[I64, I64]:
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


def _main_row(row: I64, size: F64, target: I64, overlapping: Bool, count: int) -> I32:
    """Return the row of the cleaned edge that replaces each of n drawn edges, (n,); -1 if dropped.

    A drawn edge consists of stretches, each of which belongs to one cleaned edge or is debris.  The
    result is the row of the cleaned edge to which the longest stretch belongs.  A stretch that
    overlaps another edge is considered only if all stretches of the drawn edge do so.

    ``row``, ``size``, ``target``, ``overlapping`` (q,): for each of q stretches: its drawn edge,
    its length (mm), the row of its cleaned edge (-1 for debris), and whether it overlaps another
    edge.
    ``count``: number n of drawn edges.
    """
    target_row = np.full(count, -1, np.int32)
    order = np.flatnonzero(target >= 0)
    if not _is_ascending(row[order]):
        order = order[np.lexsort((size[order], ~overlapping[order], row[order]))]
    # The last assignment to each row counts.
    target_row[row[order]] = target[order]
    return target_row


def _outcomes(
    state: CleaningState, final_rows: _FinalRows, lengths: _Lengths, at_work: Bool, is_near: Bool
) -> tuple[U8, U8]:
    """Return the outcome and the reason for it, as codes, for each of n drawn edges, (n,) each.

    The outcomes are ``ImportOutcome`` codes (kept, merged or dropped), and the reasons are
    ``CleaningReason`` codes.

    ``state``: the current edges after the last step of cleaning.
    ``final_rows``: indices that relate the drawn edges to the current edges and to the cleaned
    edges.
    ``lengths``: kept length, merged length and displacement of each drawn edge (mm).
    ``at_work`` (n,): mask of the drawn edges whose line type is cut or creased.
    ``is_near`` (n,): mask of the drawn edges of which a part was moved to an edge that it nearly
    coincided with.
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
        np.where(is_near[away], CleaningReason.NEAR, CleaningReason.TWICE),
    )
    lost = at_work & (target_row < 0)
    reason[lost] = np.where(off_panel[lost] > 0.0, CleaningReason.OFF_PANEL, CleaningReason.SPECK)
    reason[lost & state.looped] = CleaningReason.LOOP
    reason[~at_work] = CleaningReason.NO_WORK
    outcome = np.full(count, ImportOutcome.KEPT, np.uint8)
    outcome[away] = ImportOutcome.MERGED
    outcome[lost] = ImportOutcome.DROPPED
    return outcome, reason
