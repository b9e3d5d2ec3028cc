"""Corners: how a cutter goes round convex corners, and what it does where it does not fit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass
from typing import Any, Final

#: The types of transition; a code in a column is an index into this.
TYPES: Final = ("B", "C", "D", "auto")
#: In a column of codes: the corner is as all others of its operation.
AS_OTHERS: Final = 255
#: What a cutter does where it does not fit: leave that uncut, or refuse the job.
INTERFERENCES: Final = ("trim", "refuse")


@dataclass(frozen=True, slots=True)
class CornerAt:
    """The choice for one corner, named by its place in the drawing."""

    x: float  #: mm
    y: float  #: mm
    type: str  #: one of ``TYPES``
    k: float | None = None  #: knob of the D type; None for that of the others


@dataclass(frozen=True, slots=True)
class Corners:
    """How a router, or a beam with its kerf, makes the corners of a job."""

    type: str = "auto"  #: one of ``TYPES``
    k: float = 0.5  #: knob of the D type, between 0 (as B) and 1 (as C)
    interference: str = "trim"  #: one of ``INTERFERENCES``
    at: tuple[CornerAt, ...] = ()  #: corners that are made otherwise
    placement: tuple[float, float] = (0.0, 0.0)  #: added to the drawing's mm on the sheet

    def as_json(self) -> dict[str, Any]:
        """Return the choices as plain data, in the drawing's coordinates."""
        plain = asdict(self)
        del plain["placement"]
        return plain

    @classmethod
    def from_json(cls, plain: Mapping[str, Any]) -> Corners:
        """Return the choices in plain data, as an order has them."""
        return cls(
            plain["type"],
            plain["k"],
            plain["interference"],
            tuple(CornerAt(one["x"], one["y"], one["type"], one["k"]) for one in plain["at"]),
        )
