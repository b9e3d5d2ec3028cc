"""connection: exchanges lines and realtime commands with a controller that uses grbl's protocol.

Program lines, commands of the driver and realtime commands (single bytes that the controller
executes at once) are sent over a ``Transport``.  The controller answers with ``ok``, ``error``,
``ALARM``, status reports and its welcome banner.
"""

from __future__ import annotations

import asyncio
import re
from collections.abc import Awaitable, Callable
from contextlib import suppress

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
    NoSuchController,
)
from knifetip.gateway.controller import Observer, State, Status
from knifetip.gateway.grbl import answers
from knifetip.gateway.grbl.polling import Polling
from knifetip.gateway.grbl.receive_buffer import Count, PendingLine, ReceiveBuffer
from knifetip.gateway.grbl.watchdog import Watchdog
from knifetip.gateway.interpreter import strip_comments
from knifetip.gateway.motion import Pose
from knifetip.gateway.transport import Transport, byte_rate, is_from_web_server

#: Most bytes without a line end that are kept; a longer sequence is noise.
_LONGEST_ANSWER = 8192
#: Most characters of an echoed line that a message contains.
_LONGEST_ECHO = 60
#: Time in which a web server refuses a line (s).
_WEB_SERVER = 1.0
#: Most lines between two answers that are kept.
_MOST_LINES = 1000
#: Consecutive status reports that must show the same contradiction before it counts as a fault.
_CONTRADICTIONS = {Count.SURPLUS: 2, Count.MISSING: 3}

_BANNER = re.compile(r"grbl", re.IGNORECASE)
#: A line as the controller received it; sent before the answer if the firmware is built to echo.
_ECHO = re.compile(r"\[echo: ?(.*)\]")


