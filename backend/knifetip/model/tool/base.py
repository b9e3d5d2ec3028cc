"""The base class of all tools, and the records that its methods return."""

from __future__ import annotations

from abc import ABC, abstractmethod
from collections.abc import Sequence
from dataclasses import dataclass
from enum import IntEnum, StrEnum
from typing import TYPE_CHECKING, Annotated, ClassVar, Final, Literal, TypeAlias

import numpy as np
from annotated_types import Ge, Gt

from knifetip.geometry.columns import F64
from knifetip.messages import Message
from knifetip.model.tool.cross_section import CrossSection

#: Types of dimensions with limits, which the library checks when it loads a machine.
Positive: TypeAlias = Annotated[float, Gt(0)]
NotNegative: TypeAlias = Annotated[float, Ge(0)]


class Reversal(IntEnum):
    """The ends of a track at which a tool may start: only the start of the track, or both ends.

    A track is a path that the tool follows without a lift.
    """

    ONE = 0  #: only at the start
    EITHER = 1  #: at both ends; the reverse direction has the same poses in reverse order
    SIDES = 2  #: at both ends; the reverse direction has other poses


class Switching(StrEnum):
    """The period during which the spindle word (M3) of a tool is active."""

    STATION = "station"  #: from the selection of the station until the next selection
    CUT = "cut"  #: only while the tool cuts; off during rapids


@dataclass(frozen=True, slots=True)
class TipCircle:
    """Circle about the axis of a tool that contains every point of the tool's tip."""

    radius: float  #: mm
    aside: float  #: distance of the centre to the left of the head's axis (mm)
    tilt: float  #: b, angle of the tool's axis from the vertical, to the right of travel (degrees)


@dataclass(frozen=True, slots=True)
class Footprint:
    """The mark that a tool leaves on the board and the position of its tip, shown on the web page.

    ``shape`` is the shape of the mark:

    ``line``
        a line without width
    ``disc``
        a disc with radius ``radius`` about the tip
    ``groove``
        one side of a groove: as long as the cutting edge (``blade``), and as wide as ``slope``
        times the depth
    ``wheel``
        the rim, of width ``width``, of a wheel with radius ``radius``
    """

    shape: Literal["line", "disc", "groove", "wheel"] = "line"
    radius: float = 0.0  #: mm
    width: float = 0.0  #: mm
    slope: float = 0.0  #: mm per mm of depth
    blade: float = 0.0  #: length of the cutting edge, from the tip forward along C (mm)
    left: float = 0.0  #: from the head's axis to the tip, to the left of C (mm)
    behind: float = 0.0  #: from the head's axis to the tip, backwards along C (mm)
    any_height: bool = False  #: whether the mark is the same at every height of the tip


#: Maximum number of passes; more indicate an error in the step of a tool.
_MAX_PASSES: Final = 200


def pass_depths(cut_depth: float, step: float) -> F64:
    """Return the depths of the k passes of a cut, (k,) mm, ascending.

    All passes have the same increment.  It is at most ``step``, but larger if more than 200 passes
    would be necessary.

    Parameters
    ----------
    cut_depth : mm
        Depth of the cut, which the last pass has.
    step : mm
        Maximum depth of one pass; 0 for one pass.
    """
    count = 1 if step == 0.0 else min(_MAX_PASSES, int(np.ceil(cut_depth / step - 1e-9)))
    return equal_passes(cut_depth, count)


def equal_passes(cut_depth: float, count: int) -> F64:
    """Return the depths of ``count`` passes of equal increment down to ``cut_depth`` (mm), (count,)
    mm, ascending.
    """
    depths: F64 = cut_depth * np.arange(1, count + 1) / count
    return depths


