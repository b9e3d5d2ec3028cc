"""Routes for jobs: create, list and read them, and download their programs and verdicts."""

from __future__ import annotations

from typing import Annotated

from fastapi import Query, Request, Response
from fastapi.concurrency import run_in_threadpool
from fastapi.responses import PlainTextResponse

from knifetip.presentation.program_lines import select_lines
from knifetip.service.components import ServiceDep
from knifetip.service.documents.responses import AnswerDep
from knifetip.service.http.conditional import NOT_MODIFIED, TAG_PREFIX
from knifetip.service.http.downloads import BINARY, bytes_response
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of, set_next_page
from knifetip.service.http.parameters import DataFormat, IdempotencyKey, JobId
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import Client
from knifetip.service.machines.waiting import language_of
from knifetip.service.order_details.models import details_filter
from knifetip.service.orders.creation import create_job
from knifetip.service.orders.exceptions import find_same_exceptions
from knifetip.service.orders.job_answers import job_events, job_out, jobs_out
from knifetip.service.orders.models import JobEvent, JobOut, JobsQuery
from knifetip.service.orders.order_models import JobIn
from knifetip.service.orders.program_models import ProgramLines
from knifetip.service.orders.store import JobFilter
from knifetip.service.orders.verdict_document import verdict_document, verdict_version
from knifetip.service.orders.verdict_models import EarlierExceptions, VerdictOut
from knifetip.service.orders.versions import job_version

router = ScopedRouter(prefix="/jobs", tags=["jobs"])


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
async def order_job(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    order: JobIn,
    key: IdempotencyKey = None,
) -> JobOut:
    """Create a job; the server then compiles and verifies its program in the background.

    Meanwhile the state of the job is ``received``, then ``compiling``.  If the user must first
    answer questions about the drawing, the status is 409 and the response contains the
    ``questions``.
    """
    return await create_job(service, principal, Client.from_request(request), response, order, key)


@router.get("", responses=NOT_MODIFIED)
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
    conditions = JobFilter(
        details_filter(wanted, request), wanted.drawing, wanted.machine, wanted.board
    )
    rows = service.store.jobs.search(wanted.state, wanted.cursor, wanted.limit, wanted=conditions)
    last = rows[-1].serial if len(rows) == wanted.limit else None
    set_next_page(request, response, last, wanted.limit)
    return jobs_out(service.store, rows)


@router.get("/{id}", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def get_job(service: ServiceDep, response: Response, id: JobId) -> JobOut:
    """Get a job with its state and its progress; the ETag is for ``If-Match`` of a change."""
    row = service.store.jobs.get(id)
    response.headers[TAG_PREFIX] = job_version(row)
    return job_out(service.store, row)


@router.get("/{id}/events", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def get_job_events(
    service: ServiceDep,
    request: Request,
    response: Response,
    id: JobId,
    wanted: Annotated[ListPage, Query()],
) -> list[JobEvent]:
    """List the state changes of a job with their times, causes and descriptions.

    The header `Link` contains the URL of the next page.
    """
    return list(page_of(request, response, job_events(service.store, id), wanted))


@router.get("/{id}/program", response_class=PlainTextResponse, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def get_program(
    service: ServiceDep, id: JobId, wanted: Annotated[ProgramLines, Query()]
) -> Response:
    """Download the program of a job, byte for byte as it is sent to the machine, or some lines.

    Lines after the last one of the program are left out.
    """
    row = service.store.jobs.get(id)
    text = service.store.jobs.column(id, "program")
    if wanted.lines is not None:
        part = select_lines(text, wanted.first_line, wanted.lines)
        tag = f"{row.program_sha256}-{wanted.first_line}-{wanted.lines}"
        return bytes_response(part, tag, "text/plain; charset=utf-8")
    stem = row.drawing_name.rpartition(".")[0] or row.drawing_name
    language = language_of(service.store.library, row)
    name = f"{stem}-{row.machine}{language.suffix if language else '.nc'}"
    return bytes_response(text, row.program_sha256, "text/plain; charset=utf-8", name)


@router.get("/{id}/verdict", response_model=VerdictOut, responses={200: BINARY, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
async def get_verdict(
    service: ServiceDep,
    answer: AnswerDep,
    id: JobId,
    format: DataFormat = "json",
) -> Response:
    """Get the verdict on a job's program, with measurements per edge, as JSON or binary arrays."""
    if format == "columns":
        row = await run_in_threadpool(service.store.jobs.get_with, id, "verdict")
        block = row.verdict or b""
        return bytes_response(block, verdict_version(row), "application/octet-stream")
    return await answer.send(id, verdict_document(service))


@router.get("/{id}/toolpath", response_class=Response, responses={200: BINARY, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
def get_toolpath(service: ServiceDep, id: JobId) -> Response:
    """Get the tool path of a job as binary arrays; each of its n moves of the head is one row.

    The arrays are ``pose`` (n + 1 positions, at the start and after each move: X and Y of the
    head's axis and Z of the tool's tip in mm, C in degrees), ``bulge`` (tan(sweep / 4) of an arc, 0
    for a line), ``motion`` (number of the kind of the move, such as 0 for a rapid move), ``feed``
    (mm/min), ``source`` (row of the processed edge in the drawing; -1 between edges), ``tool``
    (station number), ``track`` (number of the track from 0, which is a path between two lifts; -1
    between tracks), ``first_line`` and ``line`` (first and last program line of the move, from 1;
    -1 for none) and ``seconds`` (machine time of the move; their sum is that of one copy).

    The array ``made_as`` has a value for each edge of the drawing: the edge in whose name
    ``source`` has the moves, which is the edge itself or another one with which it is made; -1 if
    it is not made.  Jobs that older versions compiled have no ``first_line``, ``seconds`` and
    ``made_as``.
    """
    row = service.store.jobs.get(id)
    block = service.store.jobs.column(id, "toolpath")
    return bytes_response(block, row.program_sha256, "application/octet-stream")


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
