"""Record of a sheet that was cut to size before the job: its outline is known."""

from __future__ import annotations

from typing import Annotated

from pydantic import Field, model_validator

from knifetip.fields import Table, field_error

SheetSize = Annotated[float, Field(gt=0.0, le=10_000.0)]


class Sheet(Table):
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

    margin_below: float | None = Field(
        default=None,
        ge=0.0,
        le=10_000.0,
        description="Distance of the drawing from the lower edge of the sheet (mm), if it differs "
        "from `margin`; otherwise null",
    )

    @model_validator(mode="after")
    def _whole(self) -> Sheet:
        if (self.width is None) != (self.height is None) or (
            self.width is None and (self.margin or self.margin_below)
        ):
            raise field_error("field.sheet-size")
        return self

    @property
    def margins(self) -> tuple[float, float]:
        """Distance of the drawing from the left and from the lower edge of the sheet (mm)."""
        return self.margin, self.margin if self.margin_below is None else self.margin_below

    def corner(self, origin: tuple[float, float]) -> tuple[float, float]:
        """Return where the lower left corner of the sheet lies on a table (mm).

        The drawing begins at the machine's origin if the table has room for the margins there;
        otherwise the sheet begins at the edge of the table.

        Parameters
        ----------
        origin : mm
            Origin of the machine, see ``Machine.origin``.
        """
        (x, y), (left, below) = origin, self.margins
        return max(x - left, 0.0), max(y - below, 0.0)

    @property
    def size(self) -> tuple[float, float] | None:
        """Width and height (mm); None if the sheet was cut to the outline of the drawing."""
        return None if self.width is None or self.height is None else (self.width, self.height)

    @property
    def note(self) -> str:
        """The sheet as a comment for the head of a program."""
        if self.size is None:
            return "sheet cut to the outline of the drawing"
        text = f"sheet {self.size[0]:g} x {self.size[1]:g} margin {self.margin:g}"
        left, below = self.margins
        return text if left == below else f"{text} and {below:g}"
