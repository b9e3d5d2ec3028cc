"""Routes that accept a drawing and create its job in one request, for ERP systems."""

from __future__ import annotations

import hashlib
from functools import partial
from typing import Annotated, Any, Final

from fastapi import Depends, Request, Response
from fastapi.exceptions import RequestValidationError
from pydantic import ValidationError
from starlette.datastructures import UploadFile
from starlette.exceptions import HTTPException

from knifetip.api.drawing_requests import Upload, drawing_name, store_upload, summary_out
from knifetip.api.job_creation import create_stored, place_order
from knifetip.api.job_models import job_out
from knifetip.api.parameters import IdempotencyKey
from knifetip.api.principal import PrincipalDep, demand
from knifetip.api.queue import Client, queued
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.jobs import JobOut
from knifetip.api.schemas.order_details import details_columns
from knifetip.api.schemas.orders import JobIn
from knifetip.api.schemas.orders_with_files import OrderIn, OrderOut, OrderResult, OrdersIn
from knifetip.api.service import Service, ServiceDep, fingerprint
from knifetip.errors import KnifetipError, OpenQuestions, RequestError
from knifetip.jobs.accounts.acting import note_refusal
from knifetip.jobs.accounts.scopes import AccessScope
from knifetip.jobs.process_pool import TaskFailed
from knifetip.jobs.request_key import RequestKey
from knifetip.jobs.tables import Drawing, Job
from knifetip.messages import Message

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
                            "description": "Drawing in DXF, CF2, SVG or PDF",
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


class SentOrder:
    """An order as it was sent: its fields, and its file if it has one."""

    def __init__(self, order: OrderIn, name: str = "", content: bytes | None = None) -> None:
        self.order = order
        if order.file is not None:
            if content is not None:
                raise RequestError("request.one-drawing")
            name, content = order.file.name, order.file.decoded()
        if (content is None) == (order.drawing is None):
            raise RequestError("request.one-drawing")
        self.name = drawing_name(name)
        self.content = content

    def key(self, text: str | None) -> RequestKey | None:
        """Return the key of the order with a hash of its content, None without a key."""
        if text is None:
            return None
        digest = hashlib.sha256(self.content or b"").hexdigest()
        fields = self.order.model_dump_json(exclude={"file"})
        return RequestKey(text, fingerprint("order", self.name, digest, fields))


async def _sent_order(request: Request) -> SentOrder:
    """Return the order in the form or in the JSON of a request."""
    media = request.headers.get("content-type", "").partition(";")[0].strip().lower()
    if media == "application/json":
        return SentOrder(_parsed(await request.body(), ("body",)))
    if media != _FORM:
        raise HTTPException(415)
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
        order = _parsed(text.encode("utf-8", "replace"), ("body", "order"))
        service: Service = request.app.state.service
        content = await file.read(service.settings.upload + 1)
        return SentOrder(order, file.filename or "", content)


def _parsed(text: bytes, place: tuple[str, ...]) -> OrderIn:
    try:
        return OrderIn.model_validate_json(text)
    except ValidationError as reason:
        faults = reason.errors(include_url=False)
        raise RequestValidationError(
            [{**fault, "loc": (*place, *fault["loc"])} for fault in faults]
        ) from None


@router.post("", status_code=201, openapi_extra=_BODY)
@requires(AccessScope.DESIGNER)
async def place_order_with_file(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    sent: Annotated[SentOrder, Depends(_sent_order)],
    key: IdempotencyKey = None,
) -> OrderOut:
    """Store a drawing and create a job for it.

    The request is a form with the file and the order as JSON, or JSON with the file in base64 or
    with the id of a stored drawing.  The drawing and the job get the details of the order.  If a
    user must first answer questions about the drawing, the status is 409 and the drawing is kept:
    it is listed by the ``external_id`` of the order.  A repetition with the same
    ``Idempotency-Key`` creates the job as soon as the questions are answered.
    """
    if sent.order.release:
        demand(principal, AccessScope.OPERATOR)
    client = Client.of(request)
    if sent.content is None:
        drawing = await service.orders.run(partial(_drawing, service, sent, key), client)
        order = _job_order(sent.order, drawing.id)
        job = await create_stored(service, client, order, sent.key(key))
    else:
        drawing, job = await service.work.run(partial(_with_file, service, sent, key), client)
    response.headers["Location"] = f"/api/jobs/{job.id}"
    return OrderOut(drawing=summary_out(drawing), job=job)


def _with_file(service: Service, sent: SentOrder, key: str | None) -> tuple[Drawing, JobOut]:
    """Store the drawing and the job of an order with a file."""
    drawing = _drawing(service, sent, key)
    return drawing, job_out(service.store, _job(service, sent, drawing, sent.key(key)))


@router.post("/batch")
@requires(AccessScope.DESIGNER)
@queued
def place_orders(
    service: ServiceDep, principal: PrincipalDep, batch: OrdersIn, key: IdempotencyKey = None
) -> list[OrderResult]:
    """Execute up to 100 orders, one after the other, and return a result for each.

    An order that is refused does not prevent the others; the status is 200 as soon as the request
    can be read.  With an ``Idempotency-Key``, a repetition of the request creates nothing twice,
    and repeats the refused orders.
    """
    if any(order.release for order in batch.orders):
        demand(principal, AccessScope.OPERATOR)
    return [
        _result(service, index, order, None if key is None else f"{fingerprint(key)}/{index}")
        for index, order in enumerate(batch.orders)
    ]


def _result(service: Service, index: int, order: OrderIn, key: str | None) -> OrderResult:
    """Execute one of several orders; return its result."""
    drawing: Drawing | None = None
    job: Job | None = None
    problem: Message | None = None
    questions: tuple[Any, ...] = ()
    try:
        sent = SentOrder(order)
        drawing = _drawing(service, sent, key)
        job = _job(service, sent, drawing, sent.key(key))
    except KnifetipError as reason:
        note_refusal()
        problem = reason.message
        questions = tuple(reason.questions) if isinstance(reason, OpenQuestions) else ()
    except TaskFailed as reason:
        problem = Message("job.compile-crashed", reason=reason)
    return OrderResult.model_validate(
        {
            "index": index,
            "drawing": None if drawing is None else drawing.id,
            "job": None if job is None else job_out(service.store, job),
            "problem": problem,
            "questions": questions,
        }
    )


def _drawing(service: Service, sent: SentOrder, key: str | None) -> Drawing:
    """Return the drawing of an order; its file is stored with the details of the order."""
    order = sent.order
    if sent.content is None:
        return service.store.drawings.get(order.drawing or "")
    details = details_columns(order)
    profile = order.profile or "default"
    upload = Upload(sent.name, sent.content, order.unit or "", profile, details)
    return store_upload(service, upload, key)


def _job(service: Service, sent: SentOrder, drawing: Drawing, key: RequestKey | None) -> Job:
    """Return the job of an order; a repeated order returns that of the first."""
    earlier = service.store.jobs.find(key) if key else None
    if earlier is not None:
        return earlier
    return place_order(service, _job_order(sent.order, drawing.id), key)


def _job_order(order: OrderIn, drawing: str) -> JobIn:
    """Return the order of a job that an order contains, for a stored drawing."""
    choices = order.model_copy(update={"drawing": drawing})
    fields = {name: getattr(choices, name) for name in JobIn.model_fields if name != "revision"}
    return JobIn.model_construct(**fields)
