"""Routes for drawings that are folded in space along their creases and V-grooves."""

from __future__ import annotations

import hashlib
import math
from collections.abc import Callable
from typing import Annotated, Any

from fastapi import Query, Response
from fastapi.concurrency import run_in_threadpool

from knifetip.errors import RequestError
from knifetip.folding.records import FoldOptions
from knifetip.service.components import Service, ServiceDep
from knifetip.service.database.tables import Drawing
from knifetip.service.documents.responses import AnswerDep, Document
from knifetip.service.folding import tasks
from knifetip.service.folding.models import FoldingOut, FoldingQuery
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.downloads import file_name
from knifetip.service.http.parameters import DrawingId
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope

router = ScopedRouter(prefix="/drawings", tags=["drawings"])

_MEDIA = "model/gltf-binary"
_GLB: dict[str, Any] = {"content": {_MEDIA: {"schema": {"type": "string", "format": "binary"}}}}


@router.get("/{id}/folding", response_model=FoldingOut, responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
async def get_folding(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
    wanted: Annotated[FoldingQuery, Query()],
) -> Response:
    """Fold the blanks of a drawing along their creases, combi lines and V-grooves.

    The answer has the panels with their places, the tree of folds, and faults of the folded blanks:
    panels that cross, flaps that are too long, and grooves that close before the fold is complete.
    Perforations and half-cuts do not divide a panel.  Creases and edges of the board may give way
    by its caliper, and by 1 mm in thin board; what overlaps by less is no fault.
    """
    document = await run_in_threadpool(_document, service, wanted, "folding", tasks.folding)
    return await answer.send(id, document)


@router.get("/{id}/folding.glb", response_class=Response, responses={200: _GLB, **NOT_MODIFIED})
@requires(AccessScope.VIEWER)
async def get_folding_file(
    service: ServiceDep,
    answer: AnswerDep,
    id: DrawingId,
    wanted: Annotated[FoldingQuery, Query()],
) -> Response:
    """Get a folded drawing as a binary glTF 2.0 file for other 3D programs.

    The panels are solids with the thickness of the board, in metres.  An animation folds them.
    """
    document = await run_in_threadpool(_document, service, wanted, "folding-glb", tasks.glb, _MEDIA)
    response = await answer.send(id, document)
    response.headers["Content-Disposition"] = f'attachment; filename="{file_name(id)}.glb"'
    return response


def _document(
    service: Service,
    wanted: FoldingQuery,
    kind: str,
    task: Callable[..., bytes],
    media: str = "application/json",
) -> Document[Drawing]:
    """Return a document about a folded drawing, which a worker process makes each time."""
    board = service.store.library.board(wanted.board)
    angles = dict(_angle_of(text) for text in wanted.angle)
    options = FoldOptions(wanted.side_up, wanted.opening, angles)
    tag = hashlib.sha256(repr((board, options, wanted.fraction)).encode()).hexdigest()[:16]
    return Document(
        kind=kind,
        read=service.store.drawings.get_with,
        columns=("edges",),
        version=lambda row: f"{row.version}-{tag}",
        # There are as many documents as there are angles: they are not stored.
        is_large=lambda _: False,
        task=task,
        arguments=lambda row: (row.edges, board, options, wanted.fraction),
        calculates=True,
        media=media,
    )


def _angle_of(text: str) -> tuple[int, float]:
    """Return index and angle of a fold from a text such as ``3:45``."""
    number, _, angle = text.partition(":")
    try:
        fold, degrees = int(number) - 1, float(angle)
    except ValueError:
        fold, degrees = -1, math.nan
    if fold < 0 or not -180.0 <= degrees <= 180.0:
        raise RequestError("folding.angle-invalid", value=text[:40])
    return fold, degrees
