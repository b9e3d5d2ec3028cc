"""Routes for jobs: create, list, read, and commands such as release, confirm, hold and cancel."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial
from typing import Annotated, Any

from fastapi import Query, Request, Response
from fastapi.responses import PlainTextResponse

from knifetip.api.exceptions import accept_in_block, find_same_exceptions
from knifetip.api.overrides import merge_overrides
from knifetip.api.parameters import CommandKey, DataFormat, IdempotencyKey, JobId
from knifetip.api.principal import Principal, PrincipalDep, demand
from knifetip.api.queue import queued
from knifetip.api.queue_estimate import Estimate, estimates
from knifetip.api.revisions import check_revision
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.jobs import ConfirmIn, JobEvent, JobOut, JobsQuery, ResumeIn
from knifetip.api.schemas.order_details import (
    OrderDetailsOut,
    details_columns,
    details_fields,
    details_filter,
)
from knifetip.api.schemas.orders import ExceptionsIn, JobIn
from knifetip.api.schemas.verdicts import EarlierExceptions, VerdictOut, VerdictSummary
from knifetip.api.service import (
    BINARY,
    Service,
    ServiceDep,
    bytes_response,
    customer_rules,
    fingerprint,
    set_next_page,
)
from knifetip.api.waiting import Waiting, language_of, waiting_of
from knifetip.errors import OpenQuestions
from knifetip.jobs import tasks
from knifetip.jobs.accounts.acting import acting_owner, credited
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.interpretations import interpretation_of
from knifetip.jobs.job import Actor, ActorKind, State
from knifetip.jobs.job_store import JobFilter, JobOrder
from knifetip.jobs.operator_actions import allowed_actions
from knifetip.jobs.readings import StoredDrawing
from knifetip.jobs.request_key import RequestKey
from knifetip.jobs.store import Store
from knifetip.jobs.tables import Drawing, Job
from knifetip.jobs.tool_check import ToolCheck
from knifetip.library.definition import Shelf
from knifetip.messages import Message, hint, render
from knifetip.model.acceptance import Exceptions, Shortfall
from knifetip.model.choices import Choices
from knifetip.model.corners import Corners
from knifetip.model.interpretation import Interpretation
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import EDGE_COLUMNS, Acceptance
from knifetip.presentation.columns import unpack_columns
from knifetip.presentation.verdict import areas_json, unpack_areas

_BEFORE_QUEUE = (State.RECEIVED, State.COMPILING, State.READY, State.REFUSED)

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER)
@queued
def order_job(
    service: ServiceDep,
    principal: PrincipalDep,
    response: Response,
    order: JobIn,
    key: IdempotencyKey = None,
) -> JobOut:
    """Create a job; the server then compiles and verifies its program in the background.

    Meanwhile the state of the job is ``received``, then ``compiling``.  If the user must first
    answer questions about the drawing, the status is 409 and the response contains the
    ``questions``.
    """
    return create_job(service, principal, response, order, key)


def create_job(
    service: Service, principal: Principal, response: Response, order: JobIn, key: str | None
) -> JobOut:
    """Create the job of an order, or find the one that was created under the same key.

    Parameters
    ----------
    service, principal
        The server, and the sender of the request.
    response
        Gets the header ``Location``.
    order
        The order.
    key
        Idempotency-Key of the request, None if it has none.
    """
    if order.release:
        demand(principal, AccessScope.OPERATOR)
    request = RequestKey(key, fingerprint(order.model_dump_json())) if key else None
    row = service.store.jobs.find(request) if request else None
    if row is None:
        row = place_order(service, order, request)
    response.headers["Location"] = f"/api/jobs/{row.id}"
    return job_out(service.store, row)


def place_order(service: Service, order: JobIn, key: RequestKey | None) -> Job:
    """Store a job for an order and return it.

    Raises
    ------
    OpenQuestions
        The user must first answer questions about the drawing.
    KnifetipError
        The drawing, the machine or the board is unknown, or the order is not permitted.
    """
    machine = service.store.library.definition(Shelf.MACHINES, order.machine)
    board = service.store.library.definition(Shelf.BOARDS, order.board)
    # Questions, the stored job and the compile all use this one revision.
    drawing = service.store.drawings.get_with(order.drawing, "content", "overrides", "edges")
    check_revision(order.revision, drawing)
    interpretation = _interpretation(service, order, drawing)
    questions = service.run(
        tasks.open_questions,
        StoredDrawing(
            drawing.content, drawing.edges, interpretation_of(drawing, drawing.overrides)
        ),
        interpretation,
        machine,
    )
    if questions:
        raise OpenQuestions(questions)
    ordered = JobOrder(
        machine=order.machine,
        board=order.board,
        interpretation=interpretation,
        copies=order.copies,
        priority=order.priority,
        release=order.release,
        exceptions=_exceptions(service, order.exceptions),
        machine_version=machine.version,
        board_version=board.version,
        details=details_columns(order),
    )
    return service.store.jobs.add(drawing, ordered, key)


def _exceptions(service: Service, ordered: ExceptionsIn | None) -> Exceptions | None:
    """Return the exceptions that an order contains, None for none; they are accepted now."""
    if ordered is None:
        return None
    chosen = tuple(sorted(_shortfalls(ordered)))
    return Exceptions(
        chosen, Acceptance(credited(ordered.by), ordered.reason, service.store.database.clock())
    )


def _shortfalls(exceptions: ExceptionsIn) -> set[Shortfall]:
    return {(one.edge, one.code) for one in exceptions.findings}


def _interpretation(service: Service, order: JobIn, drawing: Drawing) -> Interpretation:
    """Return the interpretation of a drawing that applies to a new job.

    It is the stored interpretation (unit, profile, line types of edges), with the changes that the
    request contains.

    Parameters
    ----------
    service
        The server.
    order
        The request; it can contain a profile, line types of edges, and the choices for the job.
    drawing
        The stored drawing.
    """
    interpretation = interpretation_of(drawing, drawing.overrides)
    if order.profile is not None:
        rules = customer_rules(service, order.profile)
        interpretation = replace(interpretation, profile=order.profile, rules=rules)
    if order.overrides:
        overrides = merge_overrides(drawing.edges, drawing.overrides, order.overrides)
        interpretation = replace(interpretation, overrides=overrides)
    corners, sheet = order.corners, order.sheet
    choices = Choices(
        None if corners is None else Corners.from_json(corners.model_dump()),
        None if sheet is None else Sheet.from_json(sheet.model_dump()),
        order.lift,
    )
    return replace(interpretation, choices=choices)


@router.get("")
@requires(AccessScope.VIEWER)
def list_jobs(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[JobsQuery, Query()],
) -> list[JobOut]:
    """List the jobs that meet all conditions, newest first.

    The header ``Link`` contains the URL of the next page.
    """
    conditions = JobFilter(details_filter(wanted, request), wanted.drawing, wanted.machine)
    rows = service.store.jobs.search(wanted.state, wanted.cursor, wanted.limit, wanted=conditions)
    last = rows[-1].serial if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return jobs_out(service.store, rows)


@router.get("/{id}")
@requires(AccessScope.VIEWER)
def get_job(service: ServiceDep, id: JobId) -> JobOut:
    """Get a job with its state and its progress."""
    return job_out(service.store, service.store.jobs.get(id))


@router.get("/{id}/events")
@requires(AccessScope.VIEWER)
def get_job_events(service: ServiceDep, id: JobId) -> list[JobEvent]:
    """List the state changes of a job with their times, causes and descriptions."""
    return job_events(service.store, id)


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


@router.get("/{id}/program", response_class=PlainTextResponse)
@requires(AccessScope.VIEWER, AccessScope.GATEWAY)
def get_program(service: ServiceDep, request: Request, id: JobId) -> Response:
    """Download the program of a job, byte for byte as it is sent to the machine."""
    row = service.store.jobs.get(id)
    text = service.store.jobs.column(id, "program")
    stem = row.drawing_name.rpartition(".")[0] or row.drawing_name
    language = language_of(service.store.library, row)
    name = f"{stem}-{row.machine}{language.suffix if language else '.nc'}"
    return bytes_response(request, text, row.program_sha256, "text/plain; charset=utf-8", name)


@router.get("/{id}/verdict", response_model=VerdictOut, responses={200: BINARY})
@requires(AccessScope.VIEWER)
def get_verdict(
    service: ServiceDep,
    request: Request,
    id: JobId,
    format: DataFormat = "json",
) -> Response:
    """Get the verdict on a job's program, with measurements per edge, as JSON or binary arrays."""
    row = service.store.jobs.get(id)
    block = service.store.jobs.column(id, "verdict")
    if format == "columns":
        # The verdict changes when a shortfall is accepted.
        version = f"{row.program_sha256}-{(row.verdict_summary or {}).get('exceptions', 0)}"
        return bytes_response(request, block, version, "application/octet-stream")
    return Response(verdict_out(block).model_dump_json(), media_type="application/json")


