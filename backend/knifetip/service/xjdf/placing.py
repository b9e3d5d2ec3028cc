"""Place an order in XJDF: its drawing is stored if it is in the package, and its job created."""

from __future__ import annotations

from functools import partial
from pathlib import PurePosixPath
from typing import NamedTuple
from urllib.parse import unquote, urlsplit

from fastapi import Response
from fastapi.concurrency import run_in_threadpool
from fastapi.exceptions import RequestValidationError
from pydantic import Field, ValidationError

from knifetip.errors import RequestError
from knifetip.service.components import Service
from knifetip.service.drawings.requests import Upload, drawing_name, store_upload
from knifetip.service.http.models import Parameters
from knifetip.service.http.principal import Principal, demand
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import Client
from knifetip.service.order_details.models import details_columns
from knifetip.service.orders.creation import create_job
from knifetip.service.orders.models import JobOut
from knifetip.service.orders.order_models import JobIn
from knifetip.service.xjdf.order import XjdfOrder, read_order
from knifetip.service.xjdf.package import XjdfPackage


class XjdfDefaults(Parameters):
    """Defaults for an XJDF document; values of the document take precedence."""

    machine: str = Field(
        default="", max_length=200, description="Name of the machine if the document names none"
    )
    board: str = Field(
        default="", max_length=200, description="Name of the board if the document names none"
    )
    profile: str = Field(
        default="", max_length=200, description="Name of the classification profile"
    )


class XjdfSubmission(NamedTuple):
    """An XJDF document that orders a job."""

    document: bytes
    package: XjdfPackage  #: files to which the document refers
    defaults: XjdfDefaults
    release: bool  #: whether the job is queued when its program is accepted
    host: str = ""  #: name and port of this server, as the request names it


async def place_xjdf(
    service: Service,
    principal: Principal,
    client: Client,
    response: Response,
    submission: XjdfSubmission,
    key: str | None,
) -> JobOut:
    """Create the job that an XJDF document orders.

    Parameters
    ----------
    service, principal, client
        The server, and the sender of the request.
    response
        Gets the header ``Location``.
    submission
        The XJDF document with its files and its defaults.
    key
        Idempotency-Key of the order, None if it has none.

    Raises
    ------
    RequestError
        The document cannot be read, or a required value is missing.
    RequestValidationError
        A value of the document is not permitted.
    KnifetipError
        The drawing, the machine or the board is unknown, or the order is not permitted.
    """
    defaults = submission.defaults
    order = await service.orders.run(
        partial(read_order, submission.document, submission.host), client
    )
    job = _job_order(order, defaults, release=submission.release)
    if submission.release:
        demand(principal, AccessScope.OPERATOR, AccessScope.ORDER)
    if order.file:
        content = await service.orders.run(partial(submission.package.file, order.file), client)
        name = drawing_name(PurePosixPath(unquote(urlsplit(order.file).path)).name)
        profile = defaults.profile or "default"
        upload = Upload(name, content, profile=profile, details=details_columns(job))
        identity = await run_in_threadpool(upload.identity, key)
        call = partial(store_upload, service, upload, key)
        drawing = await service.work.run(call, client, identity)
        job = job.model_copy(update={"drawing": drawing.id})
    return await create_job(service, principal, client, response, job, key)


def _job_order(order: XjdfOrder, defaults: XjdfDefaults, *, release: bool) -> JobIn:
    """Return the order of a job that a document contains; its drawing may still be missing."""
    board = order.board or defaults.board
    if not board:
        raise RequestError("xjdf.missing", place="ResourceSet[@Name='Media']/Resource/@ExternalID")
    machine = order.machine or defaults.machine
    fields = {
        "drawing": order.drawing or "-",
        "external_id": order.external_id,
        "customer": order.customer,
        "due": order.due or None,
        "copies": order.copies,
        "priority": order.priority,
        "profile": defaults.profile or None,
        "board": board,
        "release": release,
        **({"machine": machine} if machine else {}),
    }
    try:
        return JobIn.model_validate(fields)
    except ValidationError as reason:
        raise RequestValidationError(reason.errors()) from reason
