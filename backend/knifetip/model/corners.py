"""Corners: the path of a cutter round convex corners, and what happens where it does not fit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

#: The types of transition; a code in a column is an index into this.
TYPES: Final = ("B", "C", "D", "auto")
#: In a column of codes: the corner has the type of its operation.
AS_OTHERS: Final = 255
#: What happens where a cutter does not fit: the place stays uncut, or the job is refused.
INTERFERENCES: Final = ("trim", "refuse")


@dataclass(frozen=True, slots=True)
class CornerAt:
    """The corner type of one corner, which is identified by its position in the drawing."""

    x: float  #: mm
    y: float  #: mm
    type: str  #: one of ``TYPES``
    k: float | None = None  #: parameter of type D; None for that of the operation


@dataclass(frozen=True, slots=True)
class Corners:
    """Corner types of a job on a router or a beam."""

    type: str = "auto"  #: one of ``TYPES``
    k: float = 0.5  #: parameter of type D, from 0 (like B) to 1 (like C)
    interference: str = "trim"  #: one of ``INTERFERENCES``
    at: tuple[CornerAt, ...] = ()  #: corners with a type of their own
    placement: tuple[float, float] = (0.0, 0.0)  #: offset of the drawing on the sheet (mm)

    def as_json(self) -> dict[str, Any]:
        """Return the choices as plain data, in the drawing's coordinates."""
        plain = asdict(self)
        del plain["placement"]
        return plain

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> Corners:
        """Return the choices from plain data, as stored with a job."""
        return cls(
            plain["type"],
            plain["k"],
            plain["interference"],
            tuple(CornerAt(one["x"], one["y"], one["type"], one["k"]) for one in plain["at"]),
        )
