"""Create the job of an order; used by all routes that accept orders."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

from fastapi import Response

from knifetip.api.exceptions import chosen_shortfalls
from knifetip.api.job_models import job_out
from knifetip.api.overrides import merge_overrides
from knifetip.api.principal import Principal, demand
from knifetip.api.queue import Client
from knifetip.api.revisions import check_revision
from knifetip.api.schemas.jobs import JobOut
from knifetip.api.schemas.order_details import details_columns
from knifetip.api.schemas.orders import ExceptionsIn, JobIn
from knifetip.api.service import Service, customer_rules, fingerprint
from knifetip.errors import OpenQuestions
from knifetip.jobs import tasks
from knifetip.jobs.accounts.acting import credited
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.compile_key import digest_of
from knifetip.jobs.interpretations import interpretation_of
from knifetip.jobs.job_store import JobOrder
from knifetip.jobs.readings import StoredDrawing
from knifetip.jobs.request_key import RequestKey
from knifetip.jobs.tables import Drawing, Job
from knifetip.library.definition import Definition, Shelf, machine_of
from knifetip.model.acceptance import Exceptions
from knifetip.model.choices import Choices
from knifetip.model.corners import Corners
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import Interpretation
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Acceptance
from knifetip.planning.tool_steps import lacks_tool


@dataclass(frozen=True, slots=True)
class PreparedOrder:
    """An order with what it names: the drawing, the machine and the board."""

    order: JobIn
    drawing: Drawing  #: with its overrides
    interpretation: Interpretation
    machine: Definition
    board: Definition

    @property
    def questions_key(self) -> str:
        """Hash of everything on which the open questions depend."""
        # A version of a drawing or a machine never changes.
        drawing, machine = self.drawing, self.machine
        versions = drawing.id, drawing.version, machine.name, machine.version
        return digest_of((versions, self.interpretation))


async def create_job(
    service: Service,
    principal: Principal,
    client: Client,
    response: Response,
    order: JobIn,
    key: str | None,
) -> JobOut:
    """Create the job of an order, or find the one that was created under the same key.

    It needs a place in the queue for the worker processes only if it is not
    known yet whether questions about the drawing are open.

    Parameters
    ----------
    service, principal, client
        The server, and the sender of the request.
    response
        Gets the header ``Location``.
    order
        The order.
    key
        Idempotency-Key of the request, None if it has none.
    """
    if order.release:
        demand(principal, AccessScope.OPERATOR, AccessScope.ORDER)
    request = RequestKey(key, fingerprint(order.model_dump_json())) if key else None
    found = await create_stored(service, client, order, request)
    response.headers["Location"] = f"/api/jobs/{found.id}"
    return found


async def create_stored(
    service: Service, client: Client, order: JobIn, key: RequestKey | None
) -> JobOut:
    """Create the job of an order of a stored drawing, or find the one with the same key.

    Raises
    ------
    ServerBusy
        Too many orders wait, or too many requests wait for a worker process.
    OpenQuestions
        The user must first answer questions about the drawing.
    KnifetipError
        The drawing, the machine or the board is unknown, or the order is not permitted.
    """
    found = await service.orders.run(partial(_create_answered, service, order, key), client)
    while isinstance(found, str):
        async with service.answered.lock_of(found):
            if found not in service.answered:
                await service.work.run(partial(_answer, service, order), client)
        # The drawing may have been changed meanwhile.
        found = await service.orders.run(partial(_create_answered, service, order, key), client)
    return found


def _create_answered(service: Service, order: JobIn, key: RequestKey | None) -> JobOut | str:
    """Create the job of an order, or return the key of questions that may be open."""
    row = service.store.jobs.find(key) if key else None
    if row is None:
        prepared = _prepare(service, order)
        questions = prepared.questions_key
        if questions not in service.answered:
            if not _is_answered_by_reading(prepared):
                return questions
            service.answered.add(questions)
        row = _store(service, prepared, key)
    return job_out(service.store, row)


def _is_answered_by_reading(prepared: PreparedOrder) -> bool:
    """Return whether the stored result of the reading shows that no question is open.

    This is the case if the order has the interpretation of the drawing, and no choices that the
    machine must permit.
    """
    drawing, choices = prepared.drawing, prepared.interpretation.choices
    read_as = interpretation_of(drawing, drawing.overrides)
    if replace(prepared.interpretation, choices=read_as.choices) != read_as:
        return False
    if choices.corners is not None or choices.lift != read_as.choices.lift:
        return False
    summary = drawing.summary
    if summary.get("questions") or "counts" not in summary:
        return False
    table = machine_of(prepared.machine)
    return not any(
        lacks_tool(table, LineType.from_word(count["type"])) for count in summary["counts"]
    )


def place_order(service: Service, order: JobIn, key: RequestKey | None) -> Job:
    """Store a job for an order and return it; called by requests in the ``WorkQueue``.

    Raises
    ------
    OpenQuestions
        The user must first answer questions about the drawing.
    KnifetipError
        The drawing, the machine or the board is unknown, or the order is not permitted.
    """
    return _store(service, _answer(service, order), key)


def _prepare(service: Service, order: JobIn, *columns: str) -> PreparedOrder:
    """Return an order with what it names; the large ``columns`` of the drawing are loaded too."""
    machine = service.store.library.definition(Shelf.MACHINES, order.machine)
    board = service.store.library.definition(Shelf.BOARDS, order.board)
    # Questions, the stored job and the compile all use this one revision.
    needed = {"overrides", *columns, *(("edges",) if order.overrides else ())}
    drawing = service.store.drawings.get_with(order.drawing, *sorted(needed))
    check_revision(order.revision, drawing)
    return PreparedOrder(order, drawing, _interpretation(service, order, drawing), machine, board)


def _answer(service: Service, order: JobIn) -> PreparedOrder:
    """Return an order about whose drawing no question is open, or raise ``OpenQuestions``."""
    prepared = _prepare(service, order)
    if prepared.questions_key in service.answered:
        return prepared
    prepared = _prepare(service, order, "content", "edges")
    drawing = prepared.drawing
    questions = service.run(
        tasks.open_questions,
        StoredDrawing(
            drawing.content, drawing.edges, interpretation_of(drawing, drawing.overrides)
        ),
        prepared.interpretation,
        prepared.machine,
    )
    if questions:
        raise OpenQuestions(questions)
    service.answered.add(prepared.questions_key)
    return prepared


def _store(service: Service, prepared: PreparedOrder, key: RequestKey | None) -> Job:
    """Store the job of an order about whose drawing no question is open."""
    order = prepared.order
    ordered = JobOrder(
        machine=order.machine,
        board=order.board,
        interpretation=prepared.interpretation,
        copies=order.copies,
        priority=order.priority,
        release=order.release,
        exceptions=_exceptions(service, order.exceptions),
        machine_version=prepared.machine.version,
        board_version=prepared.board.version,
        details=details_columns(order),
    )
    return service.store.jobs.add(prepared.drawing, ordered, key)


def _exceptions(service: Service, ordered: ExceptionsIn | None) -> Exceptions | None:
    """Return the exceptions that an order contains, None for none; they are accepted now."""
    if ordered is None:
        return None
    chosen = tuple(sorted(chosen_shortfalls(ordered)))
    return Exceptions(
        chosen, Acceptance(credited(ordered.by), ordered.reason, service.store.database.clock())
    )


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