class Tool(ABC):
    """Base class of tools: dimensions, and the behaviour that depends on the kind of tool.

    Subclasses are frozen dataclasses of dimensions.  Each is registered by one row of
    ``knifetip.model.tool.KINDS``.
    """

    __slots__: tuple[str, ...] = ()

    #: Period of the tool's symmetry about C (degrees).
    period: ClassVar[float] = 360.0
    #: Whether the tool deflects under load; the file of the board contains the values.
    yields: ClassVar[bool] = False

    # Declared for the type checker only: a dataclass would take a property for a field's default.
    if TYPE_CHECKING:

        @property
        def feed(self) -> float:
            """Feed while the tool cuts or creases (mm/min)."""

        @property
        def plunge(self) -> float:
            """Feed of the tool down into the board and up out of the board (mm/min)."""

    @abstractmethod
    def tip_circle(self, depth: float) -> TipCircle:
        """Return the circle about the tool's axis that contains every point of the tip.

        Parameters
        ----------
        depth
            Depth of the tip below the top face of the board (mm).
        """

    @property
    def reach(self) -> float:
        """Radius about the head's axis within which the tool lies at any heading (mm)."""
        circle = self.tip_circle(0.0)
        return circle.radius + abs(circle.aside)

    @property
    def reversal(self) -> tuple[Reversal, float]:
        """The ends of a track at which the tool may start, and an angle (degrees).

        A track is a path that the tool follows without a lift.  The angle is the rotation that is
        added to the C axis if the tool starts at the end of the track and moves in the reverse
        direction.
        """
        return Reversal.ONE, 0.0

    @property
    def spindle(self) -> int:
        """S word of the program while the tool is on; 0 if the tool needs none.

        The tool is on while its spindle, its oscillation or its laser is on.
        """
        return 0

    @property
    def fault(self) -> Message | None:
        """Error message if the dimensions are inconsistent, else None."""
        return None

    @property
    def drags(self) -> bool:
        """Whether only travel in the board turns the tool, and no axis of the machine."""
        return False

    @property
    def needs_heading(self) -> bool:
        """Whether an axis of the machine must turn the tool."""
        return True

    @property
    def spindle_missing(self) -> Message | None:
        """Error message if the program cannot switch the tool on because the tool's S word is 0.

        None if the S word is greater than 0, or if the tool needs no S word.
        """
        return None

    @property
    def outputs(self) -> tuple[int, ...]:
        """Numbers of the digital outputs that belong to the tool and are on while it is in use."""
        return ()

    @property
    def pierce_time(self) -> float:
        """Dwell of the tool at the start of a cut (s)."""
        return 0.0

    @property
    def diameter(self) -> float:
        """Diameter in the tool table of the controller (mm); 0 for tools without a diameter."""
        return 0.0

    @property
    def footprint(self) -> Footprint:
        """The mark that the tool leaves on the board, shown on the web page."""
        return Footprint()

    def cross_section(self, depth: float) -> CrossSection:
        """Return what the tool makes of the section of the board across its line.

        Parameters
        ----------
        depth
            Depth of the tip below the top face of the board, at most the caliper (mm).
        """
        del depth  # a tool without width leaves nothing that depends on it
        return CrossSection()

    @property
    def dimensions(self) -> dict[str, float | bool]:
        """Values of the fields of the tool by name, as in the TOML file of a machine."""
        return {str(name): getattr(self, name) for name in self.__slots__}

    @property
    def derived(self) -> dict[str, float]:
        """Dimensions that are calculated from the fields of the tool, by name."""
        return {}

    def settle(self, machine_dwell: float) -> float:
        """Return the dwell after the tool is switched on (s).

        Parameters
        ----------
        machine_dwell
            Dwell in the file of the machine (s).  The base class returns it unchanged.
        """
        return machine_dwell

    def clearance(self, machine_height: float) -> float:
        """Return the height of the tip above the board between cuts (mm).

        Parameters
        ----------
        machine_height
            Height in the file of the machine (mm).  The base class returns it unchanged.
        """
        return machine_height

    @classmethod
    def best_for(cls, tools: Sequence[Tool], caliper: float) -> int:
        """Return the index of the tool in ``tools`` that is best for a board of a given thickness.

        ``caliper`` is the thickness of the board (mm).
        """
        del tools, caliper  # all are equally good
        return 0
