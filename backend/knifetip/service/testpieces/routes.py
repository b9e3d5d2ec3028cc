"""Routes for test pieces: list them, show a picture, store a drawing, and evaluate measures."""

from __future__ import annotations

from typing import Annotated, Any, Final

from fastapi import Path, Query, Request, Response

from knifetip.messages import with_text
from knifetip.service.components import ServiceDep
from knifetip.service.drawings.requests import Upload, add_drawing
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import IdempotencyKey
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import queued
from knifetip.service.testpieces.drawing import (
    draw_piece,
    piece_figures,
    piece_name,
    piece_picture,
)
from knifetip.service.testpieces.models import (
    BenchQuery,
    FigureOut,
    FiguresIn,
    PieceIn,
    PieceOut,
    WizardOut,
)
from knifetip.testpieces.registry import WIZARDS
from knifetip.testpieces.wizard import Figure, Wizard

router = ScopedRouter(prefix="/testpieces", tags=["library"])

_SVG: Final[dict[str, Any]] = {"content": {"image/svg+xml": {"schema": {"type": "string"}}}}


@router.get("")
@requires(AccessScope.VIEWER)
def list_test_pieces(
    request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[WizardOut]:
    """List the test pieces, with the JSON Schema of what is measured on each."""
    wizards = page_of(request, response, list(WIZARDS.values()), wanted)
    return [_wizard_out(wizard) for wizard in wizards]


def _wizard_out(wizard: Wizard) -> WizardOut:
    return WizardOut.model_validate(
        {
            "code": wizard.code,
            "name": with_text(wizard.name),
            "description": with_text(wizard.description),
            "instruction": with_text(wizard.instruction),
            "kinds": list(wizard.kinds),
            "measures": wizard.measures.model_json_schema(),
        }
    )


@router.get("/{code}/picture", response_class=Response, responses={200: _SVG})
@requires(AccessScope.VIEWER)
def get_test_piece_picture(
    service: ServiceDep,
    code: Annotated[str, Path(description="Code of the test piece, such as `knife-depth`")],
    query: Annotated[BenchQuery, Query()],
) -> Response:
    """Get a picture of a test piece as SVG, with arrows for what is measured.

    The status is 422 if the station cannot make the piece in the board.
    """
    return Response(piece_picture(service, code, query), media_type="image/svg+xml")


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER)
@queued
def draw_test_piece(
    service: ServiceDep, response: Response, order: PieceIn, key: IdempotencyKey = None
) -> PieceOut:
    """Draw a test piece, and store it like an uploaded drawing.

    It is ordered like any drawing, with the options in the answer.
    """
    piece, content = draw_piece(service, order)
    drawing = add_drawing(service, response, Upload(piece_name(order), content), key)
    return PieceOut(
        drawing=drawing,
        cut_depths=list(piece.cut_depths),
        crease_depths=list(piece.crease_depths),
    )


@router.post("/figures")
@requires(AccessScope.DESIGNER)
def evaluate_test_piece(service: ServiceDep, order: FiguresIn) -> list[FigureOut]:
    """Compute the settings that follow from the measures of a test piece; nothing is stored."""
    return [_figure_out(figure) for figure in piece_figures(service, order)]


def _figure_out(figure: Figure) -> FigureOut:
    fields = {**figure._asdict(), "name": figure.name, "path": list(figure.path)}
    return FigureOut.model_validate(
        {**fields, "label": with_text(figure.label), "significant": figure.is_significant}
    )
