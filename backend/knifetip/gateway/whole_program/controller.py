"""controller: base class of the drivers of controllers that run whole programs."""

from __future__ import annotations

import asyncio
from abc import abstractmethod
from typing import Any, TypeVar

from knifetip.errors import ControllerAlarm, ControllerError, ControllerOccupied
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.supervised import SupervisedController
from knifetip.gateway.takeover import Found
from knifetip.gateway.whole_program.connection import ProgramConnection
from knifetip.gateway.whole_program.recovery import make_safe, wait_for_rest
from knifetip.messages import Message

#: Time between two reports after one that deviates from the program (s).
_DOUBTFUL = 0.01

ConnectionT = TypeVar("ConnectionT", bound=ProgramConnection[Any])


class WholeProgramController(SupervisedController[ConnectionT]):
    """A controller that runs whole programs and reports the line that it executes.

    A driver adds ``check`` and ``run`` (``ProgramController``), and the commands of ``Operable``.

    Parameters
    ----------
    connection
        Connection to the controller; not open yet.
    safe
        Safe state into which ``open`` and ``stop`` bring the machine.  If None, they only end the
        running program.
    poll
        Time between two reports while a program runs (s).
    """

    #: Moves that may be executed at the same time: the controller reports the line it executes.
    capacity: int | None = 1
    ahead: int = 0

    def __init__(self, connection: ConnectionT, safe: SafeState | None, poll: float) -> None:
        super().__init__(connection, safe)
        self._poll = poll
        self._program_name = ""
        self._found: Found | None = None

    @property
    def acknowledged(self) -> int:
        """Number of program lines that the controller has begun since ``open``."""
        return 0 if self._connection.status is None else self._connection.status.acknowledged

    @property
    def program_name(self) -> str:
        """Name of the program that this connection runs; "" if none."""
        return self._program_name

    @property
    def found(self) -> Found | None:
        """What the machine was doing when the connection was opened to stop it; None if unknown."""
        return self._found

    @property
    def alarm(self) -> Message | None:
        """Error that prevents motion, with a hint; None if the controller can move the machine."""
        return self._connection.alarm

    # -- opening and closing ----------------------------------------------------------------------

    async def open(self, *, stop_motion: bool = False) -> None:
        """Take control of the machine and bring it into its safe state.

        Parameters
        ----------
        stop_motion
            Whether to stop a machine that executes a program, because it is one of this gateway.
            If False, such a machine is left as it is, and an error is raised.

        Raises
        ------
        ControllerAlarm
            An alarm locks the machine; nothing has moved.
        ControllerError
            The controller is busy or does not answer, or refuses a step.
        """
        connection = self._connection
        await connection.open()
        await self.verify_settings()
        status = await self._first_report()
        if stop_motion:
            self._found = await self._find_program(status)
        connection.raise_fault()
        if status.state is State.IDLE and status.still:
            await self._secure()
            self._forget_switches()
        elif stop_motion:
            await self.stop()
        else:
            raise ControllerOccupied("controller.busy", name=self.name, state=status.state.value)

    async def close(self) -> None:
        """Close the connection; nothing is sent to the machine."""
        await self._connection.close()
        self._connection.fail(ControllerError("controller.closed", name=self.name))

    @abstractmethod
    async def _find_program(self, status: Status) -> Found | None:
        """Return what the controller shows of the program of an earlier connection.

        A program that is executed is held first, so that its line does not change any more.
        """

    async def _first_report(self) -> Status:
        """Return the first report that shows whether the machine is at rest."""
        return await self._connection.report()

    # -- status and safe state --------------------------------------------------------------------

    async def status(self) -> Status:
        """Request a status report and return it.

        Raises
        ------
        ControllerError
            The fault of the controller, if it has failed before or now.
        """
        self._connection.raise_fault()
        status = await self._connection.report()
        self._connection.raise_fault()
        return status

    async def _pause(self) -> None:
        """Wait until the next report of a running program is due."""
        doubtful = self.observer is not None and self.observer.doubtful
        await asyncio.sleep(_DOUBTFUL if doubtful else self._poll)

    async def release(self) -> None:
        """Discard what the controller executes or holds, and switch all outputs off.

        No axis is moved.
        """
        connection = self._connection
        await connection.reach()
        connection.recovering = True
        try:
            await connection.abort()
            connection.program = None
            await wait_for_rest(connection)
            connection.executed = connection.sent
            if connection.alarm is None:
                await self._release_outputs()
        finally:
            connection.recovering = False
        self._forget_switches()

    @abstractmethod
    async def _release_outputs(self) -> None:
        """Stop the spindle and switch all outputs off, with the machine at rest."""

    async def _make_safe(self) -> Status:
        return await make_safe(self._connection, self._secure)

    @abstractmethod
    async def _secure(self) -> Status:
        """Raise Z and switch everything off, with the machine at rest; return a status."""


ControllerT = TypeVar("ControllerT", bound=WholeProgramController[Any])


async def take_control(controller: ControllerT, *, stop_motion: bool) -> ControllerT:
    """Open a controller and return it; close it if that fails.

    A controller that an alarm locks, or that executes or holds something, is returned with this as
    its ``fault``: a person at the machine can then call ``unlock``, ``home`` or ``release``.

    Parameters
    ----------
    controller
        The controller; not open yet.
    stop_motion
        As for ``WholeProgramController.open``.

    Raises
    ------
    ControllerError
        The controller does not answer.
    """
    try:
        await controller.open(stop_motion=stop_motion)
    except (ControllerAlarm, ControllerOccupied) as locked:
        controller.lock(locked)
    except BaseException:
        await controller.close()
        raise
    return controller
