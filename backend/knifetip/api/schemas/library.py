"""library: what is said of boards, and of how far tools bend in them."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.api.schemas.common import Name, Strict


class FormatOut(BaseModel):
    """A file format that drawings are imported from."""

    name: str
    title: str
    extensions: list[str] = Field(description="Of file names, with the dot, the usual one first")


class DeflectionOut(BaseModel):
    """How far a tool gives way in a board (mm)."""

    tool: str
    x: float
    y: float


class BoardOut(BaseModel):
    """A board of the library."""

    name: str
    title: str
    material: str
    caliper: float
    grain: float
    crease_along: float
    crease_across: float
    groove_depth: float
    deflection: list[DeflectionOut]


class MeasuredPoint(Strict):
    """One point of a contour that was cut and measured."""

    azimuth: float = Field(ge=-360.0, le=360.0, description="Degrees, of the cutter's travel there")
    dx: float = Field(ge=-100.0, le=100.0, description="mm: where it came to lie, less as drawn")
    dy: float = Field(ge=-100.0, le=100.0)


class CalibrationIn(Strict):
    """Points measured on a contour that a machine's cutter cut in a board."""

    machine: Name
    tool: Name = Field(description="Name of its station")
    side: Literal["left", "right"] = Field(
        default="left", description="Of travel, where the cutter ran; knifetip's programs: left"
    )
    points: list[MeasuredPoint] = Field(min_length=1, max_length=10_000)


class CalibrationOut(BaseModel):
    """How far the cutter gives way in the board, and the lines to keep in the board's file."""

    board: str
    machine: str
    tool: str
    x: float = Field(description="mm, where the contour runs along Y")
    y: float = Field(description="mm, where it runs along X")
    residual: float = Field(description="mm, the farthest that a point is from what these say")
    toml: str
