"""receiver: interpret the lines that a grbl controller sends, and record them in the exchange.

The controller sends ``ok`` and ``error`` for each line, ``ALARM``, status reports and its welcome
banner.  A line that contradicts the sent lines is recorded as a fault.
"""

from __future__ import annotations

import re

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerReset,
)
from knifetip.gateway.controller import State, Status
from knifetip.gateway.grbl import answers
from knifetip.gateway.grbl.exchange import Exchange
from knifetip.gateway.grbl.receive_buffer import Count
from knifetip.gateway.grbl.watchdog import Watchdog
from knifetip.gateway.interpreter import strip_comments
from knifetip.gateway.motion import Pose
from knifetip.gateway.transport import is_from_web_server

#: Maximum number of characters of an echoed line in a message.
_LONGEST_ECHO = 60
#: Maximum number of stored lines between two answers.
_MOST_LINES = 1000
#: Consecutive status reports that must show the same contradiction before it counts as a fault.
_CONTRADICTIONS = {Count.SURPLUS: 2, Count.MISSING: 3}

_BANNER = re.compile(r"grbl", re.IGNORECASE)
#: A line as the controller received it; sent before the answer if the firmware is built to echo.
_ECHO = re.compile(r"\[echo: ?(.*)\]")


class Receiver:
    """Interprets the received lines of one exchange, and reports them to the watchdog.

    Parameters
    ----------
    exchange
        Exchange with the controller, in which the results and faults are recorded.
    watchdog
        Watchdog of the same controller.
    """

    def __init__(self, exchange: Exchange, watchdog: Watchdog) -> None:
        self._exchange = exchange
        self._watchdog = watchdog
        self.web_server = False  #: a web server has answered, not a controller
        self.reports = 0  #: number of status reports received
        self.info: list[str] = []  #: lines received since the last command, except answers
        self.banners = 0  #: number of banners received
        self.banner_due = False  #: the controller is being reset
        self.was_reset = False  #: by this connection: earlier answers are of another sender
        self._override = 100  # feed override of the last report that contained one (%)
        self._offset: Pose | None = None  # work offset of the last report that contained one

    def receive(self, line: str) -> None:
        """Interpret a received line, without line end, and record the result."""
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
        elif line and len(self.info) < _MOST_LINES:
            self.info.append(line)
        self._exchange.note_change()

    def _handle_answer(self, code: int) -> None:
        """Assign an answer of the controller to the oldest unanswered line.

        If the answer refuses a program line, a fault of the connection is recorded; in check mode,
        the refusal is only stored in ``refusals``.  If no line is unanswered, a fault is recorded
        too, except during a reset or a recovery.

        ``code``: error code of the answer, 0 for ``ok``.
        """
        exchange = self._exchange
        if exchange.buffer.first is None:
            if self.was_reset and not (self.banner_due or exchange.recovering):
                exchange.fail(exchange.surplus_answer())
            return  # the answer is from before the reset
        line = exchange.buffer.remove_first()
        self._watchdog.note_answer()
        if line.answer is not None:
            if not line.answer.done():
                line.answer.set_result((code, list(self.info)))
            return
        if not exchange.checking:
            exchange.acknowledged += 1
            # The machine starts another move: request its position.
            self._watchdog.request_soon()
        if code:
            refused = ControllerRejected(
                "controller.rejected-in-check" if exchange.checking else "controller.rejected-line",
                name=exchange.name,
                line=line.number,
                text=line.excerpt,
                error=answers.error_meaning(code),
                code=code,
            )
            if exchange.checking:
                exchange.refusals.append(refused)
            else:
                exchange.fail(refused)

    def _handle_echo(self, text: str) -> None:
        """Compare a line as the controller received it with the line that was sent.

        The next answer belongs to this line, so it is the oldest unanswered one.  Some builds
        remove comments and blanks before they echo a line, and change it to capital letters.
        """
        exchange = self._exchange
        line = exchange.buffer.first
        if line is None or self.banner_due or exchange.recovering:
            return
        received = strip_comments(text.encode("ascii", "replace"))
        if received != strip_comments(line.text):
            exchange.fail(
                ControllerError(
                    "controller.line-changed",
                    name=exchange.name,
                    line=line.number,
                    sent=line.excerpt,
                    received=text[:_LONGEST_ECHO],
                )
            )

    def _handle_report(self, line: str) -> None:
        exchange = self._exchange
        report = answers.report(line, exchange.rotary)
        if report is None:
            return
        exchange.axes = report.axes or exchange.axes
        if report.offset is not None:
            self._offset = report.offset
        if report.override is not None:
            self._override = report.override
        if report.state is not State.ALARM:
            exchange.last_alarm = 0
        self.reports += 1
        exchange.status = self._status_of(report)
        self._watchdog.note_report()
        count, repeats = exchange.buffer.compare(report.free_bytes)
        if exchange.fault is not None or exchange.recovering:
            return
        self._check_count(count, repeats)
        if exchange.observer is not None:
            if (error := exchange.observer.observe(exchange.status)) is not None:
                exchange.fail(error)
            elif exchange.observer.doubtful:
                self._watchdog.request_at_once()

    def _status_of(self, report: answers.Report) -> Status:
        """Return the status that a report of grbl describes.

        If the report contains no position, the position of the previous status is used.
        """
        exchange = self._exchange
        position = report.work
        if position is None and report.machine is not None:
            offset = self._offset or (0.0, 0.0, 0.0, 0.0)
            x, y, z, c = (m - o for m, o in zip(report.machine, offset, strict=True))
            position = x, y, z, c
        if position is None:
            position = exchange.status.position if exchange.status else (0.0, 0.0, 0.0, 0.0)
        return Status(
            state=report.state,
            position=position,
            acknowledged=exchange.acknowledged,
            still=report.still,
            number=report.number,
            free=report.free,
            sent=exchange.sent,
            located=report.work is not None or self._offset is not None,
            pressed=report.pressed,
            hard_limits=exchange.hard_limits,
            door_open=report.door_open,
            override=self._override,
        )

    def _check_count(self, count: Count, repeats: int) -> None:
        """Record a fault if status reports contradict the number of bytes in the receive buffer.

        In check mode missing bytes are no fault: a lost answer is noticed when the check ends, and
        a controller that reads its line slowly may report later than a request counts as ignored.

        ``count``: result for the last report.
        ``repeats``: number of consecutive reports with this result.
        """
        lost = count is Count.MISSING
        if count is Count.POSSIBLE or self.banner_due or (lost and self._exchange.checking):
            return
        self._watchdog.request_at_once()
        if repeats >= _CONTRADICTIONS[count]:
            exchange = self._exchange
            exchange.fail(exchange.missing_answer() if lost else exchange.surplus_answer())

    def _handle_alarm(self, code: int) -> None:
        exchange = self._exchange
        exchange.last_alarm = code
        if exchange.recovering and exchange.buffer.first is None:
            return  # it was reset while it still moved
        exchange.fail(
            ControllerAlarm(
                "controller.alarm",
                name=exchange.name,
                code=code,
                alarm=answers.alarm_meaning(code),
                due=exchange.buffer.due() if code == answers.SOFT_LIMIT else None,
            )
        )

    def _handle_banner(self) -> None:
        exchange = self._exchange
        self.banners += 1
        if self.banner_due:
            self.banner_due = False
            return
        if exchange.status is None or (exchange.recovering and exchange.buffer.first is None):
            return  # some controllers send a banner to each client; others were reset before
        exchange.fail(
            ControllerReset("controller.reset", name=exchange.name, due=exchange.buffer.due())
        )


def _code(line: str) -> int:
    """Return the code in an answer, such as 9 for ``error:9``; -1 if the code is not a number."""
    code = line.partition(":")[2].strip()
    return int(code) if code.isdecimal() else -1
