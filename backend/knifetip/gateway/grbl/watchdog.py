"""watchdog: requests status reports regularly, and detects silence and lost answers."""

from __future__ import annotations

import asyncio
import re
from contextlib import suppress
from typing import Protocol

from knifetip.errors import ControllerAlarm, ControllerError, ControllerSilent
from knifetip.gateway.controller import State, Status
from knifetip.gateway.grbl.polling import Polling
from knifetip.gateway.grbl.receive_buffer import ReceiveBuffer

#: Longest time in which an idle controller answers a line that only moves axes (s).
_PROMPT = 1.0
#: Reports of an idle machine that must follow the last answer before an answer counts as lost.
_IDLE_REPORTS = 5

#: Commands for which a controller may wait although it is idle: spindle, tool, coolant, pause.
_WAITS = re.compile(rb"M0?[013-9](?!\d)|^\$", re.IGNORECASE)
_DWELL = re.compile(rb"G0?4(?!\d)[^P]*P\s*(\d+\.?\d*)", re.IGNORECASE)


class WatchedConnection(Protocol):
    """The part of a connection to a controller that a watchdog uses."""

    buffer: ReceiveBuffer
    fault: ControllerError | None
    status: Status | None  #: last status report, None before the first one
    recovering: bool  #: the machine is being brought into its safe state
    checking: bool  #: the controller is in check mode, so nothing moves

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        ...

    async def request_report(self) -> None:
        """Send a status request; return before its report arrives."""
        ...

    def fail(self, error: ControllerError) -> ControllerError:
        """Record an error as the fault of the connection, and return the fault.

        If the connection already has a fault, that fault is kept and returned instead of ``error``.
        """
        ...

    def silence_error(self) -> ControllerSilent:
        """Return (not raise) a new error which states that the controller does not answer."""
        ...


class Watchdog:
    """Sends status requests at intervals on one connection, and records silence as a fault.

    Parameters
    ----------
    connection
        Connection to the controller.
    silence
        Seconds after which the controller counts as silent if no status report arrives, or if a
        line has no answer although the machine is idle.  For lines that only move axes, the second
        limit is at most ``_PROMPT``.
    polling
        Intervals between two status requests while the machine moves.  If the machine is idle and
        no line is unanswered, the interval is a fifth of ``silence``, but at least the usual one.
        The attribute may be changed at any time.
    """

    def __init__(self, connection: WatchedConnection, silence: float, polling: Polling) -> None:
        self._connection = connection
        self._silence = silence
        self.polling = polling
        self._wake = asyncio.Event()
        self._soon = False  # a line was answered: request a report soon
        self._at_once = False  # a report was doubtful: request another one at once
        # Time of the last report, in check mode also of an answer (s, clock of the event loop).
        self._last_sign = 0.0
        self._last_progress = 0.0  # last event that explains a missing answer (s, same clock)
        self._idle_reports = 0  # reports since then, all of an idle machine

    def restart(self) -> None:
        """Restart the time limits for the next status report and for the next answer to a line."""
        self._last_sign = _now()
        self._note_progress()

    def expect_answer(self) -> None:
        """Restart the time limit for an answer.

        Called when a line is sent while no other line is unanswered.
        """
        self._note_progress()
        self._wake.set()

    def note_answer(self) -> None:
        """Restart the time limit for an answer; called when a line was answered.

        In check mode, the time limit for a report restarts as well: nothing moves, and a controller
        that reads its line slowly answers a status request only after the lines before it.
        """
        self._note_progress()
        if self._connection.checking:
            self._last_sign = _now()

    @property
    def heard(self) -> float:
        """Time of the last sign that the controller responds (s, clock of the event loop)."""
        return self._last_sign

    def note_report(self) -> None:
        """Restart the time limit for a status report; called when a report was received."""
        self._last_sign = _now()
        status = self._connection.status
        if status is not None and status.state in (State.IDLE, State.CHECK):
            self._idle_reports += 1
        else:
            self._note_progress()

    def request_soon(self) -> None:
        """Make the running watchdog send a status request ``polling.soon`` after the last one.

        If that time has passed already, the request is sent at once.
        """
        self._soon = True
        self._wake.set()

    def request_at_once(self) -> None:
        """Make the running watchdog send the next status request without further delay."""
        self._at_once = True
        self._wake.set()

    async def run(self) -> None:
        """Request status reports and check the time limits until the connection is lost."""
        with suppress(ControllerError):
            while True:
                before, interval = _now(), self._interval()
                await self._pause()
                await self._connection.request_report()
                self._check_limits(before + interval)

    def _check_limits(self, expected: float) -> None:
        """Record a fault of the connection if a report or an answer is overdue.

        ``expected``: latest time at which this check should have been made (s, clock of the event
        loop).  If the check is later by more than half of ``silence``, this process was busy and
        did not read the answers; the time limits are then restarted, and silence is not recorded.
        """
        connection, now = self._connection, _now()
        status = connection.status
        if connection.fault is not None or status is None or connection.recovering:
            return
        if now > expected + self._silence / 2.0:
            # This process was busy and did not read the connection: it cannot detect silence.
            self.restart()
        first = connection.buffer.first
        if now - self._last_sign > self._silence:
            connection.fail(connection.silence_error())
        elif status.state is State.ALARM and (due := connection.buffer.due()):
            connection.fail(
                ControllerAlarm("controller.alarm-state", name=connection.name, due=due)
            )
        elif first is None:
            self._note_progress()
        elif self._is_answer_lost(first.text):
            connection.fail(
                ControllerSilent(
                    "controller.answer-lost",
                    name=connection.name,
                    state=status.state.value,
                    seconds=self._last_sign - self._last_progress,
                    due=connection.buffer.due(),
                )
            )

    def _is_answer_lost(self, line: bytes) -> bool:
        """Return whether the answer to a line was lost: an idle machine should have answered it.

        Only the time up to the last report counts, because a connection that stalls delays answers
        too.
        """
        limit = self._silence if _WAITS.search(line) else min(self._silence, _PROMPT)
        waited = self._last_sign - self._last_progress
        return self._idle_reports >= _IDLE_REPORTS and waited > limit + _dwell_seconds(line)

    def _note_progress(self) -> None:
        self._last_progress = _now()
        self._idle_reports = 0

    def _interval(self) -> float:
        """Return the longest time until the next status request is sent (s).

        The time is the usual one.  While the machine is idle and no line is unanswered, it is a
        fifth of ``silence`` if that is longer.
        """
        connection = self._connection
        idle = connection.status is not None and connection.status.state is State.IDLE
        if idle and connection.buffer.first is None and not connection.recovering:
            return max(self.polling.usual, self._silence / 5.0)
        return self.polling.usual

    async def _pause(self) -> None:
        """Wait until the next status request is due."""
        start = _now()
        while not self._at_once:
            due = start + (self.polling.soon if self._soon else self._interval())
            if (remaining := due - _now()) <= 0.0:
                break
            self._wake.clear()
            with suppress(TimeoutError):
                async with asyncio.timeout(remaining):
                    await self._wake.wait()
        self._soon = self._at_once = False


def _now() -> float:
    return asyncio.get_running_loop().time()


def _dwell_seconds(line: bytes) -> float:
    """Return the seconds for which a program line with G4 makes the machine dwell; 0 without G4."""
    match = _DWELL.search(line)
    return float(match[1]) if match else 0.0
