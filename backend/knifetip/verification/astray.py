"""Astray: work where no edge asks for it: past an end, beside an edge, or nowhere.

Trial, its stretches -> findings, and the overcut or deviation of the edge that was meant
"""

from __future__ import annotations

import numpy as np

from knifetip.messages import Message
from knifetip.model.dieline import LineType
from knifetip.verification.bench import CATCH
from knifetip.verification.columns import F64, I32, I64, Bool
from knifetip.verification.findings import MOST
from knifetip.verification.intent import TOUCHING
from knifetip.verification.kinematics import point_at
from knifetip.verification.outline import inside, outline
from knifetip.verification.overlap import overlaps
from knifetip.verification.stretches import Rows, leftover
from knifetip.verification.tools import Trade
from knifetip.verification.trial import Trial


def judge_astray(trial: Trial, rows: Rows, until: F64, past: float = 0.0) -> None:
    """Judge the work that lies on no edge, or past where it may go on one.

    Parameters
    ----------
    until : (n,) mm
        How far along each way: what comes after runs over, as it may.
    past : mm
        As much work off the board is let pass.
    """
    which, spans = leftover(rows, trial.curve)
    spans[:, 1] = np.minimum(spans[:, 1], until[which])
    point = trial.curve[which, 5] < 1e-6
    keep = point | (spans[:, 1] - spans[:, 0] > 1e-7)
    if past > 0.0 and len(which):
        bounds = outline(trial.bench.edges.of(LineType.CUT))
        middle = point_at(trial.curve[which], spans.mean(axis=1))
        short = spans[:, 1] - spans[:, 0] <= past
        keep &= ~(short & bounds.outer.any() & (inside(middle, bounds) == 0))
    which, spans = which[keep], spans[keep]
    if len(which) == 0:
        return
    size = spans[:, 1] - spans[:, 0]
    track = trial.track[which]
    # Pieces that follow each other are one.
    joined = np.zeros(len(which), np.bool_)
    joined[1:] = (
        (which[1:] == which[:-1] + 1)
        & (track[1:] == track[:-1])
        & (spans[1:, 0] <= 1e-7)
        & (spans[:-1, 1] >= trial.curve[which[:-1], 5] - 1e-7)
    )
    first = np.flatnonzero(~joined)
    total: F64 = np.add.reduceat(size, first)
    lone = trial.curve[which[first], 5] < 1e-6
    _astray(trial, which, spans, first, total, np.flatnonzero((total > trial.slack) | lone))


def _astray(trial: Trial, which: I32, spans: F64, first: I64, total: F64, bad: I64) -> None:
    """Say of pieces on no edge what they are: past an end, beside an edge, or nowhere."""
    bad = bad[:MOST]
    if len(bad) == 0 or trial.found.full:
        return
    curve, all_edges = trial.curve[which[first[bad]]], trial.bench.edges
    nothing = np.zeros(len(trial.edges))
    on = overlaps(curve, trial.edges.curve, nothing, trial.size, trial.tolerance)
    near = overlaps(curve, trial.edges.curve, nothing, trial.size, CATCH)
    other = overlaps(
        curve, all_edges.curve, np.zeros(len(all_edges)), all_edges.curve[:, 5], TOUCHING
    )
    clear = trial.bench.board.end_clearance if trial.trade == Trade.CREASE else 0.0
    tool = trial.trade.tool
    for k, group in enumerate(bad):
        line, length = int(trial.line[which[first[group]]]), float(total[group])
        span = spans[first[group]]
        if (edge := _along(on, k, span)) >= 0:
            trial.overcut(np.array([edge]), np.array([max(length - clear, 0.0)]))
            message = Message("verify.past-stop", tool=tool, length=length)
            trial.finding("overcut", edge, message, length, line=line)
            continue
        edge, measure = _beside(near, k, span)
        if edge >= 0:
            row = trial.edges.row[edge]
            trial.figures.deviation[row] = max(trial.figures.deviation[row], measure)
            message = Message("verify.beside-line", tool=tool, distance=measure)
            trial.finding("deviation", edge, message, measure, line=line)
            continue
        if (edge := _touched(on, k, span)) >= 0:
            trial.overcut(np.array([edge]), np.array([length]))
            message = Message("verify.past-end", tool=tool, length=length)
            trial.finding("overcut", edge, message, length, line=line)
            continue
        x, y = point_at(curve[k : k + 1], span[:1])[0]
        if (wrong := _along(other, k, span)) >= 0:
            row, kind = all_edges.row[wrong], LineType(int(all_edges.line_type[wrong])).word
            if length > 0.0:
                message = Message(
                    "verify.stray-along", tool=tool, length=length, edge=row, type=kind
                )
            else:
                message = Message("verify.stray-plunge-along", tool=tool, edge=row, type=kind)
        elif length > 0.0:
            message = Message("verify.stray", tool=tool, length=length, x=x, y=y)
        else:
            message = Message("verify.stray-plunge", tool=tool, x=x, y=y)
        trial.finding("stray", -1, message, length, line=line)


def _stretches(rows: Rows, curve: int, span: F64) -> tuple[slice, F64, Bool]:
    """Return one curve's rows, how much of a span of it each shares, and which run along."""
    mine = slice(*np.searchsorted(rows.curve, [curve, curve + 1]))
    along, place = rows.along[mine], rows.place[mine]
    shared = np.minimum(along[:, 1], span[1]) - np.maximum(along[:, 0], span[0])
    size = along[:, 1] - along[:, 0]
    return mine, shared, np.abs(place[:, 1] - place[:, 0]) >= 0.5 * size


def _along(rows: Rows, curve: int, span: F64) -> int:
    """Return an edge that most of the span of a curve runs along, -1 if there is none."""
    mine, shared, parallel = _stretches(rows, curve, span)
    good = np.flatnonzero((shared >= 0.5 * (span[1] - span[0])) & parallel)
    return int(rows.edge[mine][good[0]]) if len(good) else -1


def _beside(rows: Rows, curve: int, span: F64) -> tuple[int, float]:
    """Return the nearest edge that the span runs beside, and how far off it is (mm)."""
    mine, shared, parallel = _stretches(rows, curve, span)
    good = np.flatnonzero((shared >= 0.8 * (span[1] - span[0])) & parallel)
    if len(good) == 0:
        return -1, 0.0
    return int(rows.edge[mine][good[0]]), float(rows.distance[mine][good[0]])


def _touched(rows: Rows, curve: int, span: F64) -> int:
    """Return the edge that the span leaves or comes to, -1 if there is none."""
    mine, _, _ = _stretches(rows, curve, span)
    along = rows.along[mine]
    touching = (np.abs(along[:, 1] - span[0]) < 1e-6) | (np.abs(along[:, 0] - span[1]) < 1e-6)
    good = np.flatnonzero(touching)
    return int(rows.edge[mine][good[0]]) if len(good) else -1
