"""Models for parts of a program: ranges of its lines, and sections across the edges it makes."""

from __future__ import annotations

from typing import Annotated, Literal

from pydantic import BaseModel, ConfigDict, Field

from knifetip.fields import LISTED
from knifetip.service.http.models import Parameters

_LINES = 2**31 - 1


class ProgramLines(Parameters):
    """Query parameters that select some lines of a program."""

    first_line: int = Field(
        default=1, ge=1, le=_LINES, description="Number of the first line of `lines`, from 1"
    )
    lines: Annotated[int, Field(ge=1, le=10_000)] | None = Field(
        default=None, description="Number of lines; the whole program if it is missing"
    )


class CrossSectionOut(BaseModel):
    """What a tool makes of the section across its line (mm and degrees); null: it has no such."""

    model_config = ConfigDict(from_attributes=True)

    top_width: float | None = Field(description="Width of the opening in the top face (mm)")
    flank_angle: float | None = Field(
        description="Angle of each flank of a groove from the vertical (degrees)"
    )
    fold_angle: float | None = Field(
        description="Angle by which the board folds until the flanks of the groove meet (degrees)"
    )
    rim_width: float | None = Field(description="Width of the rim of a wheel (mm)")
    wheel_radius: float | None = Field(description="Radius of a wheel (mm)")
    contact_length: float | None = Field(
        description="Length along the line on which a wheel touches the board (mm)"
    )
    blade_width: float | None = Field(description="Width of a knife along the line (mm)")
    blade_angle: float | None = Field(
        description="Slant of the leading edge of a knife from the vertical (degrees)"
    )
    blade_lead: float | None = Field(
        description="Distance by which the cut of a slanted knife in the top face is ahead of its "
        "tip (mm)"
    )


class ToolSectionOut(BaseModel):
    """What the tool of one station makes of the board across an edge."""

    model_config = ConfigDict(from_attributes=True)

    station: int = Field(description="Number of the station")
    name: str = Field(description="Name of the station")
    kind: str = Field(description="Kind of the tool, such as knife or crease-wheel")
    shape: Annotated[Literal["line", "disc", "groove", "wheel"], LISTED] = Field(
        description="Shape of the mark of the tool, as in the footprint of a tool"
    )
    depth: float = Field(
        description="Depth of the deepest pass below the top face, at most the caliper (mm)"
    )
    beyond: float = Field(description="Distance of the tip below the bottom face (mm)")
    base: float = Field(
        description="Thickness of the board below a crease or a groove, as it remains (mm)"
    )
    passes: int = Field(description="Number of passes of different depth")
    cross: CrossSectionOut = Field(description="Measures of the section")


class EdgeSectionOut(BaseModel):
    """The section of the board across an edge of a drawing, as a program makes it."""

    model_config = ConfigDict(from_attributes=True)

    edge: int = Field(description="Row of the edge in the drawing, counted from 0")
    made_as: int = Field(
        description="Edge in whose name the program makes it: the edge itself, or another one with "
        "which it is made; -1 if the program does not make it"
    )
    caliper: float = Field(description="Thickness of the board (mm)")
    required_fold: float = Field(
        description="Angle by which the board must fold at a V-groove (degrees)"
    )
    tools: list[ToolSectionOut] = Field(
        description="The tools that work on the edge, in the order of the work; empty for none"
    )
    figures: dict[str, float] = Field(
        description="Measurements of the verifier for the edge (mm), by the names of the columns "
        "`edge_…` of the verdict"
    )
