"""exchange: the state of one controller and of the lines that were sent to it.

The tasks that send, receive and supervise share this state.  The first failure is kept as the fault
of the exchange, and raised in every task that waits for the controller.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable

from knifetip.errors import ControllerError, ControllerRejected, ControllerSilent
from knifetip.gateway.controller import Observer, Status
from knifetip.gateway.grbl.receive_buffer import ReceiveBuffer


class Exchange:
    """Exchange of lines with one controller, without the transport.

    The first failure is kept as the fault of the connection until it is cleared.  Each method that
    waits raises it.

    Parameters
    ----------
    name
        Address of the controller, for messages.
    silence
        Time limit for answers of the controller (s).
    """

    def __init__(self, name: str, silence: float) -> None:
        self.name = name
        self.silence = silence
        self.buffer = ReceiveBuffer()
        self.fault: ControllerError | None = None
        self.observer: Observer | None = None
        self.status: Status | None = None  #: last status report
        self.acknowledged = 0  #: program lines answered outside check mode
        self.sent = 0  #: program lines sent outside check mode
        self.last_alarm = 0  #: code of the present alarm, 0 if none was received
        self.axes = 0  #: number of axes in status reports, 0 before the first one
        self.rotary = 3  #: index of the axis that rotates the tool, in status reports
        self.checking = False  #: the controller is in check mode
        self.refusals: list[ControllerRejected] = []  #: of program lines, in check mode
        self.hard_limits = True  #: a pressed limit switch stops the machine (``$21``)
        self.recovering = False  #: the machine is being brought into its safe state
        self._changed = asyncio.Event()  # something was received, or a fault was recorded

    def fail(self, error: ControllerError) -> ControllerError:
        """Record an error as the fault of the connection, and return the fault.

        If the connection already has a fault, that fault is kept and returned instead of ``error``.
        The tasks that wait for an answer are woken, and raise the fault.
        """
        if self.fault is None:
            self.fault = error
        self.buffer.fail(self.fault)
        self._changed.set()
        return self.fault

    def raise_fault(self) -> None:
        """Raise the fault of the connection if there is one."""
        if self.fault is not None:
            raise self.fault

    def silence_error(self) -> ControllerSilent:
        """Return (not raise) a new error which states that the controller does not answer."""
        return ControllerSilent(
            "controller.silent", name=self.name, seconds=self.silence, due=self.buffer.due()
        )

    def surplus_answer(self) -> ControllerError:
        """Return (not raise) a new error for an answer that belongs to no line."""
        return ControllerError("controller.unexpected-answer", name=self.name)

    def missing_answer(self) -> ControllerSilent:
        """Return (not raise) a new error for a line whose answer was lost."""
        return ControllerSilent("controller.answer-missing", name=self.name, due=self.buffer.due())

    async def wait_until(self, condition: Callable[[], bool], code: str = "") -> None:
        """Wait until ``condition()`` is true; raise the fault of the connection if one is recorded.

        Parameters
        ----------
        condition
            Function that is called after each received line.
        code
            Message code of the ``ControllerSilent`` that is raised if the condition is still false
            after the limit of silence; empty to wait without a time limit.
        """
        try:
            async with asyncio.timeout(self.silence if code else None):
                await self._wait_for_change(condition)
        except TimeoutError:
            raise self.fail(ControllerSilent(code, name=self.name, seconds=self.silence)) from None
        self.raise_fault()

    async def _next_change(self) -> None:
        """Wait until ``note_change`` is called, or a fault is recorded."""
        self._changed.clear()
        await self._changed.wait()

    def note_change(self) -> None:
        """Make the waiting tasks test their conditions again; called after each received line."""
        self._changed.set()

    async def _wait_for_change(self, condition: Callable[[], bool]) -> None:
        while not condition():
            self.raise_fault()
            await self._next_change()
