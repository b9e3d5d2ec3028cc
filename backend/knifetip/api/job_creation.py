"""Create the job of an order, which all routes that take orders do in the same way."""

from __future__ import annotations

from dataclasses import replace

from fastapi import Response

from knifetip.api.exceptions import chosen_shortfalls
from knifetip.api.job_models import job_out
from knifetip.api.overrides import merge_overrides
from knifetip.api.principal import Principal, demand
from knifetip.api.revisions import check_revision
from knifetip.api.schemas.jobs import JobOut
from knifetip.api.schemas.order_details import details_columns
from knifetip.api.schemas.orders import ExceptionsIn, JobIn
from knifetip.api.service import Service, customer_rules, fingerprint
from knifetip.errors import OpenQuestions
from knifetip.jobs import tasks
from knifetip.jobs.accounts.acting import credited
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.interpretations import interpretation_of
from knifetip.jobs.job_store import JobOrder
from knifetip.jobs.readings import StoredDrawing
from knifetip.jobs.request_key import RequestKey
from knifetip.jobs.tables import Drawing, Job
from knifetip.library.definition import Shelf
from knifetip.model.acceptance import Exceptions
from knifetip.model.choices import Choices
from knifetip.model.corners import Corners
from knifetip.model.interpretation import Interpretation
from knifetip.model.sheet import Sheet
from knifetip.model.verdict import Acceptance


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
