"""base: the interface of all tools, and the records that it returns."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import TYPE_CHECKING, Annotated, ClassVar, Literal, TypeAlias

from annotated_types import Ge, Gt

from knifetip.messages import Message

#: Limits of dimensions; the library checks them when it reads a machine's file.
Positive: TypeAlias = Annotated[float, Gt(0)]
NotNegative: TypeAlias = Annotated[float, Ge(0)]


class Reversal(IntEnum):
    """From which of its ends a track may be worked."""

    ONE = 0  #: only from its start
    EITHER = 1  #: from either end, with the same poses in reverse order
    SIDES = 2  #: from either end, with other poses


class Switching(StrEnum):
    """When the spindle word (M3) of a tool is in force."""

    STATION = "station"  #: from the change to its station until the next change
    CUT = "cut"  #: only while it cuts: off for every rapid


@dataclass(frozen=True, slots=True)
class TipCircle:
    """Circle about the tool's own axis that contains every point of its tip."""

    radius: float  #: mm
    aside: float  #: distance of its centre to the left of the head's axis (mm)
    tilt: float  #: b, angle of the tool's axis from the vertical, to the right of travel (degrees)


@dataclass(frozen=True, slots=True)
class Footprint:
    """Shape of a tool's mark on the board, and position of its tip, for the page to draw.

    ``line``: no wider than its line.  ``disc``: ``radius`` about its tip.  ``groove``: sideways by
    ``slope`` per mm of depth, along ``blade``.  ``wheel``: a rim ``width`` wide on ``radius``.
    """

    shape: Literal["line", "disc", "groove", "wheel"] = "line"
    radius: float = 0.0  #: mm
    width: float = 0.0  #: mm
    slope: float = 0.0  #: mm per mm of depth
    blade: float = 0.0  #: length of the blade's edge, from the tip forward along C (mm)
    left: float = 0.0  #: from the head's axis to the tip, to the left of C (mm)
    behind: float = 0.0  #: from the head's axis to the tip, backwards along C (mm)
    any_height: bool = False  #: a beam: it cuts wherever its focus is


class Tool(ABC):
    """A tool: its dimensions, and the behaviour on which the stages depend.

    Subclasses are frozen dataclasses of dimensions.  A kind is registered as one row of
    ``knifetip.model.tool.KINDS``.
    """

    __slots__: tuple[str, ...] = ()

    #: Period of the tool's symmetry about C (degrees).
    period: ClassVar[float] = 360.0
    #: Whether it deflects under load, by the values in the board's file.
    yields: ClassVar[bool] = False

    # Declared for the type checker only: a dataclass would take a property for a field's default.
    if TYPE_CHECKING:

        @property
        def feed(self) -> float:
            """Feed while it works (mm/min)."""

        @property
        def plunge(self) -> float:
            """Feed down into the board and up out of it (mm/min)."""

    @abstractmethod
    def tip_circle(self, depth: float) -> TipCircle:
        """Return the tip circle while the tip is ``depth`` below the board's face (mm)."""

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """From which ends tracks may be worked, and the difference of C there (degrees)."""
        return Reversal.ONE, 0.0

    @property
    def spindle(self) -> int:
        """S word while its spindle, oscillation or beam is on; 0 if it has none."""
        return 0

    @property
    def fault(self) -> str:
        """Why its dimensions are inconsistent, or ""."""
        return ""

    @property
    def spindle_missing(self) -> Message | None:
        """Why it cannot work: it needs a spindle word and its dimensions give none; or None."""
        return None

    @property
    def outputs(self) -> tuple[int, ...]:
        """Digital outputs, besides its station's, that are on while it is in use."""
        return ()

    @property
    def pierce_time(self) -> float:
        """Dwell at the start of a cut (s)."""
        return 0.0

    @property
    def diameter(self) -> float:
        """Diameter for the controller's tool table (mm); 0 where there is none."""
        return 0.0

    @property
    def footprint(self) -> Footprint:
        """Shape of the tool's mark, for the page."""
        return Footprint()

    @property
    def dimensions(self) -> dict[str, float | bool]:
        """The fields of the record, as the machine's file gives them."""
        return {str(name): getattr(self, name) for name in self.__slots__}

    @property
    def derived(self) -> dict[str, float]:
        """Dimensions that follow from the others."""
        return {}

    def settle(self, usual: float) -> float:
        """Return the dwell after it is switched on (s); ``usual`` is the machine's."""
        return usual

    def clearance(self, usual: float) -> float:
        """Return the tip's height above the board between cuts (mm); ``usual`` is the machine's."""
        return usual

    @classmethod
    def best_for(cls, held: Sequence[Tool], caliper: float) -> int:
        """Return the index of the tool of this kind that suits a board; ``caliper`` in mm."""
        del held, caliper  # all are equally good
        return 0