def verdict_out(block: bytes) -> VerdictOut:
    """Return the API model of a stored verdict of the verifier.

    A column that the stored verdict does not have becomes an empty list; verdicts stored by older
    versions have fewer columns.

    Parameters
    ----------
    block
        The stored verdict: columns of measurements, and findings, packed into bytes.
    """
    columns, meta = unpack_columns(block)
    figures = {
        f"edge_{name}": columns[name].tolist() if name in columns else [] for name in EDGE_COLUMNS
    }
    summary = {name: meta[name] for name in VerdictSummary.model_fields if name in meta}
    return VerdictOut.model_validate(
        {
            **summary,
            **figures,
            "findings": meta["findings"],
            "areas": areas_json(unpack_areas(columns)),
        }
    )


@router.get("/{id}/toolpath", response_class=Response, responses={200: BINARY})
@requires(AccessScope.VIEWER)
def get_toolpath(service: ServiceDep, request: Request, id: JobId) -> Response:
    """Get the tool path of a job as binary arrays; each of its n moves of the head is one row.

    The arrays are ``pose`` (n + 1 positions, at the start and after each move: X and Y of the
    head's axis and Z of the tool's tip in mm, C in degrees), ``bulge`` (tan(sweep / 4) of an arc, 0
    for a line), ``motion`` (number of the kind of the move, such as 0 for a rapid move), ``feed``
    (mm/min), ``source`` (row of the processed edge in the drawing; -1 between edges), ``tool``
    (station number), ``track`` (number of the track from 0, which is a path between two lifts; -1
    between tracks) and ``line`` (number of the program line; -1 for none).
    """
    row = service.store.jobs.get(id)
    block = service.store.jobs.column(id, "toolpath")
    return bytes_response(request, block, row.program_sha256, "application/octet-stream")


