"""Routes for nestings: begin, watch, stop and delete searches for the places of drawings.

The best arrangement so far is part of each answer; `POST /api/layouts` stores a sheet of it.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Request, Response

from knifetip.errors import AccessDenied
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.acting import acting_owner
from knifetip.service.http.principal import Principal, PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import rfc3339
from knifetip.service.layouts.requests import placed_drawing
from knifetip.service.limits.work_queue import queued
from knifetip.service.nestings.models import NestingIn, NestingOut
from knifetip.service.nestings.runner import NestingRunner
from knifetip.service.nestings.tables import Nesting
from knifetip.service.processes.nesting_tasks import prepare_parts

router = ScopedRouter(prefix="/nestings", tags=["layouts"])

NestingId = Annotated[str, Path(description="Id of the nesting")]


@router.post("", status_code=202)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def begin_nesting(
    service: ServiceDep, request: Request, response: Response, nesting: NestingIn
) -> NestingOut:
    """Begin to search for places of drawings that take as little board as possible.

    The first arrangement has the bounding boxes of the drawings in columns; better ones replace it
    until the time is over.  Blanks keep their gap in each arrangement that the server returns.
    """
    drawings = {part.drawing: placed_drawing(service, part.drawing) for part in nesting.parts}
    index = {id: number for number, id in enumerate(drawings)}
    parts = service.run(
        prepare_parts,
        [row.edges for row in drawings.values()],
        [(index[part.drawing], part) for part in nesting.parts],
        nesting.sheet.grain is not None,
    )
    runner: NestingRunner = request.app.state.nestings
    revisions = [drawings[part.drawing].version for part in nesting.parts]
    row = runner.begin(nesting, parts, revisions)
    response.headers["Location"] = f"/api/nestings/{row.id}"
    return _nesting_out(row)


@router.get("/{id}")
@requires(AccessScope.VIEWER)
def get_nesting(service: ServiceDep, id: NestingId) -> NestingOut:
    """Get a nesting with the best arrangement so far."""
    return _nesting_out(service.store.nestings.get(id))


@router.post("/{id}/stop", status_code=202)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def stop_nesting(service: ServiceDep, principal: PrincipalDep, id: NestingId) -> NestingOut:
    """Stop a nesting and keep its best arrangement; it is `stopped` after about a second.

    A nesting that has ended does not change.
    """
    _check_owner(service, principal, id)
    return _nesting_out(service.store.nestings.request_stop(id))


@router.delete("/{id}", status_code=204)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def delete_nesting(service: ServiceDep, principal: PrincipalDep, id: NestingId) -> None:
    """Delete a nesting; a running one is stopped.  Layouts that were stored stay."""
    _check_owner(service, principal, id)
    service.store.nestings.delete(id)


def _check_owner(service: Service, principal: Principal, id: str) -> None:
    """Raise ``AccessDenied`` unless a principal may change a nesting."""
    row = service.store.nestings.get(id)
    if row.owner not in ("", acting_owner()) and AccessScope.OPERATOR not in principal.scopes:
        raise AccessDenied("nesting.of-another", id=id)


def _nesting_out(row: Nesting) -> NestingOut:
    found = row.result or {"seconds": 0.0, "use": 0.0, "rectangles_use": 0.0, "sheets": []}
    return NestingOut.model_validate(
        {
            "in_holes": 0,  # in results of older versions
            **found,
            "id": row.id,
            "created": rfc3339(row.created),
            "state": row.state,
            "limit": row.request["seconds"],
            "count": sum(part["quantity"] for part in row.request["parts"]),
            "message": row.message,
        }
    )
