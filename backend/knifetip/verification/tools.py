"""tools: what the judge expects of each kind of tool.

    Tool -> ExpectedTool

Written from the tools' drawings and the machines' manuals, apart from what the stages do with them:
only the dimensions in the records are shared.  To add a kind, add a row to ``_EXPECTED``.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from enum import IntEnum
from typing import Any, Final

from knifetip.model.machine import Machine
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Laser, Tool, VCutter

#: Inside a pass C may turn alone by this, where a tool has no swivel angle of its own (degrees).
MAX_TURN: Final = 1.01
#: What a tool's swivel angle may be exceeded by: C is printed to 0.0001°.
ANGLE_TOLERANCE: Final = 0.01
#: Where a cutter has no lead of its own, its offset is set up on so many radii.
_ENTRY_RATIO: Final = 1.5


class OperationKind(IntEnum):
    """What a tool does at its depth."""

    CUT = 0  #: a knife through the board
    HALF_CUT = 1  #: a knife part of the way
    CREASE = 2
    GROOVE = 3
    MILL = 4  #: a cutter that removes a disc, through the board

    @property
    def tool(self) -> str:
        """The tool's name in messages, a key of ``english.TOOLS``."""
        return ("knife", "knife", "wheel", "v-cutter", "cutter")[self]


@dataclass(frozen=True, slots=True)
class Disc:
    """What a rotating cutter or a beam removes."""

    radius: float  #: mm
    step: float  #: deepest cut in one pass (mm); 0 for all at once
    set_up: float  #: the longest way from where it enters to a contour (mm)


@dataclass(frozen=True, slots=True)
class Beam:
    """What is asked of a beam, which works wherever it is on, at any height."""

    focus: float  #: height of the focus above the board's top face (mm)
    pierce: float  #: seconds that it stays where it is switched on


@dataclass(frozen=True, slots=True)
class ExpectedTool:
    """What a program may do with a tool, and what the tool then does to the board."""

    through: OperationKind
    partly: OperationKind  #: where it goes only part of the way through
    ahead: float = 0.0  #: from the head's axis to the tip, along C (mm)
    right: float = 0.0  #: and to the right of C (mm)
    slope: float = 0.0  #: sideways travel per mm of depth
    trails: bool = False  #: its head swings round the tip while C turns
    swivel: float = MAX_TURN  #: C may turn by this in the board inside a pass (degrees)
    most: float = 180.0  #: a turn in the board need never be wider (degrees)
    follows: bool = True  #: C turns as the path does
    speed: float = 1.0  #: S word of M3
    turns: bool = False  #: M3 must be in force while it works; otherwise it must not
    at_rest: str = ""  #: code of the message where it is not in force
    wait: float = 0.0  #: seconds after it is switched, if longer than the machine's own
    disc: Disc | None = None
    beam: Beam | None = None
    outputs: tuple[int, ...] = ()  #: that must be on while it works, besides its station's

    def through_depth(self, caliper: float, into_mat: float) -> float:
        """Return how deep below the top face its tip is where it cuts the board through (mm)."""
        return -self.beam.focus if self.beam else caliper + into_mat


def _knife(tool: Knife) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.CUT,
        OperationKind.HALF_CUT,
        ahead=-tool.trail,
        trails=tool.trail > 0.0,
        swivel=tool.swivel + ANGLE_TOLERANCE,
        turns=tool.oscillating,
        at_rest="verify.knife-at-rest",
    )


def _crease_wheel(_tool: CreaseWheel) -> ExpectedTool:
    return ExpectedTool(OperationKind.CREASE, OperationKind.CREASE, most=90.0)


def _v_cutter(tool: VCutter) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.GROOVE,
        OperationKind.GROOVE,
        ahead=-tool.half_width,
        right=-tool.back,
        slope=math.tan(math.radians(tool.tilt)),
    )


def _cutter(tool: Cutter) -> ExpectedTool:
    return ExpectedTool(
        OperationKind.MILL,
        OperationKind.MILL,
        follows=False,
        speed=tool.speed,
        turns=tool.speed > 0.0,
        at_rest="verify.cutter-at-rest",
        wait=tool.spin_up,
        disc=Disc(tool.radius, tool.step, tool.lead or _ENTRY_RATIO * tool.radius),
    )


def _laser(tool: Laser) -> ExpectedTool:
    radius = 0.5 * tool.kerf
    return ExpectedTool(
        OperationKind.MILL,
        OperationKind.MILL,
        follows=False,
        speed=tool.power,
        turns=True,
        at_rest="verify.laser-off",
        disc=Disc(radius, 0.0, tool.lead or _ENTRY_RATIO * radius),
        beam=Beam(tool.focus, tool.pierce),
        outputs=(tool.air,) if tool.air >= 0 else (),
    )


_EXPECTED: Final[Mapping[type[Tool], Callable[[Any], ExpectedTool]]] = {
    Knife: _knife,
    CreaseWheel: _crease_wheel,
    VCutter: _v_cutter,
    Cutter: _cutter,
    Laser: _laser,
}


def extra_outputs(machine: Machine) -> tuple[int, ...]:
    """Return the outputs that tools need besides their stations', ascending."""
    return tuple(
        sorted({one for held in machine.stations for one in expected_tool(held.tool).outputs})
    )


def has_beam(machine: Machine) -> bool:
    """Return whether a station holds a beam."""
    return any(expected_tool(held.tool).beam is not None for held in machine.stations)


def expected_tool(tool: Tool) -> ExpectedTool:
    """Return what the judge expects of a tool."""
    return _EXPECTED[type(tool)](tool)
