"""Draw cartons for requests: as a file that is stored like an upload, and as a picture."""

from __future__ import annotations

from typing import Any

from fastapi.exceptions import RequestValidationError
from pydantic import TypeAdapter, ValidationError

from knifetip.cartons.parameters import CartonSize
from knifetip.cartons.style import Style
from knifetip.library.definition import Shelf, board_of
from knifetip.model.board import Board
from knifetip.presentation.picture import svg_edges
from knifetip.service.cartons.models import CartonQuery, CodedCarton
from knifetip.service.components import Service
from knifetip.service.processes import carton_tasks

_OBJECT: TypeAdapter[dict[str, Any]] = TypeAdapter(dict[str, Any])


def carton_name(carton: CodedCarton, board: str) -> str:
    """Return the file name of a carton: its code, its dimensions and its board."""
    sides = (carton.length, carton.width, carton.depth)
    return f"{carton.code} {'x'.join(f'{side:g}' for side in sides)} {board}.dxf"


def draw_carton(service: Service, carton: CodedCarton, board: str) -> bytes:
    """Return the DXF file of a carton, drawn in a worker process.

    Parameters
    ----------
    service
        The server.
    carton
        Style, dimensions and options.
    board
        Name of a board of the library.

    Raises
    ------
    ImpossibleCarton
        The style cannot have the dimensions.
    LibraryError
        There is no such board.
    """
    definition = service.store.library.definition(Shelf.BOARDS, board)
    fields = carton.model_dump(exclude={"code"})
    content: bytes = service.run(carton_tasks.draw_carton, carton.code, fields, definition)
    return content


def carton_picture(style: Style, query: CartonQuery, board: Board) -> str:
    """Return a picture of a carton as SVG; for the errors see ``draw_carton``.

    Raises
    ------
    RequestValidationError
        An option is unknown or has a wrong value.
    """
    edges = style.draw(_parameters(style, query), board).edges()
    return svg_edges(edges.ends, edges.bulge, edges.line_type)


def board_of_picture(service: Service, style: Style, query: CartonQuery) -> Board:
    """Return the board of a picture; raise ``LibraryError`` if there is none with its name."""
    name = query.board or style.board
    return board_of(service.store.library.definition(Shelf.BOARDS, name))


def _parameters(style: Style, query: CartonQuery) -> CartonSize:
    """Return the parameters of a picture: those of the query, and for the rest the example."""
    given = query.model_dump(include={"length", "width", "depth"}, exclude_none=True)
    try:
        options = _OBJECT.validate_json(query.options)
    except ValidationError as reason:
        raise _invalid(reason, "options") from None
    try:
        return style.parameters.model_validate({**style.example.model_dump(), **options, **given})
    except ValidationError as reason:
        raise _invalid(reason) from None


def _invalid(reason: ValidationError, *place: str) -> RequestValidationError:
    faults = reason.errors(include_url=False)
    return RequestValidationError(
        [{**fault, "loc": ("query", *place, *fault["loc"])} for fault in faults]
    )
