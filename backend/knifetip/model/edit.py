"""Records of edits: changes of the geometry of a drawing that a user makes after it was read."""

from __future__ import annotations

from typing import Annotated, Final, Literal, TypeAlias

from pydantic import Field, TypeAdapter

from knifetip.fields import LISTED, Table
from knifetip.model.edge_choice import EdgeRow, MadeType

#: Most edits of one drawing.
MOST_EDITS: Final = 500

_Coordinate = Annotated[float, Field(ge=-100_000.0, le=100_000.0)]
_Point = Annotated[tuple[_Coordinate, _Coordinate], Field(strict=False)]  # JSON has lists
_Type = Annotated[MadeType, LISTED]


class MovedEnd(Table):
    """One end of an edge is moved; an arc keeps its angle."""

    kind: Literal["move-end"] = Field(description="An end of an edge is moved")
    edge: EdgeRow = Field(description="Row of the edge in the drawing, counted from 0")
    end: Annotated[Literal["start", "end"], LISTED] = Field(description="Which end is moved")
    before: _Point = Field(
        description="Where the end was: x, y (mm). The edit is refused if it is elsewhere"
    )
    to: _Point = Field(description="New position of the end: x, y (mm)")


class AddedLine(Table):
    """A line or an arc is added, as the last row of the drawing."""

    kind: Literal["line"] = Field(description="A line or an arc is added")
    start: _Point = Field(description="Start: x, y (mm)")
    end: _Point = Field(description="End: x, y (mm)")
    bulge: Annotated[float, Field(ge=-1.0, le=1.0)] = Field(
        default=0.0, description="tan(sweep / 4) of an arc, positive if counter-clockwise; 0: line"
    )
    type: _Type = Field(description="Line type of the new edge")


class AddedCircle(Table):
    """A circle is added, as two semicircles in the last rows of the drawing."""

    kind: Literal["circle"] = Field(description="A circle is added")
    centre: _Point = Field(description="Centre: x, y (mm)")
    radius: Annotated[float, Field(ge=0.05, le=10_000.0)] = Field(description="Radius (mm)")
    type: _Type = Field(description="Line type of the circle")


Edit: TypeAlias = Annotated[MovedEnd | AddedLine | AddedCircle, Field(discriminator="kind")]
Edits: TypeAlias = tuple[Edit, ...]

_EDITS: Final[TypeAdapter[Edits]] = TypeAdapter(
    Annotated[Edits, Field(strict=False, max_length=MOST_EDITS)]
)


def edits_from_json(stored: list[dict[str, object]]) -> Edits:
    """Return the edits that ``edits_json`` returned as JSON data."""
    return _EDITS.validate_python(stored)


def edits_json(edits: Edits) -> list[dict[str, object]]:
    """Return edits as JSON data."""
    return [edit.model_dump(mode="json") for edit in edits]
