"""Routes for the queues of machines: list a queue, and move and change waiting jobs."""

from __future__ import annotations

from functools import partial
from typing import Annotated

from fastapi import Header, Response
from pydantic.json_schema import SkipJsonSchema

from knifetip.contract.job import Actor, ActorKind, State
from knifetip.errors import KnifetipError, PlanError
from knifetip.library.definition import Shelf, machine_of
from knifetip.messages import Message
from knifetip.service.accounts.ownership import check_own_job
from knifetip.service.compiling.service import compile_arguments, kernels_for
from knifetip.service.components import ServiceDep
from knifetip.service.database.tables import Job
from knifetip.service.http.parameters import JobId, MachineName
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.lifecycle.machine_queues import is_waiting
from knifetip.service.limits.work_queue import queued
from knifetip.service.machines.queue_estimate import remaining_seconds, start_times
from knifetip.service.order_details.models import changed_columns
from knifetip.service.orders.job_answers import job_out, jobs_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.versions import JobMatch, check_job_match
from knifetip.service.processes import tasks
from knifetip.service.processes.pool import TaskFailed
from knifetip.service.queues.models import MoveIn, QueueOut, TransferIn, WaitingChangeIn
from knifetip.service.queues.store import Place, WaitingChange, check_transferable, order_version

router = ScopedRouter(tags=["queues"])

IfMatch = Annotated[
    str | SkipJsonSchema[None],  # a header is never null
    Header(
        alias="If-Match",
        max_length=200,
        description="ETag of the queue for which the place was chosen; 412 if the order has "
        "changed. Without it only the neighbours are compared",
    ),
]


@router.get("/machines/{name}/queue")
@requires(AccessScope.VIEWER)
def get_queue(
    service: ServiceDep, principal: PrincipalDep, response: Response, name: MachineName
) -> QueueOut:
    """Get the queue of a machine in the order in which the jobs run, with estimated times.

    A key that is limited to a customer gets the entries of this customer, at their places.
    """
    service.store.library.machine(name)
    rows = service.store.queues.jobs(name)
    waiting = [row for row in rows if is_waiting(row)]
    response.headers["ETag"] = f'"{order_version(waiting)}"'
    starts = start_times(rows, service.store.library.changes(waiting))
    first = len(rows) - len(waiting)
    return QueueOut.model_validate(
        {
            "machine": name,
            "entries": [
                {
                    "place": max(index - first + 1, 0),
                    "seconds": remaining_seconds(row),
                    "starts_in": starts[index],
                    "picture": f"/api/drawings/{row.drawing}/picture",
                    "job": model,
                }
                for index, (row, model) in enumerate(
                    zip(rows, jobs_out(service.store, rows), strict=True)
                )
                if principal.limits.sees_job(row.customer, row.machine)
            ],
        }
    )


@router.post("/jobs/{id}/move")
@requires(AccessScope.OPERATOR)
def move_job(service: ServiceDep, id: JobId, move: MoveIn, match: IfMatch = None) -> JobOut:
    """Move a waiting job to a place in the queue of its machine.

    The place is given by its neighbours.  If jobs of another priority are on both sides, the job
    gets the nearest priority that permits the place.  A repeated request has no effect.  The status
    is 412 if the queue was changed so that the neighbours are not next to each other.
    """
    version = None if match is None or match.strip() == "*" else _tag(match)
    place = Place(move.previous, move.next)
    return job_out(service.store, service.store.queues.move(id, place, _actor(move.by), version))


def _tag(match: str) -> str:
    # A compressing proxy marks ETags as weak.
    return match.strip().removeprefix("W/").strip('"')


@router.patch("/jobs/{id}")
@requires(AccessScope.OPERATOR, AccessScope.ORDER)
def change_job(
    service: ServiceDep,
    principal: PrincipalDep,
    id: JobId,
    change: WaitingChangeIn,
    match: JobMatch = None,
) -> JobOut:
    """Change priority, copies or hold of a job that no machine works on yet, or order details.

    The details of the order can be changed in every state of the job; fields that the request does
    not contain stay as they are.

    A job with a new priority comes after the other jobs of that priority.  A job on hold stays in
    the queue, and its machine takes other jobs first.  A job that waits for the confirmation of the
    operator returns to the queue when it is put on hold.  A key with the scope ``order`` changes
    the jobs that it has ordered.
    """
    check_own_job(service, principal, id, tuple(State))
    values = WaitingChange(change.priority, change.copies, change.on_hold)
    details = changed_columns(change)
    row = service.store.queues.change(
        id, values, _actor(change.by), details, partial(check_job_match, match)
    )
    return job_out(service.store, row)


@router.post("/jobs/{id}/transfer")
@requires(AccessScope.OPERATOR)
@queued
def transfer_job(service: ServiceDep, id: JobId, target: TransferIn) -> JobOut:
    """Move a ready or waiting job to another machine, for which its program is compiled again.

    The job stays unchanged at its place if it cannot be made on the other machine; the response
    contains the reason.
    """
    machine = service.store.library.definition(Shelf.MACHINES, target.machine)
    row = service.store.jobs.get(id)
    if row.machine == target.machine:
        return job_out(service.store, row)
    check_transferable(row)
    try:
        arguments = compile_arguments(service.store, row, machine)
        service.warm_up.wait(*kernels_for(machine_of(machine)))
        result = service.run(tasks.compile, *arguments)
    except KnifetipError as reason:
        raise _does_not_fit(row, target.machine, reason.message) from reason
    except TaskFailed as reason:
        crash = Message("job.compile-crashed", incident=reason.incident)
        raise _does_not_fit(row, target.machine, crash) from reason
    if result.message is not None:
        raise _does_not_fit(row, target.machine, result.message)
    moved = service.store.queues.transfer(row, machine, result, _actor(target.by))
    return job_out(service.store, moved)


def _does_not_fit(row: Job, machine: str, reason: Message) -> PlanError:
    return PlanError("queue.does-not-fit", job=row.id, machine=machine, reason=reason)


def _actor(by: str) -> Actor:
    return Actor(ActorKind.OPERATOR, by)
