"""Routes for cartons: list the styles, show a picture of one, and make a drawing."""

from __future__ import annotations

from typing import Annotated, Any, Final

from fastapi import Path, Query, Request, Response

from knifetip.cartons.registry import STYLES, style_of
from knifetip.cartons.style import Style
from knifetip.messages import with_text
from knifetip.service.cartons.drawing import (
    board_of_picture,
    carton_name,
    carton_picture,
    draw_carton,
)
from knifetip.service.cartons.models import CartonDrawingIn, CartonQuery, CartonStyleOut
from knifetip.service.components import ServiceDep
from knifetip.service.drawings.models import DrawingOut
from knifetip.service.drawings.requests import Upload, add_drawing, drawing_name
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import IdempotencyKey
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.limits.work_queue import queued
from knifetip.service.order_details.models import details_columns

router = ScopedRouter(prefix="/cartons", tags=["cartons"])

_SVG: Final[dict[str, Any]] = {"content": {"image/svg+xml": {"schema": {"type": "string"}}}}


@router.get("")
@requires(AccessScope.VIEWER)
def list_cartons(
    request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[CartonStyleOut]:
    """List the carton styles, with the JSON Schema of the parameters of each."""
    styles = page_of(request, response, list(STYLES.values()), wanted)
    return [_style_out(style) for style in styles]


def _style_out(style: Style) -> CartonStyleOut:
    return CartonStyleOut.model_validate(
        {
            "code": style.code,
            "name": with_text(style.name),
            "description": with_text(style.description),
            "parameters": style.parameters.model_json_schema(),
            "example": style.example.model_dump(),
            "board": style.board,
            "materials": list(style.materials),
        }
    )


@router.get("/{code}/picture", response_class=Response, responses={200: _SVG})
@requires(AccessScope.VIEWER)
def get_carton_picture(
    service: ServiceDep,
    code: Annotated[str, Path(description="Code of the style, such as `fefco-0427`")],
    query: Annotated[CartonQuery, Query()],
) -> Response:
    """Get a picture of a carton as SVG, in the colours of line types.

    The status is 422 if the style cannot have the dimensions.
    """
    style = style_of(code)
    picture = carton_picture(style, query, board_of_picture(service, style, query))
    return Response(picture, media_type="image/svg+xml")


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
@queued
def draw_carton_as_drawing(
    service: ServiceDep, response: Response, order: CartonDrawingIn, key: IdempotencyKey = None
) -> DrawingOut:
    """Draw a carton, and store it like an uploaded drawing.

    An order can also contain a `carton` instead of a drawing.
    """
    content = draw_carton(service, order.carton, order.board)
    name = drawing_name(order.name or carton_name(order.carton, order.board))
    upload = Upload(name, content, details=details_columns(order))
    return add_drawing(service, response, upload, key)
