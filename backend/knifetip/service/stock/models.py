"""Models for sheets in stock."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.model.sheet import SheetSize
from knifetip.service.http.models import WHOLE, JsonBody
from knifetip.service.http.times import Moment

SheetCount = Annotated[int, Field(ge=1, le=100_000), WHOLE]


class StockSheetFields(BaseModel):
    """Sheets of one board and one size."""

    board: str = Field(
        default="", max_length=80, description="Name of the board in the library; empty for any"
    )
    width: SheetSize = Field(description="Size along X (mm)")
    height: SheetSize = Field(description="Size along Y (mm)")
    grain: Annotated[Literal["x", "y"] | None, LISTED] = Field(
        default=None,
        description="Axis along which the fibres of the board or its flutes run; null if unknown",
    )
    count: SheetCount | None = Field(
        default=1,
        description="Number of sheets; null for as many as needed, such as from a stack or, with "
        "the length to which it is cut as `width`, from a roll",
    )
    note: str = Field(
        default="", max_length=200, description="Where they lie, or from which job they are left"
    )


class StockSheetIn(StockSheetFields, JsonBody):
    """Sheets that are added to the stock."""


class StockSheetPatch(JsonBody):
    """A new number of sheets."""

    count: SheetCount | None = Field(
        description="Number of sheets; null for as many as needed. DELETE removes the last one"
    )


class StockSheetOut(StockSheetFields):
    """Sheets in stock."""

    id: str = Field(description="Id of the sheets, assigned by the server")
    created: Moment = Field(description="Time at which they were added")
