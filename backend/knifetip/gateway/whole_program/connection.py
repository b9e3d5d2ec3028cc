"""connection: the record of a controller that runs whole programs: its reports and its fault."""

from __future__ import annotations

import asyncio
from abc import ABC, abstractmethod
from contextlib import suppress
from typing import ClassVar, Generic, Protocol, TypeVar

from knifetip.errors import ControllerError
from knifetip.gateway.controller import Observer, Status
from knifetip.messages import Message

#: Time between two reports while no program runs (s); a board that waits for its gateway waits
#: longer.
WATCH = 0.5


class Channel(Protocol):
    """Interface of the channel over which a connection exchanges requests and answers."""

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        ...

    @property
    def connected(self) -> bool:
        """Whether the connection is open."""
        ...

    async def close(self) -> None:
        """Close the connection."""
        ...


ProgramT = TypeVar("ProgramT")


class ProgramConnection(ABC, Generic[ProgramT]):
    """A connection to a controller that runs whole programs.

    Parameters
    ----------
    channel
        Channel for requests and answers; not open yet.
    silence
        Time limit for the answer to a request (s).
    """

    #: Longest time until the machine is at rest after an abort or a lift (s).
    rest_seconds: ClassVar[float]

    def __init__(self, channel: Channel, silence: float) -> None:
        self.silence = silence
        self.fault: ControllerError | None = None
        self.observer: Observer | None = None
        self.recovering = False  #: reports are not compared with a program and set no fault
        self.program: ProgramT | None = None  #: the program that the controller executes
        self.executed = 0  #: lines of the programs that have ended
        self.sent = 0  #: lines of all programs that the controller may have begun to execute
        self.status: Status | None = None  #: last report
        self.alarm: Message | None = None  #: why the last report has the state ``ALARM``
        self._channel = channel
        self._watching: asyncio.Task[None] | None = None

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        return self._channel.name

    @property
    def connected(self) -> bool:
        """Whether the connection is open."""
        return self._channel.connected

    # -- opening and closing ----------------------------------------------------------------------

    @abstractmethod
    async def open(self) -> None:
        """Connect to the controller; leave the machine as it is.

        Raises
        ------
        ControllerError
            Nothing answers, or it is another controller.
        """

    @abstractmethod
    async def reach(self) -> None:
        """Clear the recorded fault; reconnect if the connection is lost.

        Raises
        ------
        ControllerError
            The controller cannot be reached.
        """

    async def close(self) -> None:
        """Close the connection; nothing is sent to the machine."""
        watching, self._watching = self._watching, None
        if watching is not None:
            watching.cancel()
            await asyncio.gather(watching, return_exceptions=True)
        await self._channel.close()

    def _start_watch(self, title: str) -> None:
        """Begin to poll the machine, unless it is polled already."""
        if self._watching is None:
            self._watching = asyncio.create_task(self._watch(), name=title)

    async def _watch(self) -> None:
        """Request a report periodically, so that failures are also detected between jobs."""
        while True:
            await asyncio.sleep(WATCH)
            if self.connected and not self.recovering:
                with suppress(ControllerError):  # ``report`` records it as the fault
                    await self.report()

    # -- requests ---------------------------------------------------------------------------------

    @abstractmethod
    async def report(self) -> Status:
        """Request a status report and return it.

        A failure that the report shows is recorded as the fault.

        Raises
        ------
        ControllerError
            The connection is lost, or the controller is silent; this is recorded as the fault, too.
        """

    @abstractmethod
    async def abort(self) -> None:
        """Stop the machine and discard the program.

        Raises
        ------
        ControllerError
            The controller refuses, the connection is lost, or the controller is silent.
        """

    def has_not_begun(self, program: ProgramT, rest: Status) -> bool:
        """Return whether it is certain that no line of an aborted program was executed.

        Parameters
        ----------
        program
            The program that was aborted.
        rest
            Report of the machine at rest after that.
        """
        del program, rest
        return False

    # -- faults -----------------------------------------------------------------------------------

    def fail(self, error: ControllerError) -> ControllerError:
        """Record an error as the fault, unless there is a fault already; return the fault."""
        if self.fault is None:
            self.fault = error
        return self.fault

    def raise_fault(self) -> None:
        """Raise the fault if there is one."""
        if self.fault is not None:
            raise self.fault

    @abstractmethod
    def not_at_rest(self, seconds: float) -> ControllerError:
        """Return the error for a machine that is not at rest after some seconds."""
