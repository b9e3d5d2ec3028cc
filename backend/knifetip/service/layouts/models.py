"""Models for layouts: sheets with the drawings that are placed on them."""

from __future__ import annotations

from pydantic import BaseModel, Field

from knifetip.model.layout import Layout, LayoutSheet, PlacedDrawing
from knifetip.service.drawings.models import Owner, Revision, Shared
from knifetip.service.http.models import JsonBody, Name, QuestionOut
from knifetip.service.http.times import Moment
from knifetip.service.order_details.models import OrderDetailsIn, OrderDetailsOut


class LayoutIn(Layout, OrderDetailsIn):
    """A new layout."""

    name: Name = Field(description="Name of the layout, such as the number of the job")


class LayoutPut(Layout, JsonBody):
    """A new revision of a layout, which replaces the sheet and all that is placed on it."""

    name: Name | None = Field(default=None, description="New name; null to keep the name")


class CopyOut(BaseModel):
    """A copy of a drawing on the sheet."""

    placed: int = Field(description="Index of its entry in `placed`, counted from 0")
    box: tuple[float, float, float, float] = Field(
        description="Bounding box on the sheet: x min, y min, x max, y max (mm)"
    )
    turn: float = Field(description="Angle by which the drawing is turned (°)")
    mirror: bool = Field(description="Whether the drawing is mirrored")


class OverlapOut(BaseModel):
    """Two copies that overlap.  No program is made for a layout with overlaps."""

    copies: tuple[int, int] = Field(description="Numbers of the copies, counted from 1")
    area: float = Field(description="Area in which they overlap (mm²)")


class OffSheetOut(BaseModel):
    """A copy that extends over the edge of the sheet; no program is made for such a layout."""

    number: int = Field(description="Number of the copy, counted from 1")
    distance: float = Field(description="Distance by which it extends over the edge (mm)")


class LayoutSummary(OrderDetailsOut):
    """A layout as an item of a list of layouts."""

    id: str = Field(
        description="Id of the layout; it is also the id of the drawing of its whole sheet, which "
        "an order names and `/api/drawings/{id}` shows"
    )
    revision: Revision
    name: str = Field(description="Name of the layout")
    created: Moment = Field(description="Time at which the layout was stored first")
    updated: Moment = Field(description="Time of the last change")
    owner: Owner = ""
    shared: Shared = False
    sheet: LayoutSheet = Field(description="The sheet")
    count: int = Field(description="Number of copies on the sheet")
    area: float = Field(description="Area of board of all copies (mm²)")
    use: float = Field(description="Share of the sheet that the copies use (%)")
    questions: int = Field(description="Number of open questions about the drawings")


class LayoutOut(LayoutSummary):
    """A layout: a sheet with placed drawings, and what follows from their places."""

    placed: list[PlacedDrawing] = Field(
        description="Drawings on the sheet, with the revisions from which the sheet was composed"
    )
    copies: list[CopyOut] = Field(description="All copies, in the order of `placed`, row by row")
    overlaps: list[OverlapOut] = Field(description="Copies that overlap; empty if none do")
    off_sheet: list[OffSheetOut] = Field(
        description="Copies that extend over the edge of the sheet; empty if none do"
    )
    open_questions: list[QuestionOut] = Field(
        description="Questions about the placed drawings; they are answered in the drawings"
    )
