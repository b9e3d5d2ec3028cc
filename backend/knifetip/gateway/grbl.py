"""grbl: driver for controllers with the protocol of grbl 1.1, such as grblHAL.

Program lines and realtime commands (single bytes that act at once) are sent over a ``Transport``.
The controller answers with ``ok``, ``error``, ``ALARM``, status reports and its welcome banner.

The bytes of unanswered lines are counted against the receive buffer, so that the planner never runs
empty and the buffer never overflows.  The controller parses the program in check mode before
anything moves.  Every failure raises one of five errors and never waits without end:
``ControllerRejected``, ``ControllerAlarm``, ``ControllerReset`` (an unexpected banner),
``ControllerSilent`` (no answer, or a lost ``ok``) and ``ControllerError`` (a lost connection, or a
surplus ``ok``).  After each of them ``stop`` brings the machine into its safe state (``recovery``).

A doubled ``ok`` makes the count of free bytes wrong.  It is detected by an answer without an
unanswered line, by a report of more bytes in the buffer than are unanswered, at the latest in
``settle``.  Until then room for the longest line is kept free, so that the buffer does not
overflow.
"""

from __future__ import annotations

import asyncio
import re
from collections import deque
from collections.abc import Awaitable, Callable, Iterable
from contextlib import suppress
from dataclasses import dataclass

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
    ControllerSilent,
    ProgramError,
)
from knifetip.gateway import answers, recovery
from knifetip.gateway.controller import Observer, SafeState, State, Status
from knifetip.gateway.interpreter import switches
from knifetip.gateway.motion import Pose
from knifetip.gateway.transport import Transport, connect
from knifetip.messages import Message

#: Size of the receive buffer (bytes) if ``$I`` does not report it.
WINDOW = 128
#: An answer longer than this is noise (bytes).
NOISE = 8192
#: Shortest time between two ``?`` sent after answers (s).
GLANCE = 0.02
#: Time between two status requests while the machine comes to rest (s).
REST = 0.01
#: Consecutive reports that must contradict the byte count before it is considered wrong.
TWICE = 2

_REALTIME = re.compile(rb"[^\x20-\x7e\t\r]|[?!~]")
_BANNER = re.compile(r"grbl", re.IGNORECASE)
_OPTIONS = re.compile(r"\[OPT:[^,\]]*,(\d+),(\d+)")
_AXES = re.compile(r"\[AXS:\d+:([A-Z]+)")
_DWELL = re.compile(rb"G0?4(?!\d)[^P]*P\s*(\d+\.?\d*)", re.IGNORECASE)


@dataclass(slots=True)
class _Sent:
    """A line that is not answered yet; its bytes may be in the controller's buffer."""

    size: int
    text: bytes
    number: int  #: in the program, from 1; 0 for a command of the driver
    answer: asyncio.Future[tuple[int, list[str]]] | None = (
        None  #: error code, and the lines received before the answer
    )


