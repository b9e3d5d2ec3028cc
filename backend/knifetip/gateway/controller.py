"""controller: what every controller can do, and what it says of itself.

A program's lines go in; acknowledgements, states and positions come out.  A controller language
that can be streamed has a ``Driver``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass
from enum import StrEnum
from typing import Protocol

from knifetip.errors import ControllerError
from knifetip.gateway.motion import Pose
from knifetip.model.machine import Machine


class State(StrEnum):
    """What the controller is doing."""

    IDLE = "idle"
    RUN = "run"
    HOLD = "hold"
    JOG = "jog"
    HOME = "home"
    CHECK = "check"
    DOOR = "door"
    ALARM = "alarm"
    BUSY = "busy"  #: something that has no name here


@dataclass(frozen=True, slots=True)
class Status:
    """What the controller reported, and how many lines it had answered by then."""

    state: State
    position: Pose  #: in the numbers of the program (work coordinates)
    acknowledged: int  #: lines of programs answered since the controller was opened
    still: bool  #: no axis moves
    number: int = 0  #: N word of the line that is executed, 0 where it is not reported
    free: int | None = None  #: blocks free in the planner, where it is reported
    feed: float = 0.0  #: mm/min
    sent: int = 0  #: lines of programs sent since the controller was opened
    located: bool = True  #: the work offset is known, so that the position can be relied on


@dataclass(frozen=True, slots=True)
class SafeState:
    """The state in which a machine harms nothing: tool raised, spindle off, stations raised."""

    outputs: tuple[int, ...]  #: digital outputs that must be off
    lift: float  #: least Z (program coordinates, mm)
    #: the controller itself must switch a beam off at every hold and for every rapid
    beam: bool = False

    @classmethod
    def of(cls, machine: Machine) -> SafeState:
        """Return the safe state of a machine: all its outputs off, Z at travel height."""
        lift = min(machine.travel_z, machine.z.high)
        return cls(machine.outputs, lift, machine.has_beam)


class Observer(Protocol):
    """Compares every status report with what the machine should do."""

    @property
    def doubtful(self) -> bool:
        """Whether the last report contradicts the program: another one is wanted at once."""
        ...

    def observe(self, status: Status) -> ControllerError | None:
        """Take in a report; an error that is returned becomes the controller's fault."""
        ...


class Controller(Protocol):
    """One machine's controller.

    The first failure (alarm, reset, silence, lost connection, refused line) makes every later
    call raise it again, until ``stop`` or ``open`` has brought the machine into its safe state.
    """

    observer: Observer | None

    @property
    def name(self) -> str:
        """Where it is, in words for the operator."""
        ...

    @property
    def fault(self) -> ControllerError | None:
        """The failure that stands in the way."""
        ...

    @property
    def acknowledged(self) -> int:
        """Lines of programs that it has answered since it was opened."""
        ...

    @property
    def sent(self) -> int:
        """Lines of programs sent since it was opened."""
        ...

    @property
    def capacity(self) -> int | None:
        """Blocks that its planner holds, where it says so."""
        ...

    async def open(self) -> None:
        """Take it over and bring the machine into its safe state.

        Raises
        ------
        ControllerError
            It is busy, in alarm, or silent.
        """
        ...

    async def check(self, lines: Iterable[bytes]) -> None:
        """Have it read a whole program without moving; raise where it would refuse a line."""
        ...

    async def send(self, line: bytes, number: int) -> None:
        """Send one line (its number counts from 1); return when there was room for it."""
        ...

    async def drain(self) -> None:
        """Wait until every line that was sent has been answered."""
        ...

    async def settle(self) -> Status:
        """Wait until the machine is at rest and every answer is accounted for.

        Raises
        ------
        ControllerError
            Any failure, or an answer that belongs to no line.
        """
        ...

    async def status(self) -> Status:
        """Ask how it is and return the answer."""
        ...

    async def hold(self) -> None:
        """Decelerate and stand, ready to go on."""
        ...

    async def resume(self) -> None:
        """Go on after a hold."""
        ...

    async def stop(self) -> Status:
        """Discard the rest of the program and bring the machine into its safe state.

        Works after every failure and clears it; a lost connection is made anew.

        Raises
        ------
        ControllerError
            The machine could not be reached, or does not allow it.
        """
        ...

    async def close(self) -> None:
        """Give the connection up; the machine is left as it is."""
        ...


class Driver(Protocol):
    """Connects to a controller of one language."""

    async def __call__(
        self, address: str, safe: SafeState | None = None, *, stop_motion: bool = False
    ) -> Controller:
        """Connect to a controller and take it over, in its safe state.

        Parameters
        ----------
        address
            HOST:PORT.
        stop_motion
            Stop a machine that moves: its program is ours.

        Raises
        ------
        ControllerError
            No answer, or it is busy or in alarm.
        """
        ...
