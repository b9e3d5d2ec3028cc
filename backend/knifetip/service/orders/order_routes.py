"""Routes that accept a drawing and create its job in one request, for ERP systems."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, Final

from fastapi import Depends, Query, Request, Response
from fastapi.concurrency import run_in_threadpool
from fastapi.exceptions import RequestValidationError
from pydantic import ValidationError
from starlette.datastructures import UploadFile

from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.tables import Drawing
from knifetip.service.drawings.requests import summary_out
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.pages import set_next_page
from knifetip.service.http.parameters import IdempotencyKey
from knifetip.service.http.principal import Principal, PrincipalDep, demand
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import Client, queued
from knifetip.service.orders.batches import execute_orders
from knifetip.service.orders.creation import create_stored
from knifetip.service.orders.job_answers import job_out, jobs_out
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.order_list import OrderRow, OrdersQuery, find_orders
from knifetip.service.orders.orders_with_files import OrderIn, OrderOut, OrderResult, OrdersIn
from knifetip.service.orders.sent_orders import SentOrder, create_sent_job, job_order, store_drawing
from knifetip.service.refusals.control_characters import items_with_own_results
from knifetip.service.refusals.known_fields import media_of, names_near, wrong_media

router = ScopedRouter(prefix="/orders", tags=["orders"])

_FORM: Final = "multipart/form-data"
_ORDER: Final = {"$ref": "#/components/schemas/OrderIn"}
_BODY: Final[dict[str, Any]] = {
    "requestBody": {
        "required": True,
        "content": {
            _FORM: {
                "schema": {
                    "type": "object",
                    "title": "OrderForm",
                    "required": ["file", "order"],
                    "additionalProperties": False,
                    "properties": {
                        "file": {
                            "type": "string",
                            "format": "binary",
                            "description": "Drawing in a format that `GET /formats` lists",
                        },
                        "order": {
                            "type": "string",
                            "description": "The order without its file: JSON of an `OrderIn`",
                        },
                    },
                }
            },
            "application/json": {"schema": _ORDER},
        },
    }
}


async def _sent_order(request: Request) -> SentOrder:
    """Return the order in the form or in the JSON of a request."""
    media = media_of(request)
    if media == "application/json":
        return SentOrder(_parse_order(await request.body(), ("body",)))
    if media != _FORM:
        raise wrong_media(media, ("application/json", _FORM))
    async with request.form() as form:
        file, text = form.get("file"), form.get("order")
        missing = [
            ("body", name)
            for name, found in (
                ("file", isinstance(file, UploadFile)),
                ("order", isinstance(text, str)),
            )
            if not found
        ]
        if not isinstance(file, UploadFile) or not isinstance(text, str):
            faults = [{"type": "missing", "loc": place, "input": None} for place in missing]
            raise RequestValidationError(faults)
        order = _parse_order(text.encode("utf-8", "replace"), ("body", "order"))
        service: Service = request.app.state.service
        content = await file.read(service.settings.upload_bytes + 1)
        return SentOrder(order, file.filename or "", content)


def _parse_order(text: bytes, place: tuple[str, ...]) -> OrderIn:
    try:
        return OrderIn.model_validate_json(text)
    except ValidationError as reason:
        faults = reason.errors(include_url=False)
        raise RequestValidationError(
            [{**fault, "loc": (*place, *fault["loc"])} for fault in faults]
        ) from None


@router.get("", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_orders(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[OrdersQuery, Query()],
) -> list[OrderRow]:
    """List the drawings and layouts that meet all conditions, each with its newest job.

    The header ``Link`` contains the URL of the next page.
    """
    rows = find_orders(service.store.database, wanted)
    shown = iter(jobs_out(service.store, [job for _, job in rows if job is not None]))
    end = (wanted.cursor or 0) + len(rows)
    set_next_page(request, response, end if len(rows) == wanted.limit else None, wanted.limit)
    return [
        OrderRow(
            drawing=summary_out(drawing),
            file=drawing.sha256,
            job=None if job is None else next(shown),
        )
        for drawing, job in rows
    ]


@router.post("", status_code=201, openapi_extra=_BODY)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
async def place_order_with_file(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    sent: Annotated[SentOrder, Depends(_sent_order)],
    key: IdempotencyKey = None,
) -> OrderOut:
    """Store a drawing or a layout and create a job for it.

    The request is a form with the file and the order as JSON, or JSON with the file in base64, with
    the id of a stored drawing or layout, with a carton that the server draws, or with a layout.
    The drawing and the job get the details of the order.  If a user must first answer questions
    about the drawing, the status is 409 and the drawing is kept: it is listed by the
    ``external_id`` of the order.  A repetition with the same ``Idempotency-Key`` creates the job as
    soon as the questions are answered.
    """
    _permit(principal, sent.order)
    client = Client.from_request(request)
    if sent.is_stored:
        drawing = await service.orders.run(partial(store_drawing, service, sent, key), client)
        order = job_order(sent.order, drawing.id)
        job = await create_stored(service, client, order, sent.key(key))
    else:
        identity = await run_in_threadpool(sent.identity, key)
        call = partial(_with_file, service, sent, key)
        drawing, job = await service.work.run(call, client, identity)
    response.headers["Location"] = f"/api/jobs/{job.id}"
    return OrderOut(drawing=summary_out(drawing), job=job)


def _permit(principal: Principal, order: OrderIn) -> None:
    """Raise ``AccessDenied`` if the sender of an order may not release its job."""
    if order.release:
        demand(principal, AccessScope.OPERATOR, AccessScope.ORDER)


def _with_file(service: Service, sent: SentOrder, key: str | None) -> tuple[Drawing, JobOut]:
    """Store the drawing and the job of an order with a file."""
    drawing = store_drawing(service, sent, key)
    job = create_sent_job(service, sent, drawing, sent.key(key))
    return drawing, job_out(service.store, job)


@router.post("/batch")
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@items_with_own_results("orders")
@queued
def place_orders(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    batch: OrdersIn,
    key: IdempotencyKey = None,
) -> list[OrderResult]:
    """Execute up to 100 orders, one after the other, and return a result for each.

    An order that is invalid, refused or fails does not prevent the others; the status is 200 as
    soon as the request is JSON with a list of 1 to 100 orders.  After a failure of the database or
    of the disk, the orders that follow are not tried; their results state it.  With an
    ``Idempotency-Key``, a repetition of the request creates nothing twice, and repeats the orders
    that were invalid, refused or not tried.
    """
    names, permit = partial(names_near, request), partial(_permit, principal)
    return execute_orders(service, batch.orders, key, names, permit)
