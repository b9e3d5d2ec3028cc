"""controller: interface of a controller that receives program lines and sends status reports.

``Controller`` is a connected controller; ``Driver`` is a function that connects to one.  There is a
``Driver`` for each controller language whose programs a controller can execute under supervision.
A controller is either a ``LineController`` or a ``ProgramController``.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, field
from enum import StrEnum
from typing import Protocol, runtime_checkable

from knifetip.errors import CheckRefused, ControllerError
from knifetip.gateway.interpreter import LineInterpreter
from knifetip.gateway.motion import Pose
from knifetip.gateway.travel import Excess, Travel
from knifetip.messages import Message
from knifetip.model.machine import Machine


class State(StrEnum):
    """State of a controller, as a status report names it."""

    IDLE = "idle"
    RUN = "run"
    HOLD = "hold"
    JOG = "jog"
    HOME = "home"
    CHECK = "check"
    DOOR = "door"
    ALARM = "alarm"
    SLEEP = "sleep"
    TOOL = "tool"  #: it waits until a person has changed a tool
    BUSY = "busy"  #: any other state


@dataclass(frozen=True, slots=True)
class Status:
    """A status report of a controller, with the numbers of lines sent and answered before it."""

    state: State
    position: Pose  #: in work coordinates, as in the program
    acknowledged: int  #: lines of programs answered since the controller was opened
    still: bool  #: no axis moves
    number: int = 0  #: N word of the line being executed, 0 if not reported
    free: int | None = None  #: free blocks of the planner, None if not reported
    #: lines of programs that the machine may have begun since the controller was opened
    sent: int = 0
    located: bool = True  #: the work offset is known, so the position is reliable
    #: the program is handed over, and a person must confirm that it is executed
    awaits_end: bool = False
    pressed: str = ""  #: letters of the axes whose limit switches are pressed
    hard_limits: bool = True  #: a pressed limit switch stops the machine
    door_open: bool = False  #: the safety door is open, so the machine cannot resume
    override: int = 100  #: feed override (%)


@dataclass(frozen=True, slots=True)
class SafeState:
    """The safe state of a machine: tool raised, spindle off, all outputs off.

    It also contains the position at which the machine parks, and the machine itself.
    """

    outputs: tuple[int, ...]  #: digital outputs that must be off
    lift: float  #: least Z (program coordinates, mm)
    #: whether the controller itself must switch a beam off at every hold and every rapid move
    beam: bool = False
    park: tuple[float, float] = (0.0, 0.0)  #: X and Y at which the head is out of the way (mm)
    #: with which the settings of the controller are compared (``presupposed``); None: they are not
    machine: Machine | None = field(default=None, compare=False)

    @property
    def heading_letter(self) -> str:
        """Letter of the axis that rotates the tool, in programs."""
        return self.machine.heading_letter if self.machine else "C"

    @classmethod
    def from_machine(cls, machine: Machine) -> SafeState:
        """Return the safe state of a machine: all its outputs off, Z at travel height.

        If the travel height is above the upper limit of Z, the upper limit is used.  The machine
        parks at the position of X that is nearest to 0, with its carriage parked.
        """
        lift = min(machine.travel_z, machine.z.high)
        park = (min(max(0.0, machine.x.low), machine.x.high), machine.carriages[0].park)
        return cls(machine.outputs, lift, machine.has_beam, park, machine)


class Observer(Protocol):
    """Interface of an object that checks each status report of a controller against the program."""

    @property
    def doubtful(self) -> bool:
        """Whether the last status report deviates from the program.

        A single report may be damaged, so it does not stop the machine.  The connection requests a
        new report at once.
        """
        ...

    def observe(self, status: Status) -> ControllerError | None:
        """Return an error if a status report shows that the machine must stop, else None.

        The caller records the returned error as the fault of the controller.
        """
        ...


class Controller(Protocol):
    """Interface of a connected controller of one machine.

    These are the methods that all controllers have.  How a program gets to the machine is defined
    by ``LineController`` and ``ProgramController``.

    The first failure (alarm, reset, silence, lost connection or refused line) is kept in ``fault``.
    Until ``stop`` or ``open`` has brought the machine into its safe state, all methods that use the
    machine raise this failure, except ``stop`` and ``open``.
    """

    observer: Observer | None
    #: Largest distance (mm) of a reported position from the path of a program that is executed as
    #: it was sent.
    accuracy: float
    #: Most moves that have left the planner, as a report counts it, and are not executed yet.
    ahead: int

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        ...

    @property
    def fault(self) -> ControllerError | None:
        """First failure since the machine was last in its safe state; None if there is none.

        Every method except ``stop``, ``open`` and ``close`` raises this failure.
        """
        ...

    @property
    def acknowledged(self) -> int:
        """Number of program lines that the controller has answered since ``open``."""
        ...

    @property
    def sent(self) -> int:
        """Number of program lines that were sent to the controller since ``open``."""
        ...

    @property
    def capacity(self) -> int | None:
        """Number of blocks (moves) that the planner of the controller can hold; None if unknown."""
        ...

    async def open(self) -> None:
        """Take control of the machine and bring it into its safe state.

        Raises
        ------
        ControllerError
            The controller is busy, in alarm, or silent.
        """
        ...

    async def check(self, lines: Iterable[bytes]) -> None:
        """Let the controller parse a whole program without motion.

        Raises
        ------
        ControllerError
            The controller refuses a line.
        """
        ...

    async def status(self) -> Status:
        """Request a status report and return it."""
        ...

    async def hold(self) -> None:
        """Decelerate the machine to a stop from which ``resume`` can continue."""
        ...

    async def resume(self) -> None:
        """Let the machine continue after a hold."""
        ...

    async def stop(self) -> Status:
        """Discard the rest of the program and bring the machine into its safe state.

        The tool is raised, the spindle is stopped, and all outputs are switched off.  This method
        can be called after every failure: it clears the failure, and reconnects if the connection
        is lost.

        Returns
        -------
        Status
            Status of the machine after the tool was raised.

        Raises
        ------
        ControllerError
            The controller cannot be reached, or an alarm locks the machine.
        """
        ...

    async def close(self) -> None:
        """Close the connection to the controller; nothing is sent to the machine."""
        ...


@runtime_checkable
class LineController(Controller, Protocol):
    """Interface of a ``Controller`` that receives a program line by line, such as grbl."""

    async def send(self, line: bytes, number: int) -> None:
        """Send a program line as soon as the receive buffer of the controller has room for it.

        Parameters
        ----------
        line
            Text of the program line, without newline.
        number
            Number of the program line, from 1, for error messages.
        """
        ...

    async def drain(self) -> None:
        """Wait until the controller has answered every line that was sent."""
        ...

    async def settle(self) -> Status:
        """Wait until the machine is at rest and all lines are answered; return the last status.

        Raises
        ------
        ControllerError
            The controller has failed, or has sent an answer that belongs to no line.
        """
        ...


@runtime_checkable
class ProgramController(Controller, Protocol):
    """Interface of a ``Controller`` that runs whole programs by itself, such as LinuxCNC."""

    async def run(self, text: bytes) -> Status:
        """Run a program; return the status of the machine at rest after its end.

        Raises
        ------
        ControllerError
            The controller has failed, or the machine has stopped before the end of the program.
        """
        ...


@runtime_checkable
class ConfiguredController(Protocol):
    """Interface of a ``Controller`` whose settings are compared with those of the machine file."""

    @property
    def notices(self) -> tuple[Message, ...]:
        """Harmless differences between the settings and what the programs presuppose."""
        ...

    async def verify_settings(self) -> None:
        """Read the settings again, and compare them.

        Raises
        ------
        ControllerError
            A difference is dangerous; it is recorded as the fault of the controller.
        """
        ...


@runtime_checkable
class OverridingController(Protocol):
    """Interface of a ``Controller`` that can change the feed of a running program."""

    async def override_feed(self, percent: int) -> None:
        """Set the feed override, also while a program runs; return when it is reported.

        Parameters
        ----------
        percent
            Share of the programmed feeds, 10 to 200 %.

        Raises
        ------
        ControllerError
            The controller does not report the new override.
        """
        ...


@runtime_checkable
class LimitedController(Protocol):
    """Interface of a ``Controller`` that finds moves beyond its travel only when it comes to them.

    The program is compared with the travel before it starts.
    """

    async def travel(self) -> Travel | None:
        """Return the travel, with the present offset of programs; None if it is not known.

        Raises
        ------
        ControllerError
            The controller has failed.
        """
        ...

    def beyond_travel(self, excess: Excess) -> CheckRefused:
        """Return the error about a program that leaves the travel."""
        ...


@runtime_checkable
class InterpretingController(Protocol):
    """Interface of a ``Controller`` whose programs are not G-code."""

    def interpreter(self, start: Pose) -> LineInterpreter:
        """Return an interpreter of program lines, from the pose ``start`` on."""
        ...


class Driver(Protocol):
    """Interface of a function that connects to a controller; one for each controller language."""

    async def __call__(
        self, address: str, safe: SafeState | None = None, *, stop_motion: bool = False
    ) -> Controller:
        """Connect to a controller, bring its machine into the safe state and return the controller.

        Parameters
        ----------
        address
            Address of the controller, such as ``HOST:PORT`` or a URL.
        safe
            Safe state of the machine.  If None, the tool is not raised, and no output is switched
            off.
        stop_motion
            Whether to stop a machine that moves; True if the machine may still execute a program of
            this gateway.  If False, a machine that moves is left as it is, and an error is raised.

        Raises
        ------
        ControllerError
            The controller does not answer; or an alarm locks it, and the driver has no
            operations (``operations.Operable``) with which a person could clear the alarm.
        """
        ...
