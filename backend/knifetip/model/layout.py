"""Records of a layout: a sheet, and the drawings that are placed on it."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Annotated, Final, Literal

from pydantic import Field, model_validator

from knifetip.fields import LISTED, Table, field_error
from knifetip.model.sheet import SheetSize

#: Most copies of drawings on one sheet.
MOST_PLACED: Final = 2000

_Coordinate = Annotated[float, Field(ge=-10_000.0, le=10_000.0)]
_Count = Annotated[int, Field(ge=1, le=200)]
_Gap = Annotated[float, Field(ge=0.0, le=10_000.0)]


class LayoutSheet(Table):
    """The sheet of a layout.  Its lower left corner is the origin of the layout."""

    width: SheetSize = Field(description="Size along X (mm)")
    height: SheetSize = Field(description="Size along Y (mm)")
    board: str = Field(
        default="",
        max_length=80,
        description="Name of its board in the library; empty if the order alone names it",
    )
    grain: Annotated[Literal["x", "y"] | None, LISTED] = Field(
        default=None,
        description="Axis along which the fibres of the board or its flutes run; null if unknown",
    )
    side_up: Annotated[Literal["outside", "inside"], LISTED] = Field(
        default="outside",
        description="Side of the carton that lies on top. A drawing that shows the other side "
        "must be mirrored",
    )
    gap: _Gap = Field(
        default=5.0, description="Distance that the designer keeps between two blanks (mm)"
    )
    margin: _Gap = Field(
        default=10.0,
        description="Distance that the designer keeps from the edges of the sheet (mm)",
    )


class PlacedDrawing(Table):
    """A drawing on a sheet: one copy, or rows and columns of copies.

    A drawing is mirrored first, then turned, then moved.  The box of a drawing is the bounding box
    of its edges that are made, after it was turned.
    """

    drawing: str = Field(min_length=1, max_length=40, description="Id of the drawing")
    revision: int | None = Field(
        default=None,
        ge=1,
        description="Revision of the drawing; a later one is refused. Null for the present one",
    )
    x: _Coordinate = Field(description="Left side of the box of the first copy (mm)")
    y: _Coordinate = Field(description="Lower side of the box of the first copy (mm)")
    turn: Annotated[float, Field(gt=-360.0, lt=360.0)] = Field(
        default=0.0, description="Angle by which the drawing is turned, counter-clockwise (°)"
    )
    mirror: bool = Field(
        default=False, description="Whether the drawing is mirrored: left becomes right"
    )
    columns: _Count = Field(default=1, description="Number of copies along X")
    rows: _Count = Field(default=1, description="Number of copies along Y")
    gap_x: _Gap = Field(default=0.0, description="Distance between the boxes of two columns (mm)")
    gap_y: _Gap = Field(default=0.0, description="Distance between the boxes of two rows (mm)")

    @property
    def count(self) -> int:
        """Number of copies."""
        return self.columns * self.rows

    def corners(self, width: float, height: float) -> Iterator[tuple[float, float]]:
        """Yield the lower left corner of the box of each copy (mm), row by row.

        Parameters
        ----------
        width, height : mm
            Size of the box of the drawing after it was turned.
        """
        for row in range(self.rows):
            for column in range(self.columns):
                yield (
                    self.x + column * (width + self.gap_x),
                    self.y + row * (height + self.gap_y),
                )


class Layout(Table):
    """A sheet with the drawings that are placed on it."""

    sheet: LayoutSheet = Field(description="The sheet")
    placed: tuple[PlacedDrawing, ...] = Field(
        strict=False,  # JSON has lists
        min_length=1,
        max_length=MOST_PLACED,
        description="Drawings on the sheet; each may have rows and columns of copies. Copies are "
        "counted in this order, from 1",
    )

    @model_validator(mode="after")
    def _not_too_many(self) -> Layout:
        if self.count > MOST_PLACED:
            raise field_error("field.too-many-copies", count=self.count, limit=MOST_PLACED)
        return self

    @property
    def count(self) -> int:
        """Number of copies of drawings on the sheet."""
        return sum(placed.count for placed in self.placed)


@dataclass(frozen=True, slots=True)
class Position:
    """Position of one copy of a drawing on a sheet.

    The copy is the drawing after it was mirrored and turned, and then moved until the lower left
    corner of its box is at ``corner``.
    """

    corner: tuple[float, float]  #: mm
    turn: float = 0.0  #: counter-clockwise (°)
    mirror: bool = False
