"""API models of jobs and of their events, built from rows of the store."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from knifetip.contract.job import State
from knifetip.messages import Message, hint, render
from knifetip.model.job_options import JobOptions
from knifetip.model.program_facts import ProgramFacts
from knifetip.service.database.tables import Job
from knifetip.service.machines.queue_estimate import Estimate, estimates
from knifetip.service.machines.waiting import WaitReason, waiting_of
from knifetip.service.order_details.models import OrderDetailsOut, details_fields
from knifetip.service.orders.models import JobEvent, JobOut
from knifetip.service.orders.operator_actions import allowed_actions
from knifetip.service.orders.tracks_left import first_advice
from knifetip.service.runs.stop_place import executed_at_most
from knifetip.service.store import Store


def job_out(store: Store, row: Job) -> JobOut:
    """Return the API model of a job from its row in the store."""
    return jobs_out(store, [row])[0]


def jobs_out(store: Store, rows: Sequence[Job]) -> list[JobOut]:
    """Return the API models of jobs from their rows in the store, in the same order."""
    now = store.database.clock()
    remaining = store.jobs.remaining_copies(rows)
    estimated = estimates(store, rows)
    return [
        _job_out(
            row,
            waiting,
            first_advice(store, row, waiting.message or row.message, now),
            remaining.get(row.id, 0),
            now,
            estimated.get(row.id, Estimate()),
        )
        for row, waiting in zip(rows, waiting_of(store, rows), strict=True)
    ]


def _job_out(
    row: Job,
    waiting: WaitReason,
    message: Message | None,
    remaining: int,
    now: float,
    estimate: Estimate,
) -> JobOut:
    computed = {
        "verdict", "progress", "waiting_for", "actions", "reason", "hint", "message", "is_rest",
        "remaining_copies", "queue_position", "estimated_start", "no_estimate", "stopped_at",
        *OrderDetailsOut.model_fields, *JobOptions.model_fields,
        *ProgramFacts.model_fields,
    }  # fmt: skip
    fields: dict[str, Any] = {
        name: getattr(row, name) for name in set(JobOut.model_fields) - computed
    }
    return JobOut.model_validate(
        {
            **fields,
            **details_fields(row),
            **dict(row.options),
            **row.facts,
            "waiting_for": waiting.waiting_for,
            "message": message,
            "reason": render(message) if message else "",
            "hint": hint(message) if message else "",
            "actions": allowed_actions(row, now),
            "stopped_at": _stop_place_out(row),
            "verdict": row.verdict_summary,
            "progress": progress(row),
            "is_rest": row.rest is not None,
            "remaining_copies": remaining,
            "queue_position": estimate.place,
            "estimated_start": None if estimate.starts_in is None else now + estimate.starts_in,
            "no_estimate": estimate.missing,
        }
    )


def _stop_place_out(row: Job) -> dict[str, Any] | None:
    """Return the place where the machine stopped a job, and how far it is known."""
    if row.stopped_at is None:
        return None
    line, most = int(row.stopped_at["line"]), executed_at_most(row)
    place = {name: row.stopped_at[name] for name in ("line", "position", "station")}
    return {**place, "line_at_most": most, "certain": most <= max(line, row.line)}


def progress(row: Job) -> float:
    """Return the completed fraction of a job, 0 … 1.

    Before the job is queued, this is the completed fraction of the compile.  It is 0 while the job
    is queued, and then the executed fraction of the program lines of all copies.
    """
    match row.state:
        case State.DONE:
            return 1.0
        case (
            State.RUNNING
            | State.HELD
            | State.INTERRUPTED
            | State.SCRAPPED
            | State.CONTINUED
            | State.CANCELLED
        ):
            executed = row.line / row.lines if row.lines else 0.0
            # Between two copies ``line`` is the last line of the completed copy, already counted.
            if row.copies_done and executed >= 1.0:
                executed = 0.0
            return min((row.copies_done + executed) / row.copies, 1.0)
        case State.QUEUED:
            return 0.0
        case _:
            return row.progress


def job_events(store: Store, id: str) -> list[JobEvent]:
    """Return the API models of the events of a job."""
    return [
        JobEvent.model_validate(
            {
                "id": event.id,
                "job": event.subject,
                "at": event.at,
                "state": event.state,
                "who": event.who,
                "why": render(event.message) if event.message else "",
                "message": event.message,
            }
        )
        for event in store.events.of_job(id)
    ]
