"""connection: exchanges lines and realtime commands with a controller that uses grbl's protocol.

Program lines, commands of the driver and realtime commands (single bytes that the controller
executes at once) are sent over a ``Transport``.  Received lines are interpreted by a ``Receiver``.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from contextlib import suppress

from knifetip.errors import (
    ConnectionLost,
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerSilent,
    NoSuchController,
)
from knifetip.gateway.controller import Status
from knifetip.gateway.grbl import answers
from knifetip.gateway.grbl.exchange import Exchange
from knifetip.gateway.grbl.polling import Polling
from knifetip.gateway.grbl.receive_buffer import PendingLine
from knifetip.gateway.grbl.receiver import Receiver
from knifetip.gateway.grbl.watchdog import Watchdog
from knifetip.gateway.transport import Transport, byte_rate

#: Most bytes without a line end that are kept; a longer sequence is noise.
_LONGEST_ANSWER = 8192
#: Time in which a web server refuses a line (s).
_WEB_SERVER = 1.0


class GrblConnection(Exchange):
    """Connection to one controller, which can be restored with a new transport after it was lost.

    Each failure is recorded as the fault of the connection.  The first fault is raised by every
    later call, until ``reach`` or the driver clears it.

    Parameters
    ----------
    transport
        Open transport.
    reconnect
        Function that opens a new transport after the connection was lost; None to give up.
    silence
        Seconds after which the controller counts as silent if no status report arrives, or if a
        line has no answer although the machine is idle.
    polling
        Intervals between two status requests while the machine moves.
    """

    def __init__(
        self,
        transport: Transport,
        reconnect: Callable[[], Awaitable[Transport]] | None,
        silence: float,
        polling: Polling,
    ) -> None:
        super().__init__(f"grbl at {transport.address}", silence)
        self._transport = transport
        self._reconnect = reconnect
        self._watchdog = Watchdog(self, silence, polling)
        self._receiver = Receiver(self, self._watchdog)
        self._tasks: list[asyncio.Task[None]] = []
        self.connected = True  #: the transport is open
        self._closed = False
        self._sending = asyncio.Lock()

    # -- opening and closing ----------------------------------------------------------------------

    async def find_web_server(self) -> None:
        """Raise ``NoSuchController`` if a web server is at the other end.

        If that is silent, everything sent so far was the beginning of a line, which is ended here:
        a web server refuses a complete line.
        """
        if isinstance(self.fault, ControllerSilent):
            with suppress(ControllerError, TimeoutError):
                async with asyncio.timeout(_WEB_SERVER):
                    await self._transport.write(b"\r\n")
                    while self.connected and not self._receiver.web_server:
                        await self._next_change()
        if self._receiver.web_server:
            raise NoSuchController("controller.web-server", address=self._transport.address)

    def start(self) -> None:
        """Clear the recorded fault, and start the tasks that read answers and request reports.

        Tasks that are running already are not started again.
        """
        if not self._tasks:
            self._start_tasks()
        self.fault = None
        self._watchdog.restart()

    async def reach(self) -> None:
        """Clear the recorded fault of the connection; reconnect if the connection is lost.

        Raises
        ------
        ControllerError
            The connection was closed by ``close``, or a new transport cannot be opened.
        """
        if self._closed:
            raise ControllerError("controller.closed", name=self.name)
        if not self.connected:
            if self._reconnect is None:
                raise ControllerError("controller.lost-in-buffer", name=self.name)
            await self._disconnect()
            self._transport = await self._reconnect()
            self.status = None
            self.last_alarm = 0
            self._start_tasks()
        self._discard_lines()
        self.checking = False
        self.fault = None
        self._watchdog.restart()

    async def close(self) -> None:
        """Close the transport; the controller still executes the lines in its buffer."""
        self._closed = True
        await self._disconnect()
        self.fail(ControllerError("controller.closed", name=self.name))

    def _start_tasks(self) -> None:
        self.connected = True
        self._tasks = [
            asyncio.create_task(self._read_answers(), name="grbl answers"),
            asyncio.create_task(self._watchdog.run(), name="grbl watchdog"),
        ]

    async def _disconnect(self) -> None:
        """Cancel the tasks that read answers and request reports, and close the transport."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._tasks = []
        await self._transport.close()

    @property
    def byte_rate(self) -> float:
        """Bytes per second of the transport; infinite if it does not state them."""
        return byte_rate(self._transport)

    @property
    def polling(self) -> Polling:
        """Intervals between two status requests while the machine moves."""
        return self._watchdog.polling

    @polling.setter
    def polling(self, polling: Polling) -> None:
        self._watchdog.polling = polling

    # -- sending ----------------------------------------------------------------------------------

    async def send_line(self, line: PendingLine) -> None:
        """Send a line as soon as the receive buffer of the controller has room for it.

        Raises
        ------
        ControllerError
            The fault of the connection, if one is recorded before or while the method waits.
        """
        async with self._sending:
            await self.wait_until(lambda: self.buffer.has_room_for(line))
            if self.buffer.first is None:
                self._watchdog.expect_answer()
            self.buffer.add(line)
            if line.number and not self.checking:
                self.sent += 1
        await self._transport.write(line.text + b"\n")

    async def drain(self) -> None:
        """Wait until the controller has answered every line that was sent."""
        await self.wait_until(lambda: self.buffer.first is None)

    async def command(self, text: bytes, patience: float | None = None) -> list[str]:
        """Send a command of the driver, which is not a program line, and wait until it is answered.

        Parameters
        ----------
        text
            The command without newline, such as ``$I``.
        patience
            Seconds to wait for the answer; None for the limit of silence of the connection.

        Returns
        -------
        list of str
            Lines that the controller sent before the ``ok`` for the command.

        Raises
        ------
        ControllerRejected
            The controller refuses the command.
        ControllerError
            The fault of the connection, or the controller does not answer.
        """
        await self.drain()
        self._receiver.info.clear()
        answer: asyncio.Future[tuple[int, list[str]]]
        answer = asyncio.get_running_loop().create_future()
        await self.send_line(PendingLine(text, answer=answer))
        try:
            async with asyncio.timeout(self.silence if patience is None else patience):
                code, info = await answer
        except TimeoutError:
            raise self.fail(self.silence_error()) from None
        if code:
            if text and not text.startswith(b"$"):
                # grblHAL refuses all further lines with the same error until an empty one.
                await self.command(b"")
            raise ControllerRejected(
                "controller.rejected-command",
                name=self.name,
                command=text.decode(),
                error=answers.error_meaning(code),
                code=code,
            )
        return info

    async def realtime(self, byte: bytes) -> None:
        """Send a realtime command: a single byte that the controller executes at once."""
        self.raise_fault()
        await self._transport.write(byte)

    async def reset(self) -> None:
        """Reset the controller by software; return when its welcome banner has arrived."""
        self._discard_lines()
        await self.await_banner(
            lambda: self._transport.write(b"\x18"), "controller.reset-not-confirmed"
        )
        self._receiver.was_reset = True
        self._watchdog.restart()

    async def reset_by(self, command: bytes, code: str) -> None:
        """Send a command that resets the controller; return when its welcome banner has arrived.

        The answer to the command is not awaited: a reset may clear it before it is sent.

        Parameters
        ----------
        command
            The command without newline.
        code
            Message code of the ``ControllerSilent`` that is raised if no banner arrives.
        """
        await self.await_banner(lambda: self.send_line(PendingLine(command)), code)
        self._discard_lines()
        self._watchdog.restart()

    async def await_banner(self, cause: Callable[[], Awaitable[object]], code: str) -> None:
        """Call ``cause``, which resets the controller; return when its banner has arrived.

        Parameters
        ----------
        cause
            Function that makes the controller reset, for example by sending the reset command.
        code
            Message code of the ``ControllerSilent`` that is raised if no banner arrives.
        """
        receiver = self._receiver
        banners, receiver.banner_due = receiver.banners, True
        await cause()
        await self.wait_until(lambda: receiver.banners > banners, code)

    # -- status reports ---------------------------------------------------------------------------

    async def request_report(self) -> None:
        """Send a status request (``?``); return before its report arrives."""
        self.buffer.note_request(asyncio.get_running_loop().time())
        await self._transport.write(b"?")

    async def report(self, patience: float | None = None) -> Status:
        """Request a status report and return it.

        If no report arrives, the error is raised but not recorded as the fault of the connection.
        In check mode the report is awaited as long as the controller answers lines.

        Parameters
        ----------
        patience
            Seconds to wait for the report; None for the limit of silence of the connection.

        Raises
        ------
        ControllerSilent
            No report arrived.
        ControllerError
            The fault of the connection, if there is one.
        """
        self.raise_fault()
        reports_before = self._receiver.reports
        await self.request_report()
        clock, seconds = asyncio.get_running_loop(), self.silence if patience is None else patience
        limit = clock.time() + seconds
        while self._receiver.reports == reports_before:
            try:
                async with asyncio.timeout_at(limit):
                    await self._wait_for_change(lambda: self._receiver.reports > reports_before)
            except TimeoutError:
                limit = self._watchdog.heard + seconds
                if not self.checking or clock.time() >= limit:
                    raise self.silence_error() from None
        self.raise_fault()
        assert self.status is not None
        return self.status

    def _discard_lines(self) -> None:
        """Remove all lines from the list of unanswered lines, because a reset discards them.

        The tasks that wait for an answer to one of these lines raise an error.
        """
        self.buffer.fail(ControllerError("controller.was-reset", name=self.name))
        self.buffer.clear()

    # -- received lines ---------------------------------------------------------------------------

    async def _read_answers(self) -> None:
        """Read lines from the transport and handle each of them, until the connection is lost."""
        rest = b""
        while chunk := await self._transport.read():
            *lines, rest = (rest + chunk).split(b"\n")
            for line in lines:
                self._receiver.receive(line.strip().decode("ascii", "replace"))
            if len(rest) > _LONGEST_ANSWER:
                rest = b""
        self.connected = False
        if isinstance(self.fault, ControllerAlarm):
            self.fault = None  # the loss matters more: an unreachable controller cannot be unlocked
        self.fail(ConnectionLost("controller.lost", name=self.name, due=self.buffer.due()))
