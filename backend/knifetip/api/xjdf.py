"""Routes for systems of the printing industry: orders in XJDF, states in XJMF (ADR 87)."""

from __future__ import annotations

from functools import partial
from typing import Annotated, Any, Final

from fastapi import Query, Request, Response
from fastapi.exceptions import RequestValidationError
from pydantic import Field, ValidationError

from knifetip.api.job_creation import create_job
from knifetip.api.parameters import IdempotencyKey, JobId
from knifetip.api.principal import PrincipalDep
from knifetip.api.queue import Client
from knifetip.api.routing import ScopedRouter, requires
from knifetip.api.schemas.common import Strict
from knifetip.api.schemas.jobs import JobOut
from knifetip.api.schemas.orders import JobIn
from knifetip.api.service import ServiceDep
from knifetip.api.versions import Body
from knifetip.api.xjdf_order import read_order
from knifetip.api.xjdf_status import status_message
from knifetip.errors import RequestError
from knifetip.jobs.accounts.scopes import AccessScope

XJDF: Final = "application/vnd.cip4-xjdf+xml"
XJMF: Final = "application/vnd.cip4-xjmf+xml"

router = ScopedRouter(tags=["xjdf"])

_BODY: Final[dict[str, Any]] = {
    "requestBody": {"required": True, "content": {XJDF: {"schema": {"type": "string"}}}}
}
_ANSWER: Final[dict[int | str, dict[str, Any]]] = {
    200: {"content": {XJMF: {"schema": {"type": "string"}}}}
}


class XjdfQuery(Strict):
    """Defaults for an XJDF document; values of the document take precedence."""

    machine: str = Field(
        default="", max_length=200, description="Name of the machine if the document names none"
    )
    board: str = Field(
        default="", max_length=200, description="Name of the board if the document names none"
    )
    release: bool = Field(default=False, description="Queue the job when its program is verified")


@router.post("/xjdf", status_code=201, openapi_extra=_BODY)
@requires(AccessScope.DESIGNER)
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

    ``FileSpec/@URL`` names a drawing that was uploaded, as ``/api/v1/drawings/ID``.  ``machine``
    and ``board`` are used if the document names none.
    """
    client = Client.of(request)
    order = await service.orders.run(partial(read_order, content), client)
    board = order.board or wanted.board
    if not board:
        raise RequestError("xjdf.missing", place="ResourceSet[@Name='Media']/Resource/@ExternalID")
    machine = order.machine or wanted.machine
    fields = {
        "drawing": order.drawing,
        "external_id": order.external_id,
        "customer": order.customer,
        "due": order.due or None,
        "copies": order.copies,
        "board": board,
        "release": wanted.release,
        **({"machine": machine} if machine else {}),
    }
    try:
        job = JobIn.model_validate(fields)
    except ValidationError as reason:
        raise RequestValidationError(reason.errors()) from reason
    return await create_job(service, principal, client, response, job, key)


@router.get("/jobs/{id}/xjmf", response_class=Response, responses=_ANSWER)
@requires(AccessScope.VIEWER)
def get_job_status_as_xjmf(service: ServiceDep, id: JobId) -> Response:
    """Get the state of a job as XJMF: a ``SignalStatus`` with one ``JobPhase``."""
    row = service.store.jobs.get(id)
    return Response(status_message(row, service.store.database.clock()), media_type=XJMF)
