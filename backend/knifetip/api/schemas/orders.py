"""Models for new jobs: drawing, machine, board and options, and shortfalls that a user accepts."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import Field, model_validator

from knifetip.api.schemas.common import WHOLE, Copies, Count, JsonBody, Name, Priority
from knifetip.api.schemas.drawings import Override
from knifetip.api.schemas.order_details import OrderDetailsIn
from knifetip.fields import LISTED, field_error

CornerType = Annotated[Literal["auto", "B", "C", "D"], LISTED]
CornerParameter = Annotated[
    float, Field(gt=0.0, lt=1.0, description="Parameter k of type D: 0 is like B, 1 is like C")
]
Lift = Annotated[Literal["clearance", "least"], LISTED]
SheetSize = Annotated[float, Field(gt=0.0, le=10_000.0)]


class CornerAt(JsonBody):
    """Corner type of one corner, which is selected by its position."""

    x: float = Field(
        description="X in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    y: float = Field(
        description="Y in the drawing (mm); the point must be within 0.5 mm of a corner"
    )
    type: CornerType = Field(
        description="Corner type of this corner; auto: the type that is fastest on the machine"
    )
    k: CornerParameter | None = Field(
        default=None,
        description="Parameter k of this corner, if it has type D; null for the `k` of the job",
    )


class Corners(JsonBody):
    """Types of the outer corners of a job.

    At an outer corner the cutter or laser stays on the waste side of the contour and so moves
    around the corner.  The type is the shape of this path.  Type B is an arc.  Type C consists of
    straight lines with a stop at each bend.  Type D consists of a line, an arc and a line.
    ``auto`` chooses for each corner the type that is fastest on the machine.
    """

    type: CornerType = Field(
        default="auto",
        description="Type of all corners that are not in `at`; auto: for each corner the type "
        "that is fastest on the machine",
    )
    k: CornerParameter = Field(
        default=0.5,
        description="Parameter k of corners of type D, between 0 (like type B) and 1 (like type C)",
    )
    interference: Annotated[Literal["trim", "refuse"], LISTED] = Field(
        default="trim",
        description="What happens if the cutter does not fit into a place: trim leaves the area "
        "uncut, refuse refuses the job",
    )
    at: list[CornerAt] = Field(
        default=[],
        strict=False,  # the corners of a stored job are in a tuple
        max_length=1000,
        description="Corners with a type of their own; empty if there are none",
    )


class Sheet(JsonBody):
    """A sheet that was cut to size before the job.

    No board lies outside it, so tools turn without a lift beside it.  The sheet is a rectangle if
    it has a size.  Without a size, it was cut to the outline of the drawing.
    """

    width: SheetSize | None = Field(
        default=None,
        description="Size along X (mm); null for a sheet that was cut to the outline of the "
        "drawing",
    )
    height: SheetSize | None = Field(
        default=None, description="Size along Y (mm); null exactly if `width` is null"
    )
    margin: float = Field(
        default=0.0,
        ge=0.0,
        le=10_000.0,
        description="Distance of the drawing from the left and from the lower edge of the sheet "
        "(mm); 0 for a sheet without a size",
    )

    @model_validator(mode="after")
    def _whole(self) -> Sheet:
        if (self.width is None) != (self.height is None) or (self.width is None and self.margin):
            raise field_error("field.sheet-size")
        return self


class ShortfallIn(JsonBody):
    """A shortfall of a verdict, selected by its edge and its code."""

    edge: Count = Field(
        description="Row of the edge in the drawing, counted from 0, as in the finding"
    )
    code: str = Field(max_length=100, description="Code of the finding's message")


class ExceptionsIn(JsonBody):
    """Shortfalls of a verdict that a user accepts."""

    findings: list[ShortfallIn] = Field(
        min_length=1, max_length=1000, description="Shortfalls to accept"
    )
    reason: str = Field(
        min_length=1, max_length=500, description="Why the shortfalls are acceptable"
    )
    by: str = Field(min_length=1, max_length=100, description="Name of the user")


class JobChoices(OrderDetailsIn):
    """Choices for a new job, except its drawing."""

    machine: Name = Field(
        default="demo-table",
        description="Name of the machine in the library, as in `GET /api/machines`",
    )
    board: Name = Field(description="Name of the board in the library, as in `GET /api/boards`")
    profile: Name | None = Field(
        default=None,
        description="Name of the classification profile; null for the profile of the drawing",
    )
    copies: Copies = Field(default=1, description="Number of sheets to make")
    priority: Priority = Field(
        default=0,
        description="Priority in the queue of the machine; jobs with a higher number come first",
    )
    overrides: list[Override] = Field(
        default=[],
        max_length=1000,
        description="Line types of edges for this job only, in addition to those of the drawing",
    )
    corners: Corners | None = Field(
        default=None,
        description="Corner types, for routers and lasers only; null for the fastest types",
    )
    sheet: Sheet | None = Field(
        default=None,
        description="Sheet that was cut to size before the job; null if the sheet may be larger "
        "than the drawing",
    )
    lift: Lift = Field(
        default="clearance",
        description="Height of the tool above the board in turns. clearance: the clearance of the "
        "machine. least: the `turn_clearance` of the machine where that is faster; only for board "
        "that lies flat",
    )
    release: bool = Field(
        default=False,
        description="Whether to queue the job as soon as its program is accepted; if false, the "
        "job stays `ready` until it is released",
    )
    exceptions: ExceptionsIn | None = Field(
        default=None,
        description="Shortfalls that the user accepts in advance, as those of an earlier job for "
        "the same drawing. Shortfalls that the program does not have are disregarded; all others "
        "refuse it. Null for none",
    )


class JobIn(JobChoices):
    """A new job: a drawing, a machine and a board."""

    drawing: Name = Field(description="Id of the drawing")
    revision: Annotated[int, Field(ge=1, le=2**31 - 1), WHOLE] | None = Field(
        default=None,
        description="Expected revision of the drawing; the status is 412 if the drawing has "
        "another one. Null for the newest revision",
    )
