"""connection: a connected board of an MCX314, its status reports and its fault."""

from __future__ import annotations

from collections.abc import Mapping
from contextlib import suppress
from dataclasses import dataclass

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected, ControllerReset
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.mcx314.instructions import AXES
from knifetip.gateway.mcx314.link import Link
from knifetip.gateway.motion import Pose
from knifetip.gateway.whole_program.connection import ProgramConnection
from knifetip.messages import Message

#: Seconds without a request after which the board stops a program by itself: more than ``WATCH``.
PATIENCE = 3.0

#: Code with which the board refuses lines of a program that it does not execute.
NO_PROGRAM = "program"

_STATES = {
    "IDLE": State.IDLE,
    "RUN": State.RUN,
    "HOLD": State.HOLD,
    "JOG": State.JOG,
    "HOME": State.HOME,
    "ALARM": State.ALARM,
}
_ALARMS = {
    "unhomed": "mcx314.alarm-unhomed",
    "emergency": "mcx314.alarm-emergency",
    "limit": "mcx314.alarm-limit",
    "drive": "mcx314.alarm-drive",
    "chip": "mcx314.alarm-chip",
}


@dataclass(slots=True)
class RunningProgram:
    """The program that the board executes."""

    number: int  #: number that the board has given it
    before: int  #: lines of earlier programs
    lines: int
    name: str = ""  #: as ``name_of``
    line: int = 0  #: line being executed, from 1; 0 if none was begun
    done: int = 0  #: lines executed