class Grbl:
    """A controller connected through a transport.

    Parameters
    ----------
    transport
        Open.
    safe
        Safe state for ``open`` and ``stop``; None only holds and resets.
    reconnect
        Opens a new transport after a lost connection; None to give up.
    silence
        Seconds without any answer, or with an answer due and nothing moving, after which the
        controller counts as silent.
    poll
        Longest time between two ``?`` while the machine works (s); at rest, with no line to
        answer, it is a fifth of ``silence``.
    """

    def __init__(
        self,
        transport: Transport,
        *,
        safe: SafeState | None = None,
        reconnect: Callable[[], Awaitable[Transport]] | None = None,
        silence: float = 5.0,
        poll: float = 0.1,
    ) -> None:
        self._transport = transport
        self._safe = safe
        self._reconnect = reconnect
        self._silence = silence
        self._poll = poll
        self._window = WINDOW - 1
        self._rotary = 3
        self._flight: deque[_Sent] = deque()
        self._used = 0
        self._longest = 0  # line since all answers were accounted for
        self._most_room = 0  # most bytes ever free in the receive buffer
        self._contradictions = 0
        self._info: list[str] = []
        self._news = asyncio.Event()
        self._wake = asyncio.Event()  # the watch
        self._glance = False  # a line was answered: request a report soon
        self._doubt = False  # a report contradicts the state: request another at once
        self._reports = 0
        self._status: Status | None = None
        self._offset: Pose | None = None
        self._heard = 0.0  # when the last report came
        self._moved = 0.0  # time of the last event that explains a missing answer
        self._banners = 0
        self._banner_due = False
        self._checking = False
        self._recovering = False
        self._connected = True
        self._closed = False
        self._refusals: list[ControllerRejected] = []  # in check mode
        self._lock = asyncio.Lock()
        self._tasks: list[asyncio.Task[None]] = []
        self.name = f"grbl at {transport.address}"
        self.fault: ControllerError | None = None
        self.observer: Observer | None = None
        self.acknowledged = 0
        self.sent = 0
        self.capacity: int | None = None
        self.last_alarm = 0  #: code of the present alarm, 0 if none was received

    # -- opening and closing ------------------------------------------------------------------

    async def open(self, *, unlock: bool = False, stop_motion: bool = False) -> None:
        """Take the controller over: at rest, unlocked, buffers empty, machine in its safe state.

        The controller is reset, which is harmless at rest; then Z is raised and all outputs are
        switched off, because a reset does not change them.  A moving or held machine is not
        touched unless its program is known to be ours (``stop_motion``).  A locked machine is not
        touched; with ``unlock`` the operator confirms the position, and the alarm is cleared
        without homing (``$X``).

        Raises
        ------
        ControllerError
            It is busy, in alarm, does not answer, or refuses to switch an output off.
        """
        if not self._tasks:
            self._listen_and_watch()
        self.fault = None
        self._heard = self._now()
        try:
            status = await self._ask(min(self._silence, 2.0))
        except ControllerSilent:
            # After a critical alarm grbl answers nothing until it is reset.
            status = None
        if status and status.state not in (State.IDLE, State.CHECK, State.ALARM):
            if not (stop_motion and status.state in (State.RUN, State.HOLD)):
                raise ControllerError("controller.busy", name=self.name, state=status.state.value)
            await self.stop()
        else:
            await self.reset()
        status = await self.status()
        if status.state is State.ALARM and unlock:
            await self.command(b"$X")
            status = await self.status()
        if status.state is State.ALARM:
            raise self._fail(ControllerAlarm("controller.locked-by-alarm", name=self.name))
        for line in await self.command(b"$I"):
            if options := _OPTIONS.match(line):
                self.capacity = int(options[1])
                self._window = max(int(options[2]), 2) - 1
            elif axes := _AXES.match(line):
                self._rotary = answers.rotary_axis(axes[1])
        if self._safe is not None and self._safe.beam:
            await self._require_laser_mode()
        await recovery.secure(self, self._safe, self._silence)

    async def _require_laser_mode(self) -> None:
        """Refuse a machine with a beam whose controller does not switch it off at a hold.

        Only in laser mode does grbl switch the spindle output off at every hold, of the gateway or
        of its own button, and for every rapid.
        """
        if "$32=1" not in await self.command(b"$$"):
            raise self._fail(ControllerError("controller.not-in-laser-mode", name=self.name))

    async def close(self) -> None:
        """Close the transport; the controller still executes the lines in its buffer."""
        self._closed = True
        await self._hang_up()
        self._fail(ControllerError("controller.closed", name=self.name))

    # -- lines ----------------------------------------------------------------------------------

    async def check(self, lines: Iterable[bytes]) -> None:
        """Let the controller parse a program without motion (``$C``).

        Lines that switch outputs are omitted: check mode may execute them.

        Raises
        ------
        ControllerRejected
            The controller refuses a line; nothing has moved.
        ControllerAlarm
            A move exceeds the travel; nothing has moved, but the controller is locked.
        """
        await self.command(b"$C")
        self._checking = True
        self._refusals.clear()
        try:
            for number, line in enumerate(lines, 1):
                if self._refusals:
                    break
                if not switches(line):
                    await self.send(line, number)
            await self.drain()
            # Leaving check mode resets the controller, banner and all.
            banners, self._banner_due = self._banners, True
            await self.command(b"$C")
            await self._until(lambda: self._banners > banners, "controller.check-end-not-confirmed")
        finally:
            self._checking = False
        if self._refusals:
            raise self._refusals[0]

    async def send(self, line: bytes, number: int) -> None:
        """Send a line as soon as the receive buffer has room for it.

        Raises
        ------
        ProgramError
            The line contains realtime commands, or is longer than the buffer.
        ControllerError
            Any failure so far.
        """
        if found := _REALTIME.search(line):
            raise ProgramError("program.control-byte", line=number, byte=found[0].hex())
        if len(line) + 1 > self._window:
            raise ProgramError(
                "program.line-too-long-to-send",
                line=number,
                length=len(line),
                name=self.name,
                limit=self._window - 1,
            )
        if not self._checking:
            self._longest = max(self._longest, len(line) + 1)
        await self._put(_Sent(len(line) + 1, line, number))

    async def drain(self) -> None:
        """Wait until every line has been answered."""
        await self._until(lambda: not self._flight)

    async def settle(self) -> Status:
        """Wait until the machine is at rest and every answer is accounted for.

        After a doubled ``ok`` the last line seems answered too early.  ``$G`` sends a line before
        its ``ok``, so an ``ok`` without that line belongs to another command.
        """
        await self.drain()
        idle = 0
        # Twice: the planner may have accepted a move without having started it.
        while idle < 2:
            status = await self.status()
            idle = idle + 1 if status.state is State.IDLE else 0
            if not idle:
                await asyncio.sleep(REST)
        if not any(line.startswith("[GC:") for line in await self.command(b"$G")):
            raise self._fail(self._one_too_many())
        self._longest = 0
        return status

    async def status(self) -> Status:
        """Request a status report (``?``) and return it."""
        self._raise()
        try:
            return await self._ask(self._silence)
        except ControllerSilent as silent:
            raise self._fail(silent) from None

    async def hold(self) -> None:
        """Feed hold (``!``)."""
        self._raise()
        await self._transport.write(b"!")

    async def resume(self) -> None:
        """Cycle start (``~``)."""
        self._raise()
        await self._transport.write(b"~")

    async def stop(self) -> Status:
        """Discard the rest of the program and bring the machine into its safe state.

        Clears earlier failures; reconnects if the connection is lost.

        Returns
        -------
        Status
            After the machine came to rest, or was lifted.

        Raises
        ------
        ControllerError
            See ``recovery.make_safe``.
        """
        self._recovering = True
        done = False
        try:
            status = await recovery.make_safe(self, self._safe, self._silence)
            done = True
        except ControllerError as unsafe:
            self.fault = None  # the present fault matters more than the first one
            raise self._fail(unsafe) from None
        finally:
            self._recovering = False
            if not done:
                self._fail(ControllerError("controller.not-recovered", name=self.name))
        return status

    # -- what recovery needs ----------------------------------------------------------------------

    async def reach(self) -> None:
        """Clear the fault; reconnect if the connection is lost."""
        if self._closed:
            raise ControllerError("controller.closed", name=self.name)
        if not self._connected:
            if self._reconnect is None:
                raise ControllerError("controller.lost-in-buffer", name=self.name)
            await self._hang_up()
            self._transport = await self._reconnect()
            self._status = None
            self.last_alarm = 0
            self._listen_and_watch()
        self._clear_flight()
        self._checking = False
        self.fault = None
        self._heard = self._moved = self._now()

    async def realtime(self, byte: bytes) -> None:
        """Send a realtime command."""
        self._raise()
        await self._transport.write(byte)

    async def report(self) -> Status:
        """Request a status report and return it; silence is not a fault here."""
        self._raise()
        return await self._ask(self._silence)

    async def reset(self) -> None:
        """Soft reset, and wait for the banner."""
        banners, self._banner_due = self._banners, True
        self._clear_flight()
        await self._transport.write(b"\x18")
        await self._until(lambda: self._banners > banners, "controller.reset-not-confirmed")
        self._heard = self._moved = self._now()

    async def command(self, text: bytes) -> list[str]:
        """Send a command of the driver; return the lines received before its ``ok``."""
        await self.drain()
        self._info.clear()
        answer: asyncio.Future[tuple[int, list[str]]]
        answer = asyncio.get_running_loop().create_future()
        await self._put(_Sent(len(text) + 1, text, 0, answer))
        try:
            async with asyncio.timeout(self._silence):
                code, info = await answer
        except TimeoutError:
            raise self._fail(self._silent()) from None
        if code:
            raise ControllerRejected(
                "controller.rejected-command",
                name=self.name,
                command=text.decode(),
                error=answers.error_meaning(code),
                code=code,
            )
        return info

    # -- the inside -----------------------------------------------------------------------------

    def _listen_and_watch(self) -> None:
        self._connected = True
        self._tasks = [
            asyncio.create_task(self._listen(), name="grbl listen"),
            asyncio.create_task(self._watch(), name="grbl watch"),
        ]

    async def _hang_up(self) -> None:
        """Stop the tasks of this connection and close it."""
        for task in self._tasks:
            task.cancel()
        await asyncio.gather(*self._tasks, return_exceptions=True)
        self._tasks = []
        await self._transport.close()

    def _clear_flight(self) -> None:
        """Discard the lines in flight and their byte counts, as a reset does."""
        for sent in self._flight:
            if sent.answer and not sent.answer.done():
                sent.answer.set_exception(ControllerError("controller.was-reset", name=self.name))
                sent.answer.exception()  # the waiting task may be gone
        self._flight.clear()
        self._used = self._longest = self._contradictions = 0

    def _now(self) -> float:
        return asyncio.get_running_loop().time()

    def _fail(self, error: ControllerError) -> ControllerError:
        """Record the first failure, wake all waiting tasks, and return it."""
        if self.fault is None:
            self.fault = error
        for sent in self._flight:
            if sent.answer and not sent.answer.done():
                sent.answer.set_exception(self.fault)
                sent.answer.exception()  # the waiting task may be gone
        self._news.set()
        return self.fault

    def _raise(self) -> None:
        if self.fault is not None:
            raise self.fault

    async def _until(self, true: Callable[[], bool], code: str = "") -> None:
        """Wait until ``true()`` returns True.

        With ``code``, fail after the limit of silence with the error of that code; without it
        the watch limits the time.
        """
        try:
            async with asyncio.timeout(self._silence if code else None):
                while not true():
                    self._raise()
                    self._news.clear()
                    await self._news.wait()
        except TimeoutError:
            raise self._fail(
                ControllerSilent(code, name=self.name, seconds=self._silence)
            ) from None
        self._raise()

    async def _put(self, sent: _Sent) -> None:
        async with self._lock:
            await self._until(lambda: self._fits(sent))
            if not self._flight:
                self._moved = self._now()
                self._wake.set()
            self._flight.append(sent)
            self._used += sent.size
            if sent.number and not self._checking:
                self.sent += 1
        await self._transport.write(sent.text + b"\n")

    def _fits(self, sent: _Sent) -> bool:
        """Return whether the buffer has room for a line, even after one doubled answer."""
        return not self._flight or self._used + sent.size + self._longest <= self._window

    async def _ask(self, patience: float) -> Status:
        seen = self._reports
        await self._transport.write(b"?")
        try:
            async with asyncio.timeout(patience):
                while self._reports == seen:
                    self._raise()
                    self._news.clear()
                    await self._news.wait()
        except TimeoutError:
            raise self._silent() from None
        self._raise()
        assert self._status is not None
        return self._status

    def _silent(self) -> ControllerSilent:
        return ControllerSilent(
            "controller.silent", name=self.name, seconds=self._silence, due=self._due()
        )

    def _due(self) -> Message | None:
        first = next((sent for sent in self._flight if sent.number), None)
        if first is None:
            return None
        return Message("controller.due", line=first.number, text=_shown(first.text))

    async def _watch(self) -> None:
        """Request reports regularly, and detect silence and lost answers."""
        with suppress(ControllerError):
            while True:
                before, interval = self._now(), self._interval()
                await self._pause()
                await self._transport.write(b"?")
                if self.fault is not None or self._status is None or self._recovering:
                    continue
                now = self._now()
                if now - before > interval + self._silence / 2.0:
                    # This process was busy and did not listen: no silence can be concluded.
                    self._heard = self._moved = now
                if now - self._heard > self._silence:
                    self._fail(self._silent())
                elif self._status.state is State.ALARM and (due := self._due()):
                    self._fail(ControllerAlarm("controller.alarm-state", name=self.name, due=due))
                elif not self._flight or self._status.state not in (State.IDLE, State.CHECK):
                    self._moved = now
                elif now - self._moved > self._silence + _dwell(self._flight[0].text):
                    self._fail(
                        ControllerSilent(
                            "controller.answer-lost",
                            name=self.name,
                            state=self._status.state.value,
                            seconds=self._silence,
                            due=self._due(),
                        )
                    )

    def _interval(self) -> float:
        """Return the longest time between two ``?`` in the present state (s)."""
        at_rest = self._status is not None and self._status.state is State.IDLE
        if at_rest and not self._flight and not self._recovering:
            return max(self._poll, self._silence / 5.0)
        return self._poll

    async def _pause(self) -> None:
        """Wait until the next ``?``: shorter after an answer, or after a doubtful report."""
        start = self._now()
        while not self._doubt:
            due = start + (min(GLANCE, self._poll) if self._glance else self._interval())
            if (left := due - self._now()) <= 0.0:
                break
            self._wake.clear()
            with suppress(TimeoutError):
                async with asyncio.timeout(left):
                    await self._wake.wait()
        self._glance = self._doubt = False

    async def _listen(self) -> None:
        rest = b""
        while chunk := await self._transport.read():
            *lines, rest = (rest + chunk).split(b"\n")
            for line in lines:
                self._hear(line.strip().decode("ascii", "replace"))
            if len(rest) > NOISE:
                rest = b""
        self._connected = False
        self._fail(ControllerError("controller.lost", name=self.name, due=self._due()))

    def _hear(self, line: str) -> None:
        if line == "ok":
            self._answered(0)
        elif line.startswith("error:"):
            self._answered(_figure(line))
        elif line.startswith("<"):
            self._reported(line)
        elif line.startswith("ALARM:"):
            self._alarmed(_figure(line))
        elif _BANNER.match(line):
            self._greeted()
        elif line and len(self._info) < 1000:
            self._info.append(line)
        self._news.set()

    def _answered(self, code: int) -> None:
        if not self._flight:
            if not (self._banner_due or self._recovering):
                self._fail(self._one_too_many())
            return  # otherwise an answer from before the reset
        sent = self._flight.popleft()
        self._used -= sent.size
        self._moved = self._now()
        if sent.answer is not None:
            if not sent.answer.done():
                sent.answer.set_result((code, list(self._info)))
            return
        if not self._checking:
            self.acknowledged += 1
            # The machine starts another move: request its position.
            self._glance = True
            self._wake.set()
        if code:
            refused = ControllerRejected(
                "controller.rejected-in-check" if self._checking else "controller.rejected-line",
                name=self.name,
                line=sent.number,
                text=_shown(sent.text),
                error=answers.error_meaning(code),
                code=code,
            )
            if self._checking:
                self._refusals.append(refused)
            else:
                self._fail(refused)

    def _reported(self, line: str) -> None:
        report = answers.report(line, self._rotary)
        if report is None:
            return
        if report.offset is not None:
            self._offset = report.offset
        if report.state is not State.ALARM:
            self.last_alarm = 0
        position = report.work
        located = report.work is not None or self._offset is not None
        if position is None and report.machine is not None:
            offset = self._offset or (0.0, 0.0, 0.0, 0.0)
            x, y, z, c = (m - o for m, o in zip(report.machine, offset, strict=True))
            position = x, y, z, c
        if position is None:
            position = self._status.position if self._status else (0.0, 0.0, 0.0, 0.0)
        self._heard = self._now()
        self._reports += 1
        self._status = Status(
            report.state,
            position,
            self.acknowledged,
            report.still,
            report.number,
            report.free,
            report.feed,
            self.sent,
            located,
        )
        if self.fault is not None or self._recovering:
            return
        self._count_bytes(report.room)
        if self.observer is not None:
            if (error := self.observer.observe(self._status)) is not None:
                self._fail(error)
            elif self.observer.doubtful:
                self._ask_again()

    def _count_bytes(self, room: int | None) -> None:
        """Fail if the controller reports more bytes in its buffer than are unanswered.

        A line leaves the buffer before it is answered, so the buffer may hold fewer bytes, never
        more.
        """
        if room is None or self._banner_due:
            return
        self._most_room = max(self._most_room, min(room, self._window + 1))
        if self._most_room - room <= self._used:
            self._contradictions = 0
            return
        self._contradictions += 1
        self._ask_again()
        if self._contradictions >= TWICE:
            self._fail(self._one_too_many())

    def _ask_again(self) -> None:
        self._doubt = True
        self._wake.set()

    def _one_too_many(self) -> ControllerError:
        return ControllerError("controller.unexpected-answer", name=self.name)

    def _alarmed(self, code: int) -> None:
        self.last_alarm = code
        if self._recovering and not self._flight:
            return  # it was reset while it still moved
        where = self._due() if code == 2 else None
        self._fail(
            ControllerAlarm(
                "controller.alarm",
                name=self.name,
                code=code,
                alarm=answers.alarm_meaning(code),
                due=where,
            )
        )

    def _greeted(self) -> None:
        self._banners += 1
        if self._banner_due:
            self._banner_due = False
            return
        if self._status is None or (self._recovering and not self._flight):
            return  # some controllers greet whoever connects; others were reset before
        self._fail(ControllerReset("controller.reset", name=self.name, due=self._due()))


async def dial(
    address: str,
    safe: SafeState | None = None,
    *,
    stop_motion: bool = False,
    silence: float = 5.0,
    poll: float = 0.1,
    unlock: bool = False,
) -> Grbl:
    """Connect to a grbl and take it over; see ``Grbl.open``.

    Raises
    ------
    ControllerError
        No answer, or it is busy or in alarm.
    """
    controller = Grbl(
        await connect(address),
        safe=safe,
        reconnect=lambda: connect(address),
        silence=silence,
        poll=poll,
    )
    try:
        await controller.open(unlock=unlock, stop_motion=stop_motion)
    except BaseException:
        await controller.close()
        raise
    return controller


def _figure(line: str) -> int:
    """Return the number in ``error:9`` or ``ALARM:2``; -1 if it is damaged."""
    code = line.partition(":")[2].strip()
    return int(code) if code.isdecimal() else -1


def _shown(line: bytes) -> str:
    return line.decode("ascii", "replace").strip()[:60]


def _dwell(line: bytes) -> float:
    match = _DWELL.search(line)
    return float(match[1]) if match else 0.0
