"""Models for drawings that are folded in space."""

from __future__ import annotations

from typing import Annotated, Literal

from fastapi import Query
from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import LineTypeWord, Name

_Point = tuple[float, float]
_Place = tuple[float, float, float]
_Row = tuple[float, float, float, float]


class FoldingQuery(BaseModel):
    """Parameters of requests for a folded drawing."""

    board: Name = Field(description="Name of the board in the library, as in `GET /api/boards`")
    fraction: float = Field(
        default=1.0, ge=0.0, le=1.0, description="Share of its angle by which each fold has turned"
    )
    side_up: Annotated[Literal["outside", "inside"], LISTED] = Field(
        default="outside",
        description="Side of the carton that lies on top: creases fold away from the top face if "
        "it is the outside, else towards it. V-grooves always close towards the top face",
    )
    opening: float | None = Field(
        default=None,
        gt=0.0,
        lt=180.0,
        description="Opening angle of V-grooves, twice the tilt of the V-cutter (degrees); the "
        "fold angle of the board if it is missing",
    )
    angle: Annotated[list[str], Query(max_length=500)] = Field(
        default=[],
        description="Number of a fold, a colon, and the angle of the fold at fraction 1 (degrees, "
        "-180 to 180; positive: towards the top face), such as `3:45`. Other creases fold by 90° "
        "and V-grooves by the fold angle of the board",
    )


class FoldedPanel(BaseModel):
    """A part of a blank between cuts and folds; it stays flat."""

    number: int = Field(description="Number of the panel, from 1")
    blank: int = Field(description="Number of its blank, from the largest one, from 1")
    area: float = Field(description="Area (mm²)")
    bottom: list[list[_Point]] = Field(
        description="Corners (x, y) of the outline (counter-clockwise) and of each hole "
        "(clockwise) in the bottom face of the flat board, at z = 0 (mm)"
    )
    top: list[list[_Point]] = Field(
        description="The same corners in the top face, at z = `caliper` (mm). At folds, the faces "
        "differ by the bevel of the groove or the crease"
    )
    transform: tuple[_Row, _Row, _Row, _Row] = Field(
        description="Rows of the 4 × 4 matrix that takes a point (x, y, z, 1) of the flat board "
        "(mm) to its place at `fraction`"
    )


class FoldOut(BaseModel):
    """A fold between two panels."""

    number: int = Field(description="Number of the fold, from 1")
    parent: int = Field(description="Number of the panel nearer to the root of the blank")
    child: int = Field(description="Number of the panel that turns")
    type: LineTypeWord = Field(description="Line type along which the board folds")
    axis: tuple[_Place, _Place] = Field(
        description="Start and end of the axis in the flat board (mm), with the child on its left"
    )
    length: float = Field(description="Length of the folding lines without gaps (mm)")
    angle: float = Field(
        description="Angle at fraction 1 (degrees); positive: the child rises towards the top face"
    )
    opening: float | None = Field(
        description="Angle at which the flanks of a V-groove meet (degrees); null for other folds"
    )
    closes: bool = Field(
        description="Whether other folds join the two panels already. Such a fold turns nothing: "
        "its panels meet when the others have turned"
    )
    straight: bool = Field(
        description="Whether the folding lines lie on one straight line; otherwise the fold stays "
        "flat"
    )


class FoldFindingOut(MessageOut):
    """A fault of the blanks when they are folded by their whole angles."""

    panels: list[int] = Field(description="Numbers of the panels, the faulty one first")
    fold: int | None = Field(description="Number of the fold; null if it is not about a fold")
    place: _Point = Field(description="Place on the first panel, in the drawing (mm)")
    measure: float = Field(description="Size of the fault (mm; degrees for angles of grooves)")


class FoldingOut(BaseModel):
    """A drawing folded in space."""

    caliper: float = Field(description="Thickness of the board (mm)")
    fraction: float = Field(description="Share of its angle by which each fold has turned, 0 … 1")
    roots: list[int] = Field(description="Number of the panel of each blank that stays in place")
    order: list[int] = Field(
        description="Numbers of the folds that turn a panel, each after those of its parent"
    )
    panels: list[FoldedPanel] = Field(
        description="All panels, at most 500; empty if the cuts enclose no area"
    )
    folds: list[FoldOut] = Field(description="All folds")
    findings: list[FoldFindingOut] = Field(
        description="Faults at fraction 1, at most 100; empty if none were found"
    )
