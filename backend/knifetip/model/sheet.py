"""Record of a sheet that was cut to size before the job: its outline is known."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any


@dataclass(frozen=True, slots=True)
class Sheet:
    """A sheet that was cut to size before the job, so that no board lies outside its outline.

    The sheet is a rectangle if ``width`` and ``height`` are greater than 0.  If both are 0, it was
    cut to the outline of the drawing: to the outer contours of the cuts.
    """

    width: float = 0.0  #: along X (mm)
    height: float = 0.0  #: along Y (mm)
    #: distance of the drawing from the left and from the lower edge of a rectangle (mm)
    margin: float = 0.0

    @property
    def is_rectangle(self) -> bool:
        """Whether the sheet is a rectangle, and not cut to the outline of the drawing."""
        return self.width > 0.0

    @property
    def note(self) -> str:
        """The sheet as a comment for the head of a program."""
        if not self.is_rectangle:
            return "sheet cut to the outline of the drawing"
        return f"sheet {self.width:g} x {self.height:g} margin {self.margin:g}"

    def as_json(self) -> dict[str, Any]:
        """Return the sheet as JSON data; the size is null if the sheet is no rectangle."""
        return {
            "width": self.width or None,
            "height": self.height or None,
            "margin": self.margin,
        }

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> Sheet:
        """Return the sheet from JSON data that ``as_json`` made."""
        return cls(plain["width"] or 0.0, plain["height"] or 0.0, plain["margin"])