@router.get("/{id}/earlier-exceptions")
@requires(AccessScope.VIEWER)
def get_earlier_exceptions(service: ServiceDep, id: JobId) -> EarlierExceptions | None:
    """Get the shortfalls of a refused job that a user accepted for an earlier job.

    The earlier job is the newest one for the same file, unit, machine and board that has accepted
    shortfalls; its shortfalls with the same edge, code and measure are listed.  They refuse the
    present job until a user accepts them again (`POST /api/jobs/{id}/exceptions`).  Null if there
    are none.
    """
    row = service.store.jobs.get(id)
    earlier = service.store.jobs.last_with_exceptions(row)
    if earlier is None or row.verdict_summary is None:
        return None
    found = find_same_exceptions(
        service.store.jobs.column(id, "verdict"),
        service.store.jobs.column(earlier.id, "verdict"),
    )
    if not found:
        return None
    return EarlierExceptions.model_validate(
        {"job": earlier.id, "created": earlier.created, "findings": found}
    )


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
    chosen = _shortfalls(exceptions)
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
    _check_own(service, principal, id)
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
    _check_own(service, principal, id)
    return job_out(service.store, service.store.operators.cancel(id, key))


@router.post("/{id}/finish")
@requires(AccessScope.OPERATOR)
def finish_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Declare that all sheets of an interrupted job are complete."""
    return job_out(service.store, service.store.operators.declare_finished(id, key))


@router.post("/{id}/requeue")
@requires(AccessScope.OPERATOR)
def requeue_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Queue an interrupted job again, from its first program line; the table must be clear."""
    return job_out(service.store, service.store.operators.requeue(id, key))


@router.post("/{id}/scrap")
@requires(AccessScope.OPERATOR)
def scrap_job(service: ServiceDep, id: JobId, key: CommandKey) -> JobOut:
    """Give up an interrupted job and free the table of its machine."""
    return job_out(service.store, service.store.operators.scrap(id, key))


def _check_own(service: Service, principal: Principal, id: str) -> None:
    """Raise ``AccessDenied`` unless a principal may withdraw a job.

    Operators may do so with all jobs, designers with those that they have ordered and that are not
    queued yet.
    """
    if AccessScope.OPERATOR in principal.scopes:
        return
    row = service.store.jobs.get(id)
    if row.state not in (*_BEFORE_QUEUE, State.CANCELLED) or row.ordered_by != acting_owner():
        demand(principal, AccessScope.OPERATOR)


def job_out(store: Store, row: Job) -> JobOut:
    """Return the API model of a job from its row in the store."""
    return jobs_out(store, [row])[0]


def jobs_out(store: Store, rows: Sequence[Job]) -> list[JobOut]:
    """Return the API models of jobs from their rows in the store, in the same order."""
    now = store.database.clock()
    remaining = store.jobs.remaining_copies(rows)
    estimated = estimates(store, rows)
    return [
        _job_out(row, waiting, remaining.get(row.id, 0), now, estimated.get(row.id, Estimate()))
        for row, waiting in zip(rows, waiting_of(store, rows), strict=True)
    ]


def _job_out(row: Job, waiting: Waiting, remaining: int, now: float, estimate: Estimate) -> JobOut:
    message = waiting.message or row.message
    computed = {
        "verdict", "progress", "waiting_for", "actions", "reason", "hint", "message", "is_rest",
        "remaining_copies", "queue_position", "estimated_start", "no_estimate",
        *OrderDetailsOut.model_fields,
    }  # fmt: skip
    fields: dict[str, Any] = {
        name: getattr(row, name) for name in set(JobOut.model_fields) - computed
    }
    return JobOut.model_validate(
        {
            **fields,
            **details_fields(row),
            "waiting_for": waiting.waiting_for,
            "message": message,
            "reason": render(message) if message else "",
            "hint": hint(message) if message else "",
            "actions": allowed_actions(row, now),
            "verdict": row.verdict_summary,
            "progress": progress(row),
            "is_rest": row.rest is not None,
            "remaining_copies": remaining,
            "queue_position": estimate.place,
            "estimated_start": None if estimate.starts_in is None else now + estimate.starts_in,
            "no_estimate": estimate.missing,
        }
    )


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
