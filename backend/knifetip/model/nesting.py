"""Records of a nesting: which drawings are to be placed, how often, and on which sheets."""

from __future__ import annotations

from typing import Annotated, Final

from pydantic import Field, model_validator

from knifetip.fields import Table, field_error
from knifetip.model.layout import MOST_PLACED, LayoutSheet
from knifetip.model.sheet import SheetSize

#: Longest time of a nesting (s).
MOST_SECONDS: Final = 600.0

_Margin = Annotated[float, Field(ge=0.0, le=1000.0)]


class Margins(Table):
    """Strips along the edges of a sheet that stay free of blanks, such as for clamps."""

    left: _Margin = Field(default=0.0, description="Margin at the left edge (mm)")
    right: _Margin = Field(default=0.0, description="Margin at the right edge (mm)")
    below: _Margin = Field(default=0.0, description="Margin at the lower edge (mm)")
    above: _Margin = Field(default=0.0, description="Margin at the upper edge (mm)")


class LeftOver(Table):
    """Sheets of another size that are used up first."""

    width: SheetSize = Field(description="Size along X (mm)")
    height: SheetSize = Field(description="Size along Y (mm)")
    count: Annotated[int, Field(ge=1, le=100)] = Field(
        default=1, description="Number of sheets of this size"
    )


class NestingPart(Table):
    """A drawing that is to be placed one or more times."""

    drawing: str = Field(min_length=1, max_length=40, description="Id of the drawing")
    quantity: Annotated[int, Field(ge=1, le=MOST_PLACED)] = Field(
        default=1, description="Number of copies"
    )
    turn: Annotated[float, Field(gt=-360.0, lt=360.0)] = Field(
        default=0.0,
        description="First permitted angle of the drawing on the sheet, counter-clockwise (°)",
    )
    turn_step: Annotated[float, Field(ge=1.0, le=360.0)] | None = Field(
        default=None,
        description="Step from one permitted angle to the next (°). 180 keeps the grain, 360 "
        "permits the first angle only. Null for 180 on a sheet with a grain, and for 90 otherwise",
    )
    mirror: bool = Field(default=False, description="Whether all copies are mirrored")

    def turns(self, *, keep_grain: bool) -> tuple[float, ...]:
        """Return the permitted angles (°).

        Parameters
        ----------
        keep_grain
            Whether the default step keeps the direction of the grain.
        """
        step = self.turn_step or (180.0 if keep_grain else 90.0)
        return tuple(
            (self.turn + number * step) % 360.0 for number in range(max(1, int(360.0 / step)))
        )


class NestingJob(Table):
    """What is to be placed on which sheets, and how long a good arrangement is searched."""

    sheet: LayoutSheet = Field(description="The sheet; as many as needed are filled")
    left_overs: tuple[LeftOver, ...] = Field(
        default=(),
        strict=False,  # JSON has lists
        max_length=50,
        description="Sheets of other sizes that are used up first, smallest first; they have the "
        "grain and the side of `sheet`",
    )
    margins: Margins = Field(
        default=Margins(), description="Margins of every sheet that stay free of blanks"
    )
    gap: Annotated[float, Field(ge=0.0, le=1000.0)] = Field(
        default=0.0, description="Least distance between two blanks (mm)"
    )
    in_holes: bool = Field(
        default=True,
        description="Whether copies are placed in holes of larger ones, which are cut after them",
    )
    parts: tuple[NestingPart, ...] = Field(
        strict=False,  # JSON has lists
        min_length=1,
        max_length=200,
        description="The drawings, each with the number of its copies",
    )
    seconds: Annotated[float, Field(ge=1.0, le=MOST_SECONDS)] = Field(
        default=20.0, description="Time after which the best arrangement so far is kept (s)"
    )
    seed: Annotated[int, Field(ge=0, le=2**31 - 1)] = Field(
        default=0, description="Number from which the random choices of the search follow"
    )

    @model_validator(mode="after")
    def _not_too_many(self) -> NestingJob:
        if self.count > MOST_PLACED:
            raise field_error("field.too-many-copies", count=self.count, limit=MOST_PLACED)
        return self

    @property
    def count(self) -> int:
        """Number of copies of all drawings."""
        return sum(part.quantity for part in self.parts)