class GrblConnection:
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
        self.name = f"grbl at {transport.address}"
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
        self.recovering = False  #: the machine is being brought into its safe state
        self.web_server = False  #: a web server has answered, not a controller
        self._transport = transport
        self._reconnect = reconnect
        self._watchdog = Watchdog(self, silence, polling)
        self._tasks: list[asyncio.Task[None]] = []
        self.connected = True  #: the transport is open
        self._closed = False
        self._sending = asyncio.Lock()
        self._changed = asyncio.Event()  # something was received, or a fault was recorded
        self._reports = 0  # number of status reports received
        self._offset: Pose | None = None  # work offset of the last report that contained one
        self._info: list[str] = []  # lines received since the last command, except answers
        self._banners = 0  # number of banners received
        self._banner_due = False
        self._was_reset = False  # by this connection: earlier answers are of another sender

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
                    while self.connected and not self.web_server:
                        self._changed.clear()
                        await self._changed.wait()
        if self.web_server:
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
        self._info.clear()
        answer: asyncio.Future[tuple[int, list[str]]]
        answer = asyncio.get_running_loop().create_future()
        await self.send_line(PendingLine(text, answer=answer))
        try:
            async with asyncio.timeout(self.silence if patience is None else patience):
                code, info = await answer
        except TimeoutError:
            raise self.fail(self.silent()) from None
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
        self._was_reset = True
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
        banners, self._banner_due = self._banners, True
        await cause()
        await self.wait_until(lambda: self._banners > banners, code)

    # -- status reports ---------------------------------------------------------------------------

    async def request_report(self) -> None:
        """Send a status request (``?``); return before its report arrives."""
        self.buffer.note_request(asyncio.get_running_loop().time())
        await self._transport.write(b"?")

    async def report(self, patience: float | None = None) -> Status:
        """Request a status report and return it.

        If no report arrives, the error is raised but not recorded as the fault of the connection.

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
        reports_before = self._reports
        await self.request_report()
        try:
            async with asyncio.timeout(self.silence if patience is None else patience):
                await self._wait_for_change(lambda: self._reports > reports_before)
        except TimeoutError:
            raise self.silent() from None
        self.raise_fault()
        assert self.status is not None
        return self.status

    # -- faults and waiting -----------------------------------------------------------------------

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

    def silent(self) -> ControllerSilent:
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

    async def _wait_for_change(self, condition: Callable[[], bool]) -> None:
        while not condition():
            self.raise_fault()
            self._changed.clear()
            await self._changed.wait()

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
                self._handle_line(line.strip().decode("ascii", "replace"))
            if len(rest) > _LONGEST_ANSWER:
                rest = b""
        self.connected = False
        if isinstance(self.fault, ControllerAlarm):
            self.fault = None  # the loss matters more: nobody can unlock the controller
        self.fail(ControllerError("controller.lost", name=self.name, due=self.buffer.due()))

    def _handle_line(self, line: str) -> None:
        if is_from_web_server(line):
            self.web_server = True
        elif line == "ok":
            self._handle_answer(0)
        elif line.startswith("error:"):
            self._handle_answer(_code(line))
        elif line.startswith("<"):
            self._handle_report(line)
        elif line.startswith("ALARM:"):
            self._handle_alarm(_code(line))
        elif echo := _ECHO.fullmatch(line):
            self._handle_echo(echo[1])
        elif _BANNER.match(line):
            self._handle_banner()
        elif line and len(self._info) < _MOST_LINES:
            self._info.append(line)
        self._changed.set()

    def _handle_answer(self, code: int) -> None:
        """Assign an answer of the controller to the oldest unanswered line.

        If the answer refuses a program line, a fault of the connection is recorded; in check mode,
        the refusal is only stored in ``refusals``.  If no line is unanswered, a fault is recorded
        too, except during a reset or a recovery.

        Parameters
        ----------
        code
            Error code of the answer, 0 for ``ok``.
        """
        if self.buffer.first is None:
            if self._was_reset and not (self._banner_due or self.recovering):
                self.fail(self.surplus_answer())
            return  # the answer is from before the reset
        line = self.buffer.remove_first()
        self._watchdog.note_answer()
        if line.answer is not None:
            if not line.answer.done():
                line.answer.set_result((code, list(self._info)))
            return
        if not self.checking:
            self.acknowledged += 1
            # The machine starts another move: request its position.
            self._watchdog.request_soon()
        if code:
            refused = ControllerRejected(
                "controller.rejected-in-check" if self.checking else "controller.rejected-line",
                name=self.name,
                line=line.number,
                text=line.excerpt,
                error=answers.error_meaning(code),
                code=code,
            )
            if self.checking:
                self.refusals.append(refused)
            else:
                self.fail(refused)

    def _handle_echo(self, text: str) -> None:
        """Compare a line as the controller received it with the line that was sent.

        The next answer belongs to this line, so it is the oldest unanswered one.  Some builds
        remove comments and blanks before they echo a line, and change it to capital letters.
        """
        line = self.buffer.first
        if line is None or self._banner_due or self.recovering:
            return
        received = strip_comments(text.encode("ascii", "replace"))
        if received != strip_comments(line.text):
            self.fail(
                ControllerError(
                    "controller.line-changed",
                    name=self.name,
                    line=line.number,
                    sent=line.excerpt,
                    received=text[:_LONGEST_ECHO],
                )
            )

    def _handle_report(self, line: str) -> None:
        report = answers.report(line, self.rotary)
        if report is None:
            return
        self.axes = report.axes or self.axes
        if report.offset is not None:
            self._offset = report.offset
        if report.state is not State.ALARM:
            self.last_alarm = 0
        self._reports += 1
        self.status = self._status_of(report)
        self._watchdog.note_report()
        count, repeats = self.buffer.compare(report.room)
        if self.fault is not None or self.recovering:
            return
        self._judge_count(count, repeats)
        if self.observer is not None:
            if (error := self.observer.observe(self.status)) is not None:
                self.fail(error)
            elif self.observer.doubtful:
                self._watchdog.request_at_once()

    def _status_of(self, report: answers.Report) -> Status:
        """Return the status that a report of grbl describes.

        If the report contains no position, the position of the previous status is used.
        """
        position = report.work
        if position is None and report.machine is not None:
            offset = self._offset or (0.0, 0.0, 0.0, 0.0)
            x, y, z, c = (m - o for m, o in zip(report.machine, offset, strict=True))
            position = x, y, z, c
        if position is None:
            position = self.status.position if self.status else (0.0, 0.0, 0.0, 0.0)
        return Status(
            state=report.state,
            position=position,
            acknowledged=self.acknowledged,
            still=report.still,
            number=report.number,
            free=report.free,
            feed=report.feed,
            sent=self.sent,
            located=report.work is not None or self._offset is not None,
        )

    def _judge_count(self, count: Count, repeats: int) -> None:
        """Record a fault if status reports contradict the number of bytes in the receive buffer.

        Parameters
        ----------
        count
            Result for the last report.
        repeats
            Number of consecutive reports with this result.
        """
        if count is Count.POSSIBLE or self._banner_due:
            return
        self._watchdog.request_at_once()
        if repeats >= _CONTRADICTIONS[count]:
            lost = count is Count.MISSING
            self.fail(self.missing_answer() if lost else self.surplus_answer())

    def _handle_alarm(self, code: int) -> None:
        self.last_alarm = code
        if self.recovering and self.buffer.first is None:
            return  # it was reset while it still moved
        self.fail(
            ControllerAlarm(
                "controller.alarm",
                name=self.name,
                code=code,
                alarm=answers.alarm_meaning(code),
                due=self.buffer.due() if code == answers.SOFT_LIMIT else None,
            )
        )

    def _handle_banner(self) -> None:
        self._banners += 1
        if self._banner_due:
            self._banner_due = False
            return
        if self.status is None or (self.recovering and self.buffer.first is None):
            return  # some controllers send a banner to each client; others were reset before
        self.fail(ControllerReset("controller.reset", name=self.name, due=self.buffer.due()))


def _code(line: str) -> int:
    """Return the code in an answer, such as 9 for ``error:9``; -1 if the code is not a number."""
    code = line.partition(":")[2].strip()
    return int(code) if code.isdecimal() else -1
