"""Create the job of an order; used by all routes that accept orders."""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

from fastapi import Response

from knifetip.errors import OpenQuestions, PlanError, WrongState
from knifetip.library.definition import Definition, Shelf, machine_of
from knifetip.model.acceptance import Exceptions
from knifetip.model.dieline import LineType
from knifetip.model.interpretation import Interpretation
from knifetip.model.job_options import JobOptions
from knifetip.model.layout import Layout
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Acceptance
from knifetip.planning.tool_steps import lacks_tool
from knifetip.service.compiling.key import digest_of
from knifetip.service.components import Service
from knifetip.service.database.acting import credited_name
from knifetip.service.database.request_key import RequestKey, fingerprint
from knifetip.service.database.tables import Drawing, Job
from knifetip.service.drawings.customer_profiles import customer_rules
from knifetip.service.drawings.interpretations import interpretation_of
from knifetip.service.drawings.overrides import merge_overrides
from knifetip.service.http.principal import Principal, demand
from knifetip.service.http.revisions import check_revision
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import Client
from knifetip.service.order_details.models import details_columns
from knifetip.service.orders.exceptions import chosen_shortfalls
from knifetip.service.orders.job_answers import job_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.order_models import ExceptionsIn, JobIn
from knifetip.service.orders.store import JobOrder
from knifetip.service.processes import tasks
from knifetip.service.processes.readings import StoredDrawing


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

    If it is not known yet whether questions about the drawing are open, a worker process finds them
    first, and the request waits for its turn in the ``WorkQueue``.

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
        async with service.answered_questions.lock_of(found):
            if found not in service.answered_questions:
                await service.work.run(partial(_require_answers, service, order), client)
        # The drawing may have been changed meanwhile.
        found = await service.orders.run(partial(_create_answered, service, order, key), client)
    return found


def _create_answered(service: Service, order: JobIn, key: RequestKey | None) -> JobOut | str:
    """Create the job of an order, or return the key of questions that may be open."""
    row = service.store.jobs.find(key) if key else None
    if row is None:
        prepared = _prepare(service, order)
        questions = prepared.questions_key
        if questions not in service.answered_questions:
            if not _is_answered_by_reading(prepared):
                return questions
            service.answered_questions.add(questions)
        row = _store(service, prepared, key)
    return job_out(service.store, row)


