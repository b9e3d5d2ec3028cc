"""Models of the registration of a printed sheet: measured marks, and their fit."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from knifetip.model.registration import MOST_MARKS
from knifetip.service.http.message_models import MessageOut
from knifetip.service.http.models import Count, JsonBody

_Coordinate = Annotated[float, Field(ge=-100_000.0, le=100_000.0)]
_Point = Annotated[tuple[_Coordinate, _Coordinate], Field(strict=False)]


class MeasuredMarksIn(JsonBody):
    """Positions of the marks of a printed sheet, as a person at the machine has measured them."""

    positions: tuple[_Point, ...] = Field(
        strict=False,  # JSON has lists
        max_length=MOST_MARKS,
        description="Position of the axes above each mark, in the order of the job: X, Y (mm) in "
        "the work coordinates of programs. Empty to forget a measurement: the sheet then lies at "
        "the stops",
    )
    station: Count | None = Field(
        default=None,
        description="Number of the station that was moved above the marks; its offset is "
        "subtracted. Null for the axis of the head",
    )
    offset: _Point = Field(
        default=(0.0, 0.0),
        description="Further offset, such as that of a camera: from a mark to the position of the "
        "axes above it (mm)",
    )
    by: str = Field(
        default="",
        max_length=100,
        description="Name of the operator, for the record of job events; empty if it is not known",
    )


class MarkOut(BaseModel):
    """A mark of a printed sheet."""

    x: float = Field(description="X of its centre in the drawing (mm)")
    y: float = Field(description="Y of its centre in the drawing (mm)")
    expected: tuple[float, float] = Field(
        description="Where it lies on the table for the program of the job: X, Y (mm)"
    )
    measured: tuple[float, float] | None = Field(
        description="Where it was measured on the table: X, Y (mm); null if it was not"
    )
    error: tuple[float, float] | None = Field(
        description="From where the fit of all marks places it to where it was measured: X, Y "
        "(mm); null without measurement"
    )


class RegistrationOut(BaseModel):
    """How a printed sheet lies on the table."""

    marks: list[MarkOut] = Field(description="The marks, in the order in which they are measured")
    shift: tuple[float, float] | None = Field(
        description="Where the origin of the drawing lies on the table: X, Y (mm); null without "
        "measurement"
    )
    turn: float | None = Field(
        description="Angle by which the sheet is turned, counter-clockwise (degrees); null without "
        "measurement"
    )
    scale: float | None = Field(
        description="Size of the print divided by that of the drawing; null without measurement"
    )
    largest_error: float | None = Field(
        description="Greatest error of a mark (mm); null without measurement"
    )
    limit: float = Field(description="Greatest permitted error of a mark (mm)")
    refusal: MessageOut | None = Field(
        description="Why the job cannot be compiled for these marks; null if it can"
    )
