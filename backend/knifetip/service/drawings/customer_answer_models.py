"""Models for what earlier drawings of a customer teach."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, Field

from knifetip.service.http.models import WHOLE, JsonBody, LineTypeWord

LayerName = Annotated[
    str,
    Field(
        max_length=500,
        description="Name of the layer in lower case; empty for all layers whose names mean "
        "nothing or only count",
    ),
]
Colour = Annotated[int, Field(ge=0, le=1000, description="AutoCAD colour index"), WHOLE]
TrueColour = Annotated[
    int, Field(ge=-1, le=0xFFFFFF, description="True colour 0xRRGGBB as a number; -1: none"), WHOLE
]
Linetype = Annotated[
    str, Field(max_length=500, description="Linetype in lower case, such as dashed")
]
LineWidth = Annotated[
    int,
    Field(
        ge=-1000, le=100_000, description="Width of the lines in 1/100 mm; -1 if it does not matter"
    ),
    WHOLE,
]


class LookOut(BaseModel):
    """A look of edges and their line type in earlier drawings of the customer."""

    layer: LayerName
    colour: Colour
    true_colour: TrueColour
    linetype: Linetype
    line_width: LineWidth
    type: LineTypeWord = Field(description="Line type of such edges in these drawings")
    drawings: list[str] = Field(description="Names of these drawings, the newest first")


class LearnedOut(LookOut):
    """A look, with the edges of a drawing that earlier drawings of the customer decided."""

    edges: list[int] = Field(description="Rows of the edges in the drawing, counted from 0")


class TaughtLookOut(LookOut):
    """A look, and whether earlier drawings of the customer may decide such edges."""

    used: bool = Field(description="False if a user has taken the answer back")


class LookPatch(JsonBody):
    """A look of edges in a request, and whether earlier drawings may decide such edges."""

    layer: LayerName
    colour: Colour
    true_colour: TrueColour
    linetype: Linetype
    line_width: LineWidth
    used: bool = Field(description="False to take back what earlier drawings of the customer teach")
