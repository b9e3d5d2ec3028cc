"""Corner types of a job: how the path of a cutter passes around convex corners of contours."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

#: Corner types; a code in a column is an index into this tuple.
TYPES: Final = ("B", "C", "D", "auto")
#: Code in a column: the corner has the corner type of its operation.
AS_OTHERS: Final = 255
#: Reaction if a cutter does not fit: leave the area uncut, or refuse the job.
INTERFERENCES: Final = ("trim", "refuse")


@dataclass(frozen=True, slots=True)
class CornerAt:
    """The corner type of one corner, which is identified by its position in the drawing."""

    x: float  #: mm
    y: float  #: mm
    type: str  #: one of ``TYPES``
    k: float | None = None  #: parameter of type D; None: the parameter of the job


@dataclass(frozen=True, slots=True)
class Corners:
    """Corner types of a job: one for all corners, and exceptions for single corners."""

    type: str = "auto"  #: one of ``TYPES``
    k: float = 0.5  #: parameter of type D, from 0 (like B) to 1 (like C)
    interference: str = "trim"  #: one of ``INTERFERENCES``
    at: tuple[CornerAt, ...] = ()  #: corners with a type of their own
    placement: tuple[float, float] = (0.0, 0.0)  #: offset of the drawing on the sheet (mm)

    def as_json(self) -> dict[str, Any]:
        """Return the corner types as JSON data, with positions in coordinates of the drawing."""
        plain = asdict(self)
        del plain["placement"]
        return plain

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> Corners:
        """Return the corner types from JSON data that ``as_json`` made."""
        return cls(
            plain["type"],
            plain["k"],
            plain["interference"],
            tuple(CornerAt(one["x"], one["y"], one["type"], one["k"]) for one in plain["at"]),
        )
