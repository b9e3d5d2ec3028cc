"""Models for import formats, boards and measured deflections."""

from __future__ import annotations

from typing import Literal

from pydantic import BaseModel, Field

from knifetip.api.schemas.common import Name, Strict


class FormatOut(BaseModel):
    """An import format of drawings."""

    name: str
    title: str
    extensions: list[str] = Field(
        description="File name extensions with the dot, most common first"
    )


class DeflectionOut(BaseModel):
    """Maximum deflection of a cutter under load in a board (mm)."""

    tool: str = Field(description="Name of the cutter's station")
    x: float = Field(description="Deflection in X")
    y: float = Field(description="Deflection in Y")


class BoardOut(BaseModel):
    """A board of the library; lengths in mm, angles in degrees."""

    name: str
    title: str
    material: str
    caliper: float = Field(description="Thickness")
    grain: float = Field(description="Direction of flute or grain on the sheet")
    crease_along: float = Field(description="Depth of a crease along flute or grain")
    crease_across: float = Field(description="Depth of a crease across flute or grain")
    groove_depth: float = Field(description="Depth of a V-groove below the top face")
    deflection: list[DeflectionOut] = Field(
        description="Deflection of the cutters that were measured in this board"
    )


class MeasuredPoint(Strict):
    """One measured point of a cut contour."""

    azimuth: float = Field(
        ge=-360.0, le=360.0, description="Direction of travel at the point (degrees)"
    )
    dx: float = Field(ge=-100.0, le=100.0, description="Measured minus drawn position (mm)")
    dy: float = Field(ge=-100.0, le=100.0, description="Measured minus drawn position (mm)")


class CalibrationIn(Strict):
    """Points that were measured on a contour cut in a board."""

    machine: Name
    tool: Name = Field(description="Name of the cutter's station")
    side: Literal["left", "right"] = Field(
        default="left",
        description="Side on which the cutter ran, in travel direction (knifetip: left)",
    )
    points: list[MeasuredPoint] = Field(min_length=1, max_length=10_000)


class CalibrationOut(BaseModel):
    """Deflection of the cutter in the board, and the TOML text for the file of the board."""

    board: str
    machine: str
    tool: str
    x: float = Field(description="Deflection where the contour runs along Y (mm)")
    y: float = Field(description="Deflection where the contour runs along X (mm)")
    residual: float = Field(description="Largest residual of a point (mm)")
    toml: str = Field(description="Text lines for the file of the board")
