"""Routes for import formats, for boards and for tools of the library."""

from __future__ import annotations

from dataclasses import asdict
from typing import Annotated

from fastapi import Query, Request, Response

from knifetip.formats import FORMATS
from knifetip.library import deflection
from knifetip.library.load import find_cutter
from knifetip.model.board import Board, Deflection
from knifetip.model.tool import kind_of
from knifetip.service.components import ServiceDep
from knifetip.service.http.conditional import NOT_MODIFIED
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.parameters import BoardName
from knifetip.service.http.principal import PrincipalDep
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.library.machine_models import StationTool
from knifetip.service.library.models import BoardOut, CalibrationIn, CalibrationOut, FormatOut

router = ScopedRouter(tags=["library"])


@router.get("/formats")
@requires(AccessScope.VIEWER)
def list_formats(
    request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[FormatOut]:
    """List the file formats from which drawings are imported.

    Files of some formats are read only if another program, which converts them, is installed on the
    server.
    """
    return [
        FormatOut(
            name=one.name,
            title=one.title,
            extensions=list(one.extensions),
            available=one.is_available,
            converter=one.converter.title if one.converter else None,
        )
        for one in page_of(request, response, FORMATS, wanted)
    ]


@router.get("/boards", responses=NOT_MODIFIED)
@requires(AccessScope.VIEWER)
def list_boards(
    service: ServiceDep, request: Request, response: Response, wanted: Annotated[ListPage, Query()]
) -> list[BoardOut]:
    """List the boards: those of users and those of knifetip's library.

    The header `Link` contains the URL of the next page.
    """
    boards = page_of(request, response, service.store.library.boards(), wanted)
    return [_board_out(board) for board in boards]


@router.get("/boards/{name}")
@requires(AccessScope.VIEWER)
def get_board(service: ServiceDep, response: Response, name: BoardName) -> BoardOut:
    """Get a board of a user or of knifetip's library."""
    board = service.store.library.board(name)
    response.headers["ETag"] = f'"{board.version}"'
    return _board_out(board)


def _board_out(board: Board) -> BoardOut:
    fields = asdict(board)
    return BoardOut.model_validate({field: fields[field] for field in BoardOut.model_fields})


@router.post("/boards/{name}/deflection")
@requires(AccessScope.DESIGNER)
def calibrate(service: ServiceDep, name: BoardName, order: CalibrationIn) -> CalibrationOut:
    """Compute the deflection of a cutter in the board ``name`` from points measured on a contour.

    Nothing is stored; ``toml`` in the response contains the text lines for the file of the board.
    """
    service.store.library.board(name)
    station = find_cutter(service.store.library.machine(order.machine), order.tool)
    # The engines import numba, which listing the library does not need.
    from knifetip.compensation.calibration import calibrate as fit_deflection

    fitted = fit_deflection(
        [point.azimuth for point in order.points],
        [(point.dx, point.dy) for point in order.points],
        1 if order.side == "left" else -1,
    )
    result = Deflection(station.name, fitted.x, fitted.y)
    return CalibrationOut(
        board=name,
        machine=order.machine,
        tool=station.name,
        x=fitted.x,
        y=fitted.y,
        residual=fitted.residual,
        toml=deflection.deflection_toml(result),
    )


@router.get("/tools")
@requires(AccessScope.VIEWER)
def list_tools(
    service: ServiceDep,
    principal: PrincipalDep,
    request: Request,
    response: Response,
    wanted: Annotated[ListPage, Query()],
) -> list[StationTool]:
    """List the tools in the stations of all machines; `Link` has the URL of the next page."""
    found = [
        StationTool.model_validate(
            {
                "machine": machine.name,
                "station": station.number,
                "name": station.name,
                "kind": kind_of(station.tool).name,
                "dimensions": station.tool.dimensions,
                "footprint": station.tool.footprint,
            }
        )
        for machine in service.store.library.machines()
        if principal.limits.sees_machine(machine.name)
        for station in machine.stations
    ]
    return list(page_of(request, response, found, wanted))
