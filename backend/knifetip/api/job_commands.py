"""Routes for the commands of users to a job, such as release, confirm, hold and cancel."""

from __future__ import annotations

from functools import partial

from knifetip.api.exceptions import accept_in_block, chosen_shortfalls
from knifetip.api.job_models import job_out
from knifetip.api.parameters import CommandKey, JobId
from knifetip.api.principal import Principal, PrincipalDep, demand
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.jobs import ConfirmIn, JobOut, ResumeIn
from knifetip.api.schemas.orders import ExceptionsIn
from knifetip.api.service import Service, ServiceDep
from knifetip.jobs.accounts.acting import acting_owner, credited
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.job import Actor, ActorKind, State
from knifetip.jobs.tool_check import ToolCheck
from knifetip.messages import Message
from knifetip.model.verdict import Acceptance

_BEFORE_QUEUE = (State.RECEIVED, State.COMPILING, State.READY, State.REFUSED)

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.post("/{id}/exceptions")
@requires(AccessScope.DESIGNER)
def accept_shortfalls(
    service: ServiceDep, id: JobId, exceptions: ExceptionsIn, key: CommandKey
) -> JobOut:
    """Accept shortfalls of a refused job, each by its edge and the code of its finding.

    A shortfall is something that the tool cannot make as it is drawn, although the program is safe.
    The verdict keeps for each accepted shortfall who accepted it, when and why.  If nothing else
    refuses the program, the state of the job becomes ``ready``, or ``queued`` for a job that was
    created with ``release``.  Faults cannot be accepted: the status is then 422.  The status is 409
    if the job is not ``refused``.
    """
    chosen = chosen_shortfalls(exceptions)
    acceptance = Acceptance(
        credited(exceptions.by), exceptions.reason, service.store.database.clock()
    )
    row = service.store.operators.accept(
        id,
        partial(accept_in_block, chosen=chosen, acceptance=acceptance),
        Actor(ActorKind.OPERATOR, exceptions.by),
        Message(
            "job.exceptions-accepted",
            by=exceptions.by,
            count=len(chosen),
            reason=exceptions.reason,
        ),
        key,
    )
    return job_out(service.store, row)


@router.post("/{id}/release")
@requires(AccessScope.OPERATOR)
def release_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Queue a job that has the state ``ready``, so that its machine can claim it.

    A job that was released before and is queued, on its machine or done stays as it is; the status
    is 200.
    """
    return job_out(service.store, service.store.operators.release(id, key))


@router.post("/{id}/recompile")
@requires(AccessScope.DESIGNER)
def recompile_job(
    service: ServiceDep, principal: PrincipalDep, id: JobId, key: CommandKey
) -> JobOut:
    """Compile a job again for the newest versions of its machine and its board.

    This is necessary if one of them has changed since the compile.  A job that was queued is queued
    again when its new program is accepted.  The status is 409 if the job is neither ``ready`` nor
    ``queued``, or if its machine or board was deleted.
    """
    check_withdrawal(service, principal, id)
    return job_out(service.store, service.store.operators.recompile(id, key))


@router.post("/{id}/confirm")
@requires(AccessScope.OPERATOR)
def confirm_job(
    service: ServiceDep, id: JobId, key: CommandKey, confirmation: ConfirmIn | None = None
) -> JobOut:
    """Confirm that table, board and tools are ready; then the machine starts.

    A job can make several copies, each on a new sheet.  Between two copies, the request confirms
    that the next sheet is on the table.  If a gateway claims the job again, a new confirmation is
    necessary.  The status is 409 if the job does not wait for a confirmation, if the request names
    another board than the job or not all stations that the program uses, or if a tool is at the end
    of its life and the request states neither that it was changed nor why it stays in use.
    """
    confirmed = confirmation or ConfirmIn()
    return job_out(
        service.store,
        service.store.operators.confirm(
            id,
            confirmed.board or "",
            confirmed.by,
            ToolCheck(confirmed.stations, confirmed.changed, confirmed.worn_reason.strip()),
            key,
        ),
    )


@router.post("/{id}/hold")
@requires(AccessScope.OPERATOR)
def hold_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Request to hold a job; its state is ``held`` as soon as the machine has stopped."""
    return job_out(service.store, service.store.operators.hold(id, key))


@router.post("/{id}/resume")
@requires(AccessScope.OPERATOR)
def resume_job(
    service: ServiceDep, id: JobId, key: CommandKey, resume: ResumeIn | None = None
) -> JobOut:
    """Request to resume a held job.

    A job can make several copies, each on a new sheet.  If the job is held between two copies,
    the call also confirms that the sheet of the next copy is on the table.  If its machine does not
    report the end of a program, the call confirms the end.  The status is 409 if the job went on
    since the phase that the request names.
    """
    phase = None if resume is None else resume.phase
    return job_out(service.store, service.store.operators.resume(id, phase, key))


@router.post("/{id}/cancel")
@requires(AccessScope.DESIGNER)
def cancel_job(service: ServiceDep, principal: PrincipalDep, id: JobId, key: CommandKey) -> JobOut:
    """Cancel a job: a running job when the machine has stopped, any other job immediately.

    A cancelled job stays as it is; the status is 200.  Designers can cancel the jobs that they have
    ordered, until these are queued.
    """
    check_withdrawal(service, principal, id)
    return job_out(service.store, service.store.operators.cancel(id, key))


@router.post("/{id}/finish")
@requires(AccessScope.OPERATOR)
def finish_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Declare that all sheets of an interrupted job are complete."""
    return job_out(service.store, service.store.interrupted.declare_finished(id, key))


@router.post("/{id}/requeue")
@requires(AccessScope.OPERATOR)
def requeue_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Queue an interrupted job again, from its first program line; the table must be clear."""
    return job_out(service.store, service.store.interrupted.requeue(id, key))


@router.post("/{id}/scrap")
@requires(AccessScope.OPERATOR)
def scrap_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Give up an interrupted job and free the table of its machine."""
    return job_out(service.store, service.store.interrupted.scrap(id, key))


def check_withdrawal(service: Service, principal: Principal, id: str) -> None:
    """Raise ``AccessDenied`` unless a principal may withdraw a job.

    Operators may do so with all jobs, designers with those that they have ordered and that are not
    queued yet.
    """
    if AccessScope.OPERATOR in principal.scopes:
        return
    row = service.store.jobs.get(id)
    if row.state not in (*_BEFORE_QUEUE, State.CANCELLED) or row.ordered_by != acting_owner():
        demand(principal, AccessScope.OPERATOR)