class BoardConnection(ProgramConnection[RunningProgram]):
    """A connection to a board, with its fault and its last status report.

    Parameters
    ----------
    address
        Address of the board.
    silence
        Seconds after which the board counts as silent.
    """

    rest_seconds = 15.0

    def __init__(self, address: str, silence: float) -> None:
        self.link = Link(address, silence)
        super().__init__(self.link, silence)
        self.fields: dict[str, str] = {}  #: of the last report
        self.pulses: Pose = (1.0, 1.0, 1.0, 1.0)  #: per mm and degree, as the board states
        self.queue = 0  #: program lines that the board holds
        self._boot = ""
        self._unbegun: RunningProgram | None = None  # aborted before its first line

    # -- opening and closing ----------------------------------------------------------------------

    async def open(self) -> None:
        """Connect to the board and read its settings; do nothing else.

        Raises
        ------
        ControllerError
            Nothing answers, or it is not a board with an MCX314.
        """
        await self.link.open()
        answer = await self.request("HELLO")
        fields = _fields_of(answer)
        try:
            self.pulses = _pose({letter: float(fields[letter]) for letter in AXES})
            self.queue = int(fields["QUEUE"])
            boot = fields["BOOT"]
        except (KeyError, ValueError):
            raise ControllerError("mcx314.unreadable", name=self.name, answer=answer) from None
        self._boot = boot
        self._start_watch("mcx314 watch")

    async def reach(self) -> None:
        """Clear the recorded fault; reconnect if the connection is lost.

        Raises
        ------
        ControllerError
            The board cannot be reached.
        """
        if not self.link.connected:
            await self.link.close()
            await self.open()
        else:
            self._boot = _fields_of(await self.request("HELLO")).get("BOOT", self._boot)
        self.fault = None

    async def guard(self, safe: SafeState | None) -> None:
        """Tell the board what to do if this gateway is gone while a program runs."""
        if safe is None:
            return
        lift = round(safe.lift * self.pulses[2])
        outputs = ",".join(map(str, safe.outputs)) or "-"
        await self.request(f"GUARD {lift} {PATIENCE * 1e3:.0f} {outputs}")

    # -- requests ---------------------------------------------------------------------------------

    async def request(self, text: str) -> str:
        """Send a request, and return what its answer states.

        Raises
        ------
        ControllerRejected
            The board refuses the request.
        ControllerError
            The connection is lost, or the board is silent.
        """
        result, _, rest = (await self.link.request(text)).partition(" ")
        if result != "OK":
            shown = text.split(" ", 1)[0] if text.startswith("LOAD") else text
            raise ControllerRejected(
                "mcx314.refused", name=self.name, request=shown, code=rest or result
            )
        return rest

    async def abort(self) -> None:
        """Decelerate to a stop and discard the program or the move.

        A program is held first: the board then begins no line, and reports whether it has begun
        one, which it forgets when it discards the program.
        """
        if self.program is not None:
            with suppress(ControllerRejected):
                await self.request("HOLD")
            fields = _fields_of(await self.request("STATUS"))
            name = f"{fields.get('BOOT')}/{fields.get('PROGRAM')}"
            if name == self.program.name and is_unbegun(fields):
                self._unbegun = self.program
        await self.request("ABORT")

    def has_not_begun(self, program: RunningProgram, rest: Status) -> bool:
        """Return whether the board has reported that it had begun no line of an aborted program."""
        del rest
        return self._unbegun is program

    async def report(self) -> Status:
        """Request a status report and return it.

        A failure that the report shows is recorded as the fault.

        Raises
        ------
        ControllerError
            The connection is lost, or the board is silent; this is recorded as the fault, too.
        """
        try:
            answer = await self.request("STATUS")
            fields = _fields_of(answer)
            try:
                status = self._status_of(fields)
            except (KeyError, ValueError):
                raise ControllerError("mcx314.unreadable", name=self.name, answer=answer) from None
        except ControllerError as error:
            raise self.fail(error) from None
        self.status, self.fields = status, fields
        if not self.recovering:
            self._check(status, fields)
        return status

    def _status_of(self, fields: dict[str, str]) -> Status:
        position = _pose(
            {
                letter: int(fields[letter]) / scale
                for letter, scale in zip(AXES, self.pulses, strict=True)
            }
        )
        program = self.program
        done, begun = self.executed, 0
        if program is not None:
            done = program.before
            if int(fields["PROGRAM"]) == program.number:
                program.line = max(program.line, int(fields["LINE"]))
                program.done = max(program.done, int(fields["DONE"]))
            begun = program.line
        alarm = fields["ALARM"]
        self.alarm = None if alarm == "-" else self._alarm_of(alarm)
        return Status(
            _STATES[fields["STATE"]],
            position,
            done + begun,
            fields["STILL"] == "1",
            free=1,
            sent=done + begun,
            located=alarm == "-",
        )

    def _alarm_of(self, alarm: str) -> Message:
        kind, _, axis = alarm.partition("-")
        code = _ALARMS.get(kind, "mcx314.alarm-other")
        arguments = {"axis": axis} if kind in ("limit", "drive") else {}
        if code == "mcx314.alarm-other":
            arguments = {"alarm": alarm}
        return Message(code, name=self.name, **arguments)

    def _check(self, status: Status, fields: dict[str, str]) -> None:
        """Record a fault if a report shows a reset, an alarm, or a position off the program."""
        program = self.program
        if fields["BOOT"] != self._boot:
            self.fail(ControllerReset("mcx314.reset", name=self.name))
        elif self.alarm is not None:
            self.fail(ControllerAlarm(self.alarm))
        elif program is not None and fields["LOST"] == "1":
            self.fail(ControllerError("mcx314.gave-up", name=self.name, seconds=PATIENCE))
        elif program is not None and int(fields["PROGRAM"]) != program.number:
            self.fail(self.discard_error())
        elif (
            self.observer is not None
            and program is not None
            and (error := self.observer.observe(status)) is not None
        ):
            self.fail(error)

    def name_of(self, number: int | str) -> str:
        """Return a name for the program with a number, which no other program of the board has."""
        return f"{self._boot}/{number}"

    def discard_error(self) -> ControllerError:
        """Return the error for a program that the board has discarded."""
        line = 0 if self.program is None else self.program.line
        return ControllerError("mcx314.stopped", name=self.name, line=line)

    def not_at_rest(self, seconds: float) -> ControllerError:
        """Return the error for a machine that is not at rest after some seconds."""
        return ControllerError("mcx314.not-at-rest", name=self.name, seconds=seconds)


def is_unbegun(fields: Mapping[str, str]) -> bool:
    """Return whether a report shows a held program of which certainly no line was begun.

    The first line of a program states its format, so a program that moves anything has executed a
    line before.
    """
    at_rest = fields.get("STATE") == "HOLD" and fields.get("STILL") == "1"
    return at_rest and fields.get("DONE") == "0" and fields.get("LINE") in ("0", "1")


def _fields_of(answer: str) -> dict[str, str]:
    """Return the values of the words ``KEY=VALUE`` in an answer."""
    return dict(word.split("=", 1) for word in answer.split(" ") if "=" in word)


def _pose(values: dict[str, float]) -> Pose:
    x, y, z, c = (values[letter] for letter in AXES)
    return x, y, z, c
