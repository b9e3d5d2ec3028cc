"""operations: what a person at the machine can ask of it between two jobs.

``Operable`` is the interface of a controller that can be unlocked, homed and jogged.  A driver
implements it in addition to ``Controller``, as far as its controller can do it.

An ``Operation`` is one request of a person.  ``perform`` carries it out, but only if it is not too
late, if the machine is at rest, and if the operation stays within the travel of the machine.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Protocol, runtime_checkable

from knifetip.contract.operations import EXPIRY, Operation, OperationName
from knifetip.errors import ControllerError, OperationExpired
from knifetip.gateway.controller import (
    Controller,
    OverridingController,
    SafeState,
    State,
    Status,
)
from knifetip.gateway.motion import Limits
from knifetip.gateway.obstacle import RELEASABLE
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station

#: Seconds of motion in one piece of a jog, for controllers that do not stop without their gateway.
JOG_PIECE = 0.5
#: Letters of the axes of a head, in the order of a pose.
AXES = "XYZC"
#: Least distance of a piece of a jog (mm or degrees), which no controller rounds to nothing.
_SHORTEST_PIECE = 0.01
#: Z may be this much below the lift, and a target this much beyond the travel: rounding of reports.
_TOLERANCE = 1e-3


#: Operations that an alarm does not prevent.
_IN_ALARM = frozenset({OperationName.UNLOCK, OperationName.HOME})


@runtime_checkable
class Operable(Protocol):
    """Interface of a controller that can do operations of a person at the machine.

    A controller implements it in addition to ``Controller``.  A driver whose controller is locked
    by an alarm returns the controller instead of raising an error: ``fault`` is then the alarm, and
    ``unlock`` or ``home`` clears it.

    Operations are called by ``perform``, which checks the state of the machine and the travel of
    its axes first.
    """

    @property
    def operations(self) -> frozenset[str]:
        """Names of the operations that the controller can do (``OperationName``)."""
        ...

    @property
    def connected(self) -> bool:
        """Whether the connection to the controller is open."""
        ...

    @property
    def alarm(self) -> Message | None:
        """Meaning of the alarm that locks the controller, with what to do; None for no alarm."""
        ...

    @property
    def last_status(self) -> Status | None:
        """Last status report, also after a failure; None if there is none since connecting."""
        ...

    @property
    def switched_on(self) -> frozenset[int]:
        """Numbers of the digital outputs that ``switch`` has switched on."""
        ...

    @property
    def jog_seconds(self) -> float:
        """Longest motion of one jog (s); infinite if the controller stops without its gateway."""
        ...

    @property
    def spinning(self) -> int:
        """Number of the station whose spindle ``spin`` has switched on; 0 for none."""
        ...

    async def unlock(self) -> None:
        """Clear an alarm without homing, then lift the tool and switch all outputs off.

        The position of the axes may be wrong afterwards.

        Raises
        ------
        ControllerError
            The controller refuses, for example because an emergency stop button is pressed.
        """
        ...

    async def home(self) -> None:
        """Home all axes, which also clears an alarm; return when the axes are at rest.

        Raises
        ------
        ControllerError
            The controller cannot home, or did not find a switch; an alarm then locks it.
        """
        ...

    async def release(self) -> None:
        """Discard what the controller executes or holds, and switch all outputs off.

        No axis is moved, so the tool stays where it is.

        Raises
        ------
        ControllerError
            The controller does not answer.
        """
        ...

    async def jog(self, axis: str, distance: float, feed: float) -> None:
        """Begin to move one axis; return when the controller has accepted the move.

        A jog of an axis that a jog moves already continues where that one ends.

        Parameters
        ----------
        axis
            Letter of the axis: X, Y, Z or C.
        distance
            Signed distance from the present position, or from the end of the running jog (mm or
            degrees).
        feed
            Speed (mm/min or degrees/min).

        Raises
        ------
        ControllerError
            The controller refuses the move.
        """
        ...

    async def stop_jog(self) -> None:
        """Decelerate the running jog to a stop and discard the rest of it."""
        ...

    async def zero(self, axes: str) -> None:
        """Set the work coordinates of some axes to zero at the present position.

        The work coordinates are those in which programs run.

        Parameters
        ----------
        axes
            Letters of the axes, for example ``XY``.
        """
        ...

    async def park(self) -> None:
        """Lift the tool, then begin to move X and Y to the park position of the machine."""
        ...

    async def switch(self, output: int, on: bool) -> None:
        """Switch a digital output of the machine on or off.

        Parameters
        ----------
        output
            Number of the output.
        on
            Whether the output is switched on.
        """
        ...

    async def spin(self, station: Station | None) -> None:
        """Switch the spindle or the oscillation of a station on; None switches it off."""
        ...


@runtime_checkable
class OperableController(Controller, Operable, Protocol):
    """A ``Controller`` that can also do operations of a person at the machine."""


async def perform(
    operation: Operation,
    controller: OperableController,
    machine: Machine,
    is_late: Callable[[], bool],
) -> None:
    """Carry out an operation of a person at the machine.

    Of a jog, the first piece is sent (``jog_piece``).

    Parameters
    ----------
    operation
        The operation.
    controller
        Controller of the machine.
    machine
        The machine, for the travel of its axes.
    is_late
        Returns whether the operation has expired.  It is called last before anything is sent.

    Raises
    ------
    OperationExpired
        The operation has expired; nothing was sent.
    ControllerError
        The operation is not permitted now, or the controller refuses it.
    """
    await require_possible(operation, controller, machine)
    if is_late():
        raise OperationExpired("operation.expired", seconds=EXPIRY)
    match operation.name:
        case OperationName.UNLOCK:
            await controller.unlock()
        case OperationName.HOME:
            await controller.home()
        case OperationName.RELEASE:
            await controller.release()
        case OperationName.JOG:
            piece = jog_piece(operation.distance, operation.feed, controller.jog_seconds)
            await controller.jog(operation.axis, piece, operation.feed)
        case OperationName.STOP_JOG:
            await controller.stop_jog()
        case OperationName.ZERO:
            await controller.zero(operation.axes)
        case OperationName.PARK:
            await controller.park()
        case OperationName.LIFT:
            await controller.stop()
        case OperationName.SWITCH:
            await controller.switch(operation.output, operation.on)
        case OperationName.SPINDLE:
            station = _spindle_station(operation, machine)
            await controller.spin(station if operation.on else None)


async def override_feed(
    operation: Operation, controller: object, machine: Machine, is_late: Callable[[], bool]
) -> None:
    """Change the feed of the program that a machine runs.

    For the parameters see ``perform``.

    Raises
    ------
    OperationExpired
        The operation has expired; nothing was sent.
    ControllerError
        The machine file does not permit the override, or the controller has none or does not
        report the new one.
    """
    if is_late():
        raise OperationExpired("operation.expired", seconds=EXPIRY)
    low, high = machine.feed_override
    if not low <= operation.percent <= high:
        raise ControllerError(
            "operation.bad-override", percent=operation.percent, low=low, high=high
        )
    if not isinstance(controller, OverridingController):
        raise ControllerError("operation.no-controller", machine=machine.name)
    await controller.override_feed(operation.percent)


def jog_piece(distance: float, feed: float, seconds: float) -> float:
    """Return the part of a jog that a machine executes in a time.

    Parameters
    ----------
    distance
        Signed distance of the jog (mm or degrees).
    feed
        Its speed (mm/min or degrees/min).
    seconds
        The time; infinite for the whole jog.
    """
    # Rounded as it is sent, so that the sum of all pieces is the distance.
    longest = max(round(feed / 60.0 * seconds, 4), _SHORTEST_PIECE)
    return math.copysign(min(abs(distance), longest), distance)


async def require_possible(
    operation: Operation, controller: OperableController, machine: Machine
) -> None:
    """Raise ``ControllerError`` if a machine cannot execute an operation now.

    Parameters
    ----------
    operation
        The operation.
    controller
        Controller of the machine.
    machine
        The machine, for the travel of its axes.
    """
    if operation.name not in controller.operations:
        raise ControllerError("operation.unsupported", name=controller.name, request=operation.name)
    if operation.name is OperationName.UNLOCK and controller.alarm is None:
        raise ControllerError("operation.not-locked", name=controller.name)
    if operation.name is OperationName.RELEASE:
        _check_release(controller)
        return
    if operation.name is OperationName.STOP_JOG:
        return  # also during homing, when some controllers send no status report
    if controller.alarm is None or operation.name not in _IN_ALARM:
        _check(operation, controller.name, await controller.status(), machine)


def _check_release(controller: OperableController) -> None:
    """Raise ``ControllerError`` if a controller holds nothing, or its door is open."""
    status = controller.last_status
    if controller.alarm is not None or status is None or status.state not in RELEASABLE:
        raise ControllerError("operation.nothing-held", name=controller.name)
    if status.door_open:
        raise ControllerError("operation.door-open", name=controller.name)


def _check(operation: Operation, name: str, status: Status, machine: Machine) -> None:
    """Raise ``ControllerError`` if the machine cannot do an operation in its present state.

    ``name``: address of the controller, for messages.
    """
    if status.state is not State.IDLE:
        raise ControllerError("operation.not-at-rest", name=name, state=status.state.value)
    lift = SafeState.from_machine(machine).lift
    lifted = status.position[2] >= lift - _TOLERANCE
    match operation.name:
        case OperationName.JOG:
            if operation.axis != "Z" and not lifted:
                raise ControllerError("operation.not-lifted", height=lift)
            _check_jog(operation, status, machine)
        case OperationName.SWITCH:
            if not lifted:
                raise ControllerError("operation.not-lifted", height=lift)
            if operation.output not in machine.outputs:
                raise ControllerError(
                    "operation.unknown-output",
                    output=operation.output,
                    outputs=[str(output) for output in machine.outputs],
                )
        case OperationName.SPINDLE:
            if not lifted:
                raise ControllerError("operation.not-lifted", height=lift)
        case OperationName.ZERO:
            if not operation.axes or not set(operation.axes) <= set(AXES):
                raise ControllerError("operation.unknown-axis", axis=operation.axes, axes=AXES)


def _spindle_station(operation: Operation, machine: Machine) -> Station:
    """Return the station whose spindle an operation switches.

    Raises ``ControllerError``: the machine has no such station, its tool has no spindle, or it is a
    laser.
    """
    for station in machine.stations:
        if station.number == operation.station and station.speed and not station.is_beam:
            return station
    raise ControllerError("operation.no-spindle", station=operation.station, machine=machine.title)


def _check_jog(operation: Operation, status: Status, machine: Machine) -> None:
    """Raise ``ControllerError`` if a jog leaves the travel of its axis, or is too fast."""
    if len(operation.axis) != 1 or operation.axis not in AXES:
        raise ControllerError("operation.unknown-axis", axis=operation.axis, axes=AXES)
    index = AXES.index(operation.axis)
    limits = Limits.from_machine(machine)
    low, high = limits.low[index], limits.high[index]
    target = status.position[index] + operation.distance
    if not low - _TOLERANCE <= target <= high + _TOLERANCE:
        raise ControllerError(
            "operation.beyond-travel", axis=operation.axis, target=target, low=low, high=high
        )
    fastest = limits.velocity[index] * 60.0
    if not 0.0 < operation.feed <= fastest:
        raise ControllerError("operation.bad-feed", feed=operation.feed, fastest=fastest)
