"""Stops: where a knife goes in and comes out, seen from the edges that it cuts.

StationCheck of a knife, KnifeEnds -> findings, and how far every track runs over its end
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.messages import Message
from knifetip.verification.checks.check_base import StationCheck
from knifetip.verification.checks.check_context import NEAR_EDGE, PRINT_TURN
from knifetip.verification.columns import F64, I64, Bool
from knifetip.verification.curves.curve import azimuth_at, point_at
from knifetip.verification.expectation.edges import (
    JOIN_DISTANCE,
    TOUCH_DISTANCE,
    Edges,
    pairs_within,
)
from knifetip.verification.expectation.expected_work import KnifeEnds
from knifetip.verification.findings import MAX_FINDINGS


def check_track_ends(
    trial: StationCheck,
    whole: Edges,
    solid: I64,
    ends: KnifeEnds,
    dashed: Bool,
    lead: float,
    overrun: float,
) -> F64:
    """Judge where the knife goes in and comes out; return how far tracks run over (mm).

    Tracks that begin where the last one ended, as at a corner turned in the air, are one run.
    A run begins at an end of an edge, unless it is closed.  It stops where an end of an edge
    says, or, if it is closed, on its own way, ``overrun`` from where it began.
    """
    count = len(dashed)
    over = np.zeros(count)
    if count == 0:
        return over
    first = np.searchsorted(trial.track, np.arange(count))
    last = np.searchsorted(trial.track, np.arange(count), side="right") - 1
    start = point_at(trial.curve[first], np.zeros(count))
    stop = point_at(trial.curve[last], trial.curve[last, 5])
    ahead = azimuth_at(trial.curve[last], trial.curve[last, 5])

    known = np.flatnonzero(~np.isnan(ends.stop[:, 0]))
    run_over = np.zeros(count, np.bool_)
    run_over[pairs_within(stop, ends.stop[known[ends.meets[known]]], trial.tolerance)[0]] = True
    new = np.ones(count, np.bool_)
    jump = np.hypot(*(start[1:] - stop[:-1]).T)
    # Beside where one run has run over an end another may begin, but not at the same place.
    new[1:] = jump > np.where(run_over[:-1], PRINT_TURN, JOIN_DISTANCE)
    opens = np.flatnonzero(new)
    closes = np.concatenate([opens[1:], [count]]) - 1
    plain = ~dashed[opens]
    opens, closes = opens[plain], closes[plain]
    if len(opens) == 0:
        return over

    reached = np.cumsum(trial.curve[:, 5])
    size = reached[last[closes]] - reached[first[opens]] + trial.curve[first[opens], 5]
    # A way round that is shorter than the overrun is run over once.
    ring = _points_along_runs(trial, first[opens], last[closes], np.minimum(overrun, size / 2.0))
    gap = np.hypot(*(stop[closes] - ring).T)
    closed = gap <= trial.slack

    run, end = pairs_within(stop[closes], ends.stop[known], NEAR_EDGE)
    end = known[end]
    away = np.hypot(*(stop[closes[run]] - ends.stop[end]).T)
    order = np.lexsort((away, run))
    run, end, away = run[order], end[order], away[order]
    nearest = np.unique(run, return_index=True)[1]
    run, end, away = run[nearest], end[nearest], away[nearest]
    planned = np.full(len(opens), -1, np.int64)
    distance = np.full(len(opens), np.inf)
    planned[run], distance[run] = end, away
    right = (distance <= trial.slack) & (~closed | (distance < gap))

    # Where no end is near, ``planned`` is -1: the last, which neither meets nor is free.
    ran = right & np.append(ends.meets, False)[planned]
    over[closes[ran]] = overrun
    trial.overcut(solid[planned[ran] // 2], np.full(int(ran.sum()), overrun))
    short = right & np.append(ends.free, False)[planned]
    # Cuts drawn over each other end together.
    free = known[ends.free[known]]
    together = pairs_within(ends.stop[planned[short]], ends.stop[free], JOIN_DISTANCE)[1]
    _record_setback(trial, whole, solid, ends, np.unique(free[together]), lead)

    for k in np.flatnonzero(~closed & ~right)[:MAX_FINDINGS]:
        work = int(last[closes[k]])
        edge = int(solid[planned[k] // 2]) if planned[k] >= 0 else -1
        # A closed way that stops elsewhere on itself is nearest to its own planned end.
        if gap[k] < min(distance[k], NEAR_EDGE):
            target, measure, edge = ring[k], float(gap[k]), -1
        elif planned[k] >= 0:
            target, measure = ends.stop[planned[k]], float(distance[k])
        else:
            trial.finding(
                "uncut",
                -1,
                Message("verify.comes-out-anywhere"),
                float(gap[k]),
                work,
            )
            continue
        angle = math.radians(float(ahead[closes[k]]))
        x, y = stop[closes[k]] - target
        past = x * math.cos(angle) + y * math.sin(angle) > 0.0
        trial.finding(
            "overcut" if past else "uncut",
            edge,
            Message(
                "verify.comes-out-past" if past else "verify.comes-out-short", distance=measure
            ),
            measure,
            work,
        )

    begun = np.zeros(len(opens), np.bool_)
    begun[pairs_within(start[opens], whole.ends, TOUCH_DISTANCE)[0]] = True
    for k in np.flatnonzero(~begun & ~closed & right)[:MAX_FINDINGS]:
        trial.finding(
            "overcut",
            int(solid[planned[k] // 2]),
            Message("verify.goes-in-anywhere"),
            0.0,
            int(first[opens[k]]),
        )
    return over


def overrun_starts(trial: StationCheck, over: F64) -> F64:
    """Return how far along each way its track begins to run over (mm)."""
    until = trial.curve[:, 5].copy()
    track = np.flatnonzero(over > 0.0)
    at = np.searchsorted(trial.track, track, side="right") - 1
    left = over[track]
    while len(at):
        size = until[at].copy()
        until[at] = np.maximum(size - left, 0.0)
        on = (left > size) & (at > 0)
        on &= trial.track[at] == trial.track[at - 1]
        at, left = at[on] - 1, (left - size)[on]
    return until


def _points_along_runs(trial: StationCheck, first: I64, last: I64, distance: F64) -> F64:
    """Return the points at a distance (mm) along runs, from where they begin, (n, 2)."""
    at, left = first.copy(), distance
    while True:
        size = trial.curve[at, 5]
        on = (left > size) & (at < last)
        if not on.any():
            return point_at(trial.curve[at], np.minimum(left, size))
        left = np.where(on, left - size, left)
        at = np.where(on, at + 1, at)


def _record_setback(
    trial: StationCheck, whole: Edges, solid: I64, ends: KnifeEnds, which: I64, lead: float
) -> None:
    """Take off what a knife need not cut at free ends at which it stops."""
    paths = ends.paths
    path = paths.path[which // 2]
    begin = np.zeros(len(paths.length))
    finish = paths.length.copy()
    at_last = paths.last[path] == which
    finish[path[at_last]] -= lead
    begin[path[~at_last]] += lead
    low, high = paths.stretch(begin, finish, whole.curve)
    trial.figures.setback[whole.row] += whole.curve[:, 5] - np.maximum(high - low, 0.0)
    trial.low[solid], trial.high[solid] = low, high