def _is_answered_by_reading(prepared: PreparedOrder) -> bool:
    """Return whether the stored result of the reading shows that no question is open.

    This is the case if the order has the interpretation of the drawing, and no choices that the
    machine must permit.
    """
    drawing, options = prepared.drawing, prepared.interpretation.options
    read_as = interpretation_of(drawing, drawing.overrides)
    if replace(prepared.interpretation, options=read_as.options) != read_as:
        return False
    if options.corners is not None or options.lift != read_as.options.lift:
        return False
    summary = drawing.summary
    if summary.get("questions") or "counts" not in summary:
        return False
    target = machine_of(prepared.machine)
    return not any(
        lacks_tool(target, LineType.from_word(count["type"])) for count in summary["counts"]
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
    return _store(service, _require_answers(service, order), key)


def _prepare(service: Service, order: JobIn, *columns: str) -> PreparedOrder:
    """Return an order with what it names; the large ``columns`` of the drawing are loaded too."""
    machine = service.store.library.definition(Shelf.MACHINES, order.machine)
    board = service.store.library.definition(Shelf.BOARDS, order.board)
    # Questions, the stored job and the compile all use this one revision.
    needed = {"overrides", *columns, *(("edges",) if order.overrides else ())}
    drawing = service.store.drawings.get_with(order.drawing, *sorted(needed))
    check_revision(order.revision, drawing)
    return PreparedOrder(order, drawing, _interpretation(service, order, drawing), machine, board)


def _require_answers(service: Service, order: JobIn) -> PreparedOrder:
    """Return an order about whose drawing no question is open, or raise ``OpenQuestions``."""
    prepared = _prepare(service, order)
    if prepared.questions_key in service.answered_questions:
        return prepared
    prepared = _prepare(service, order, "content", "edges")
    drawing = prepared.drawing
    questions = service.run(
        tasks.open_questions,
        StoredDrawing(
            drawing.content,
            drawing.edges,
            interpretation_of(drawing, drawing.overrides),
            drawing.layout is not None,
        ),
        prepared.interpretation,
        prepared.machine,
    )
    if questions:
        raise OpenQuestions(questions)
    service.answered_questions.add(prepared.questions_key)
    return prepared


def _store(service: Service, prepared: PreparedOrder, key: RequestKey | None) -> Job:
    """Store the job of an order about whose drawing no question is open."""
    order = prepared.order
    _check_marks(order)
    ordered = JobOrder(
        machine=order.machine,
        board=order.board,
        interpretation=prepared.interpretation,
        copies=order.copies,
        priority=order.priority,
        release=order.release,
        exceptions=_exceptions_of_order(service, order.exceptions),
        machine_version=prepared.machine.version,
        board_version=prepared.board.version,
        details=details_columns(order),
    )
    return service.store.jobs.add(prepared.drawing, ordered, key)


def _check_marks(order: JobIn) -> None:
    """Raise ``PlanError`` for marks that an order states as measured, or for several sheets."""
    if order.registration is None:
        return
    if order.registration.measured:
        raise PlanError("registration.measured-in-order", source=["registration", "measured"])
    if order.copies > 1:
        raise PlanError("registration.one-copy", source=["copies"], copies=order.copies)


def _exceptions_of_order(service: Service, ordered: ExceptionsIn | None) -> Exceptions | None:
    """Return the exceptions that an order contains, None for none; they are accepted now."""
    if ordered is None:
        return None
    chosen = tuple(sorted(chosen_shortfalls(ordered)))
    return Exceptions(
        chosen,
        Acceptance(credited_name(ordered.by), ordered.reason, service.store.database.clock()),
    )


def _interpretation(service: Service, order: JobIn, drawing: Drawing) -> Interpretation:
    """Return the interpretation of a drawing that applies to a new job.

    It is the stored interpretation (unit, profile, line types of edges), with the changes that the
    request contains.

    ``order``: the request; it can contain a profile, line types of edges, and the choices for the
    job.
    """
    interpretation = interpretation_of(drawing, drawing.overrides)
    if drawing.layout is not None:
        return replace(interpretation, options=_options_of_layout(order, drawing))
    if order.profile is not None:
        rules = customer_rules(service, order.profile)
        interpretation = replace(interpretation, profile=order.profile, rules=rules)
    if order.overrides:
        overrides = merge_overrides(drawing.edges, drawing.overrides, order.overrides)
        interpretation = replace(interpretation, overrides=overrides)
    return replace(interpretation, options=_options(order))


def _options(order: JobIn) -> JobOptions:
    return JobOptions(**{name: getattr(order, name) for name in JobOptions.model_fields})


def _options_of_layout(order: JobIn, drawing: Drawing) -> JobOptions:
    """Return the options of an order for a layout, which states the sheet and all line types.

    Raises
    ------
    WrongState
        The order has a profile, line types or a sheet of its own.
    """
    if order.profile is not None or order.overrides:
        raise WrongState("layout.read-only", layout=drawing.name)
    sheet = Layout.model_validate(drawing.layout).sheet
    low_x, low_y, *_ = drawing.summary["bounds"]
    margins = {"margin": max(low_x, 0.0), "margin_below": max(low_y, 0.0)}
    stated = Sheet(width=sheet.width, height=sheet.height, **margins)
    if order.sheet not in (None, stated):
        raise WrongState("layout.sheet-fixed", layout=drawing.name)
    return _options(order).model_copy(update={"sheet": stated})
