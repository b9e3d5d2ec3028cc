"""Places of jobs in the queues of their machines, and estimates of when they start."""

from __future__ import annotations

from collections.abc import Container, Sequence
from typing import Literal, NamedTuple, TypeAlias

from knifetip.contract.job import State
from knifetip.service.database.tables import Job
from knifetip.service.lifecycle.machine_queues import is_waiting
from knifetip.service.machines.waiting import ABSENT
from knifetip.service.store import Store

NoEstimate: TypeAlias = Literal["", "hold", "check", "compile", "interrupted", "gateway"]


class Estimate(NamedTuple):
    """Place of a job in its queue and estimated start, or why there is none."""

    place: int | None = None  #: from 1; None for a job that waits in no queue
    starts_in: float | None = None  #: s
    missing: NoEstimate = ""  #: why there is no estimate of a waiting job


def estimates(store: Store, rows: Sequence[Job]) -> dict[str, Estimate]:
    """Return the estimates of those jobs that wait in a queue, by id of the job."""
    machines = {row.machine for row in rows if is_waiting(row)}
    if not machines:
        return {}
    connected = store.machines.connected_machines(ABSENT)
    found: dict[str, Estimate] = {}
    for machine in machines:
        queue = store.queues.jobs(machine)
        outdated = store.library.changes(queue)
        blocked = any(row.state == State.INTERRUPTED for row in queue)
        place = 0
        for row, start in zip(queue, start_times(queue, outdated), strict=True):
            if not is_waiting(row):
                continue
            place += 1
            missing: NoEstimate = ""
            if row.on_hold:
                missing = "hold"
            elif row.check_refusal is not None:
                missing = "check"
            elif row.id in outdated:
                missing = "compile"
            elif blocked:
                missing = "interrupted"
            elif machine not in connected:
                missing = "gateway"
            found[row.id] = Estimate(place, None if missing else start, missing)
    return found


def remaining_seconds(row: Job) -> float:
    """Return the estimated machine time of the copies of a job that remain (s)."""
    remaining = max(row.copies - row.copies_done, 0)
    if row.seconds_left is None or row.state not in (State.RUNNING, State.HELD):
        return remaining * row.seconds
    return row.seconds_left + max(remaining - 1, 0) * row.seconds


def start_times(rows: Sequence[Job], outdated: Container[str] = ()) -> list[float | None]:
    """Return the times after which jobs start (s), None if a time cannot be estimated.

    Parameters
    ----------
    rows
        The jobs of a machine in the order in which they run.
    outdated
        Ids of the jobs that must be compiled again before their machine claims them.
    """
    blocked = any(row.state == State.INTERRUPTED for row in rows)
    starts: list[float | None] = []
    total = 0.0
    for row in rows:
        kept = row.on_hold or row.check_refusal is not None
        if kept or blocked or (is_waiting(row) and row.id in outdated):
            starts.append(None)
            continue
        starts.append(total)
        total += remaining_seconds(row)
    return starts
