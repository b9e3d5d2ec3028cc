"""Routes for systems of the printing industry: orders in XJDF, messages in XJMF (ADR 87, 96)."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, Final

from fastapi import Query, Request, Response
from pydantic import Field

from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.acting import note_refusal
from knifetip.service.http.parameters import IdempotencyKey, JobId
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.versions import Body
from knifetip.service.limits.work_queue import Client
from knifetip.service.orders.models import JobOut
from knifetip.service.xjdf.package import MIME, ZIP_TYPES, XjdfPackage, open_package
from knifetip.service.xjdf.placing import XjdfDefaults, XjdfSubmission, place_xjdf
from knifetip.service.xjdf.status import status_document, status_message
from knifetip.service.xjdf.xjmf_commands import MessageContext, answer_messages
from knifetip.service.xjdf.xjmf_messages import ReturnCode, read_messages, write_answers

XJDF: Final = "application/vnd.cip4-xjdf+xml"
XJMF: Final = "application/vnd.cip4-xjmf+xml"

router = ScopedRouter(tags=["xjdf"])


def _body(document: str) -> dict[str, Any]:
    """Return the OpenAPI schema of a body: a document alone, or a package with it."""
    package = {"schema": {"type": "string", "format": "binary"}}
    content = {document: {"schema": {"type": "string"}}, **dict.fromkeys(ZIP_TYPES, package)}
    return {"requestBody": {"required": True, "content": {**content, MIME: package}}}


def _answer(media: str) -> dict[int | str, dict[str, Any]]:
    return {200: {"content": {media: {"schema": {"type": "string"}}}}}


class XjdfQuery(XjdfDefaults):
    """Defaults for an XJDF document; values of the document take precedence."""

    release: bool = Field(default=False, description="Queue the job when its program is verified")


@router.post("/xjdf", status_code=201, openapi_extra=_body(XJDF))
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
async def order_by_xjdf(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    content: Body,
    wanted: Annotated[XjdfQuery, Query()],
    key: IdempotencyKey = None,
) -> JobOut:
    """Create a job from an XJDF document for cutting and creasing.

    The body is the document, or a package with the document and its drawing: ZIP with one file
    ``*.xjdf``, or MIME multipart/related.  ``FileSpec/@URL`` names the drawing in the package, by a
    relative URL or ``cid:``, or one that was uploaded, as ``/api/v1/drawings/ID``.  ``machine`` and
    ``board`` are used if the document names none.
    """
    client = Client.from_request(request)
    package = await _open(service, request, client, content, "XJDF")
    submission = XjdfSubmission(package.root, package, wanted, wanted.release, _host(request))
    return await place_xjdf(service, principal, client, response, submission, key)


@router.post("/xjmf", response_class=Response, responses=_answer(XJMF), openapi_extra=_body(XJMF))
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
async def answer_xjmf(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    content: Body,
    defaults: Annotated[XjdfDefaults, Query()],
    key: IdempotencyKey = None,
) -> Response:
    """Answer the messages of an XJMF document, each by a response with its ``ReturnCode``.

    Known are ``CommandSubmitQueueEntry``, ``CommandModifyQueueEntry``, ``QueryQueueStatus``,
    ``QueryStatus`` and ``QueryKnownMessages``.  The body is the document, or a package with the
    document, its orders in XJDF and their drawings: ZIP with ``root.xjmf``, or multipart/related.
    The status is 200 as soon as the document can be read.
    """
    client = Client.from_request(request)
    package = await _open(service, request, client, content, "XJMF")
    messages = await service.orders.run(partial(read_messages, package.root), client)
    context = MessageContext(service, principal, client, package, defaults, key, _host(request))
    answers = [await answer_messages(context, message) for message in messages]
    if any(answer.code is not ReturnCode.SUCCESS for answer in answers):
        note_refusal()
    return Response(write_answers(answers, service.store.database.clock()), media_type=XJMF)


def _host(request: Request) -> str:
    return request.headers.get("host", "")


async def _open(
    service: Service, request: Request, client: Client, content: bytes, kind: str
) -> XjdfPackage:
    media = request.headers.get("content-type", "")
    limit = service.settings.upload_bytes
    return await service.orders.run(partial(open_package, content, media, limit, kind), client)


@router.get("/jobs/{id}/xjmf", response_class=Response, responses=_answer(XJMF))
@requires(AccessScope.VIEWER)
def get_job_status_as_xjmf(service: ServiceDep, id: JobId) -> Response:
    """Get the state of a job as XJMF: a ``SignalStatus`` with one ``JobPhase``."""
    row = service.store.jobs.get(id)
    return Response(status_message(row, service.store.database.clock()), media_type=XJMF)


@router.get("/jobs/{id}/xjdf", response_class=Response, responses=_answer(XJDF))
@requires(AccessScope.VIEWER)
def get_job_as_xjdf(service: ServiceDep, id: JobId) -> Response:
    """Get a job as XJDF: what was ordered, its ``NodeInfo/@Status`` and an ``AuditStatus``."""
    row = service.store.jobs.get(id)
    return Response(status_document(row, service.store.database.clock()), media_type=XJDF)
