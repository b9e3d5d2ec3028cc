"""Routes for the commands of users to a job, such as release, confirm, hold and cancel."""

from __future__ import annotations

from functools import partial

from knifetip.contract.job import Actor, ActorKind, State
from knifetip.messages import Message
from knifetip.model.verdict import Acceptance
from knifetip.service.accounts.ownership import check_own_job, check_withdrawal
from knifetip.service.components import ServiceDep
from knifetip.service.database.acting import credited_name
from knifetip.service.http.parameters import CommandKey, JobId
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.orders.exceptions import accept_in_block, chosen_shortfalls
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import ConfirmIn, EndIn, JobOut, ResumeIn
from knifetip.service.orders.order_models import ExceptionsIn
from knifetip.service.tools.check import ToolCheck

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.post("/{id}/exceptions")
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def accept_shortfalls(
    service: ServiceDep,
    principal: PrincipalDep,
    id: JobId,
    exceptions: ExceptionsIn,
    key: CommandKey,
) -> JobOut:
    """Accept shortfalls of a refused job, each by its edge and the code of its finding.

    A shortfall is something that the tool cannot make as it is drawn, although the program is safe.
    The verdict keeps for each accepted shortfall who accepted it, when and why.  If nothing else
    refuses the program, the state of the job becomes ``ready``, or ``queued`` for a job that was
    created with ``release``.  Faults cannot be accepted: the status is then 422.  The status is 409
    if the job is not ``refused``.
    """
    if AccessScope.DESIGNER not in principal.scopes:
        check_own_job(service, principal, id)
    chosen = chosen_shortfalls(exceptions)
    acceptance = Acceptance(
        credited_name(exceptions.by), exceptions.reason, service.store.database.clock()
    )
    row = service.store.programs.accept(
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
@requires(AccessScope.OPERATOR, AccessScope.ORDER)
def release_job(service: ServiceDep, principal: PrincipalDep, id: JobId, key: CommandKey) -> JobOut:
    """Queue a job that has the state ``ready``, so that its machine can claim it.

    A job that was released before and is queued, on its machine or done stays as it is; the status
    is 200.  A key with the scope ``order`` releases the jobs that it has ordered.
    """
    check_own_job(service, principal, id, tuple(State))
    return job_out(service.store, service.store.programs.release(id, key))


@router.post("/{id}/recompile")
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def recompile_job(
    service: ServiceDep, principal: PrincipalDep, id: JobId, key: CommandKey
) -> JobOut:
    """Compile a job again for the newest versions of its machine and its board.

    This is necessary if one of them has changed since the compile.  A job that was queued is queued
    again when its new program is accepted.  The status is 409 if the job is neither ``ready`` nor
    ``queued``, or if its machine or board was deleted.
    """
    check_withdrawal(service, principal, id)
    return job_out(service.store, service.store.programs.recompile(id, key))


@router.post("/{id}/recheck")
@requires(AccessScope.OPERATOR)
def recheck_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Let the machine take a job again whose program it has not begun.

    Such a job is ``queued`` and has a ``check_refusal``; other jobs of the queue go on.  Correct
    the cause first.  The status is 409 if no machine has refused the program of the job.
    """
    return job_out(service.store, service.store.programs.recheck(id, key))


@router.post("/{id}/confirm")
@requires(AccessScope.STATION)
def confirm_job(
    service: ServiceDep, id: JobId, key: CommandKey, confirmation: ConfirmIn | None = None
) -> JobOut:
    """Confirm what was checked at the machine; then the machine starts.

    `checked` names every one of the `checks` of `GET /api/jobs/{id}/confirmation`, also for the
    next copy of a job, and if a gateway claims the job again.  The status is 409 if a check is
    missing, if the job does not wait for a confirmation, or if a tool is at the end of its life and
    the request states neither that it was changed nor why it stays in use.  An unknown check is
    refused with 422.
    """
    confirmed = confirmation or ConfirmIn()
    return job_out(
        service.store,
        service.store.operators.confirm(
            id,
            frozenset(confirmed.checked),
            confirmed.by,
            ToolCheck(confirmed.changed, confirmed.worn_reason.strip()),
            key,
        ),
    )


@router.post("/{id}/hold")
@requires(AccessScope.OPERATOR, AccessScope.STATION)
def hold_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Request to hold a job; its state is ``held`` as soon as the machine has stopped."""
    return job_out(service.store, service.store.operators.hold(id, key))


@router.post("/{id}/resume")
@requires(AccessScope.STATION)
def resume_job(
    service: ServiceDep, id: JobId, key: CommandKey, resume: ResumeIn | None = None
) -> JobOut:
    """Request to resume a job that is held in a copy.

    The machine moves at once, so a person must have stated that hands are clear of it.  The status
    is 409 without that statement, if the job waits for its confirmation or for a new sheet
    (`confirm`), if it waits until a person has seen the end of its program (`end`), or if it went
    on since the phase that the request names.
    """
    asked = ResumeIn() if resume is None else resume
    operators = service.store.operators
    row = operators.resume(id, asked.phase, key, hands_clear=asked.hands_clear)
    return job_out(service.store, row)


@router.post("/{id}/end")
@requires(AccessScope.STATION)
def confirm_end(
    service: ServiceDep, id: JobId, key: CommandKey, end: EndIn | None = None
) -> JobOut:
    """State that the machine has executed the program, if its controller does not report it.

    A person has seen that the machine is at rest.  The job is then done, or waits for the sheet of
    its next copy, which starts with a confirmation only.  The status is 409 if the job does not
    wait for the end of a program, or if it went on since the phase that the request names.
    """
    phase = None if end is None else end.phase
    return job_out(service.store, service.store.operators.confirm_end(id, phase, key))


@router.post("/{id}/cancel")
@requires(AccessScope.DESIGNER, AccessScope.ORDER, AccessScope.STATION)
def cancel_job(service: ServiceDep, principal: PrincipalDep, id: JobId, key: CommandKey) -> JobOut:
    """Cancel a job: a running job when the machine has stopped, any other job immediately.

    A cancelled job stays as it is; the status is 200.  Designers can cancel the jobs that they have
    ordered, until these are queued; a key with the scope ``order`` can cancel those that it has
    ordered, until they are on a machine; the person at a machine those that are on it or wait for
    it.
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
