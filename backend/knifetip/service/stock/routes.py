"""Routes for sheets in stock: whole sheets, stacks, rolls and remnants.

Layouts and nestings are made on these sizes; nothing is taken from the stock by a job.
"""

from __future__ import annotations

from typing import Annotated

from fastapi import Path, Query, Request, Response
from pydantic import Field

from knifetip.service.components import ServiceDep
from knifetip.service.http.models import ListPage
from knifetip.service.http.pages import page_of
from knifetip.service.http.routing import ScopedRouter, requires
from knifetip.service.http.scopes import AccessScope
from knifetip.service.http.times import rfc3339
from knifetip.service.stock.models import StockSheetIn, StockSheetOut, StockSheetPatch
from knifetip.service.stock.tables import StockSheet

router = ScopedRouter(prefix="/stock-sheets", tags=["layouts"])

StockSheetId = Annotated[str, Path(max_length=200, description="Id of the sheets")]


class StockQuery(ListPage):
    """Which sheets are listed."""

    board: str | None = Field(
        default=None,
        max_length=80,
        description="Name of a board: only sheets of it, and those for which no board is stated",
    )


@router.post("", status_code=201)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def add_stock_sheets(service: ServiceDep, response: Response, new: StockSheetIn) -> StockSheetOut:
    """Add sheets of one board and one size to the stock, such as the remnant of a sheet."""
    columns = {**new.model_dump(), "grain": new.grain or ""}
    row = service.store.stock.add(**columns)
    response.headers["Location"] = f"/api/stock-sheets/{row.id}"
    return _out(row)


@router.get("")
@requires(AccessScope.VIEWER)
def list_stock_sheets(
    service: ServiceDep,
    request: Request,
    response: Response,
    wanted: Annotated[StockQuery, Query()],
) -> list[StockSheetOut]:
    """List the sheets in stock, smallest first.

    With `board`, only sheets of this board and those for which no board is stated.  The header
    `Link` contains the URL of the next page.
    """
    rows = service.store.stock.all(wanted.board)
    return [_out(row) for row in page_of(request, response, rows, wanted)]


@router.patch("/{id}")
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def change_stock_sheets(
    service: ServiceDep, id: StockSheetId, patch: StockSheetPatch
) -> StockSheetOut:
    """Change the number of sheets."""
    return _out(service.store.stock.set_count(id, patch.count))


@router.delete("/{id}", status_code=204)
@requires(AccessScope.DESIGNER, AccessScope.ORDER)
def delete_stock_sheets(service: ServiceDep, id: StockSheetId) -> None:
    """Delete sheets from the stock."""
    service.store.stock.delete(id)


def _out(row: StockSheet) -> StockSheetOut:
    return StockSheetOut(
        id=row.id,
        created=rfc3339(row.created),
        board=row.board,
        width=row.width,
        height=row.height,
        grain="x" if row.grain == "x" else "y" if row.grain == "y" else None,
        count=row.count,
        note=row.note,
    )
