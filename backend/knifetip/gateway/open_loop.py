"""open_loop: a controller that takes a program and reports nothing, such as a plotter.

Only a person at the machine can see when it has finished.  When the whole program is sent, the
controller therefore counts as held, until a person has seen the end of the program
(``confirm_end``).  Until then it can neither be held nor resumed nor stopped; ``stop`` raises an
error that states this.
The reasons are in docs/decisions/0071.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import Iterable

from knifetip.errors import ControllerError
from knifetip.gateway.controller import Observer, State, Status


class OpenLoop:
    """A controller that reports nothing; the methods are those of ``ProgramController``.

    A subclass hands a program over (``hand_over``) and withdraws it (``withdraw``).

    Parameters
    ----------
    name
        Address of the controller, for messages.
    """

    observer: Observer | None = None
    capacity: int | None = None
    accuracy: float = math.inf  # no position is reported
    ahead: int = 0

    def __init__(self, name: str) -> None:
        self.name = name
        self.fault: ControllerError | None = None
        self.sent = 0  #: lines handed over since ``open``
        self.acknowledged = 0  #: lines executed for certain since ``open``
        self._running = False
        self._finished: asyncio.Event | None = None  # while a person must confirm the end

    async def hand_over(self, text: bytes) -> None:
        """Hand a whole program over to the machine.

        Raises
        ------
        ControllerError
            The machine or its connection accepts no more of the program.
        """
        raise NotImplementedError

    async def withdraw(self) -> ControllerError:
        """Prevent the machine from starting what it has not started; return what a person must do.

        The method is called after a program was handed over partly or completely.
        """
        raise NotImplementedError

    async def open(self) -> None:
        """Do nothing: the state of the machine cannot be requested."""

    async def check(self, lines: Iterable[bytes]) -> None:
        """Do nothing: the machine cannot parse a program without motion."""
        del lines

    async def run(self, text: bytes) -> Status:
        """Hand a program over, and return when a person has confirmed that it is executed.

        Raises
        ------
        ControllerError
            The program could not be handed over completely.
        """
        if self.fault is not None:
            raise self.fault
        last = self.sent + text.count(b"\n")
        self._running = True
        try:
            await self.hand_over(text)
        except ControllerError as error:
            self.fault = self.fault or error
            raise
        self._finished = asyncio.Event()
        await self._finished.wait()
        self._running, self._finished = False, None
        self.sent = self.acknowledged = last
        return await self.status()

    async def status(self) -> Status:
        """Return what is known: not the position, and at rest only what a person has confirmed.

        Raises
        ------
        ControllerError
            The controller has failed before.
        """
        if self.fault is not None:
            raise self.fault
        state = State.RUN if self._running else State.IDLE
        if self._finished is not None:
            state = State.HOLD
        return Status(
            state,
            (0.0, 0.0, 0.0, 0.0),
            self.acknowledged,
            still=not self._running,
            sent=self.sent,
            located=False,
            awaits_end=self._finished is not None,
        )

    async def hold(self) -> None:
        """Do nothing: the machine cannot be held, and must not be reported as held."""

    async def resume(self) -> None:
        """Do nothing: the machine was not held."""

    def confirm_end(self) -> None:
        """Record that a person has seen that the program which was handed over is executed."""
        if self._finished is not None:
            self._finished.set()

    async def stop(self) -> Status:
        """Withdraw the running program as far as possible.

        Returns
        -------
        Status
            Status, if no program was running: nothing was handed over.

        Raises
        ------
        ControllerError
            A program was running; the machine may still execute it.
        """
        if not self._running:
            self.fault = None
            return await self.status()
        self._running, self._finished = False, None
        self.fault = await self.withdraw()
        raise self.fault

    async def close(self) -> None:
        """Do nothing; a subclass closes its connection."""
