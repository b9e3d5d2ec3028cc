"""Models for import formats, boards and measured deflections."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, Field

from knifetip.fields import LISTED
from knifetip.service.http.models import JsonBody, Name


class FormatOut(BaseModel):
    """A file format from which drawings can be imported."""

    name: str = Field(description="Name of the format, such as dxf")
    title: str = Field(description="Name of the format for display")
    extensions: list[str] = Field(
        description="File name extensions with the dot, most common first"
    )
    available: bool = Field(
        description="Whether files are read: the program that must convert them is installed"
    )
    converter: str | None = Field(
        description="Program that converts files before they are read; null if none is needed"
    )


class DeflectionOut(BaseModel):
    """Measured maximum displacement of one cutter by the cutting force in a board (mm)."""

    tool: str = Field(description="Name of the station that holds the cutter")
    x: float = Field(description="Maximum deflection in X (mm)")
    y: float = Field(description="Maximum deflection in Y (mm)")


class ToolLimitsOut(BaseModel):
    """How fast and how deep the tools of one kind may work in a board."""

    kind: str = Field(description="Kind of tool, such as knife or cutter")
    feed: float = Field(description="Greatest feed in the board (mm/min); 0: no limit")
    step: float = Field(
        description="Greatest depth of one pass of a cutter or a knife (mm); 0: no limit"
    )
    slow_radius: float = Field(
        description="Radius of a curve below which the feed of a knife is lower in proportion to "
        "the radius (mm); 0: nowhere"
    )
    blade: Annotated[Literal["", "fixed", "oscillating"], LISTED] = Field(
        description="Kind of knife that suits the board; empty: any"
    )


class BoardOut(BaseModel):
    """A board of a user or of knifetip's library; lengths in mm, angles in degrees."""

    name: str = Field(description="Name of the board, to be used in requests")
    version: int = Field(
        description="Version of a user's board; 0 for a board of knifetip's library"
    )
    title: str = Field(description="Name of the board for display; may be empty")
    material: str = Field(
        description="Material: corrugated, folding boxboard, solid board, greyboard or foam board"
    )
    caliper: float = Field(description="Thickness of the board (mm)")
    grain: float = Field(
        description="Direction of flute or grain on the sheet, from the X axis (degrees, "
        "counter-clockwise)"
    )
    crease_along: float = Field(description="Depth of a crease along flute or grain (mm)")
    crease_across: float = Field(description="Depth of a crease across flute or grain (mm)")
    groove_depth: float = Field(description="Depth of a V-groove below the top face (mm)")
    groove_pass: float = Field(
        description="Largest depth of one pass of a V-groove (mm); 0: one pass"
    )
    groove_overcut: float = Field(
        description="Largest length that the blade may cut beyond the ends of a V-groove (mm)"
    )
    groove_curve: float = Field(
        description="Largest distance between an arc and its chords in a V-groove (mm); 0: curved "
        "grooves are refused"
    )
    double_crease: float = Field(
        description="Distance between the two lines of a double crease (mm); 0: single"
    )
    bridge_width: float = Field(description="Width of a bridge that holds the part (mm); 0: none")
    bridge_spacing: float = Field(description="Largest distance between two bridges (mm)")
    deflection: list[DeflectionOut] = Field(
        description="Deflection of each cutter that was measured in this board; empty if none was"
    )
    limits: list[ToolLimitsOut] = Field(
        description="Limits for the tools of some kinds in this board; other tools have none"
    )


class MeasuredPoint(JsonBody):
    """One measured point of the contour of a test cut."""

    azimuth: float = Field(
        ge=-360.0,
        le=360.0,
        description="Direction of travel at the point, from the X axis (degrees, "
        "counter-clockwise)",
    )
    dx: float = Field(ge=-100.0, le=100.0, description="Measured minus drawn position in X (mm)")
    dy: float = Field(ge=-100.0, le=100.0, description="Measured minus drawn position in Y (mm)")


class CalibrationIn(JsonBody):
    """Points that were measured on a contour that a cutter has cut in a board."""

    machine: Name = Field(
        description="Name of the machine in the library on which the contour was cut"
    )
    tool: Name = Field(description="Name of the station that holds the cutter")
    side: Annotated[Literal["left", "right"], LISTED] = Field(
        default="left",
        description="Side of the contour on which the cutter ran, seen in the direction of "
        "travel; knifetip's programs run on the left",
    )
    points: list[MeasuredPoint] = Field(
        min_length=1, max_length=10_000, description="Measured points of the contour"
    )


class CalibrationOut(BaseModel):
    """Computed deflection of a cutter in a board, and the TOML text for the file of the board."""

    board: str = Field(description="Name of the board in the library")
    machine: str = Field(description="Name of the machine in the library")
    tool: str = Field(description="Name of the station that holds the cutter")
    x: float = Field(description="Maximum deflection in X, where the contour runs along Y (mm)")
    y: float = Field(description="Maximum deflection in Y, where the contour runs along X (mm)")
    residual: float = Field(
        description="Largest difference between a measured point and the fitted deflection (mm)"
    )
    toml: str = Field(
        description="Text lines with the deflection, to be added to the TOML file of the board"
    )
