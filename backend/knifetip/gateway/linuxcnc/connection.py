"""connection: a connected LinuxCNC, its status reports and its fault.

A report is composed of several variables, which are requested one after another.  The position is
requested before the program line, so it never lies on a line after the reported one.

The shell answers from its own copy of the status.  It does so even after the task controller of
LinuxCNC has died.  If nothing changes while a program runs, a harmless command is therefore sent,
which only the task controller can confirm.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from contextlib import suppress
from dataclasses import dataclass
from pathlib import Path

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import State, Status
from knifetip.gateway.linuxcnc import ini_settings
from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.linuxcnc.remote_shell import RemoteShell
from knifetip.gateway.motion import Pose
from knifetip.gateway.whole_program.connection import ProgramConnection
from knifetip.messages import Message

#: Time without any change after which the task controller must confirm a command (s).
_UNCHANGED = 0.5
#: Letters of the axes in the positions of linuxcncrsh.
_ORDER = "XYZABCUVW"
#: Least time between two positions that are compared (s); LinuxCNC updates them every 1 ms.
_APART = 0.01
#: Time for which a position off the path is not counted again if it has not changed (s).
#:
#: The task controller copies the line into its status one cycle before the position.  If a cycle is
#: late, on a computer with other work, the position is ahead of the line until the next one.
_SAME = 1.0
#: Change of a position that counts as motion (mm or degrees): positions have 6 decimals.
_MOTION = 2e-6


#: Time between two reports in which no program leaves its start and comes back to it (s).
_WATCHED = 0.5


@dataclass(slots=True)
class RunningProgram:
    """The program that LinuxCNC executes or checks."""

    before: int  #: lines of earlier programs
    lines: int
    checking: bool = False  #: LinuxCNC only parses it
    line: int = 0  #: line being executed, from 1; 0 if it is not known
    first: int | None = None  #: line in the first report of the running program
    start: Pose | None = None  #: position before the program; None if not known
    seen: float = 0.0  #: time of the last report
    watched: bool = True  #: reports were never apart long enough for a motion out and back

    def observe(self, position: Pose, now: float) -> None:
        """Store whether a report at a time (s) excludes that an axis has moved."""
        if now - self.seen > _WATCHED or self.start is None or not _is_near(self.start, position):
            self.watched = False
        self.seen = now

    def update(self, line: int) -> None:
        """Store the line of a report of the running program.

        Until LinuxCNC executes its first line, it reports a line of the last program.  A line is
        therefore not known before it differs from the first report.
        """
        if self.first is None:
            self.first = line
        if self.line > 0 or line != self.first:
            self.line = min(line, self.lines)


class LinuxcncConnection(ProgramConnection[RunningProgram]):
    """A connection to LinuxCNC, with its fault and its last status report.

    Parameters
    ----------
    address
        Address of the LinuxCNC.
    silence
        Seconds after which LinuxCNC counts as silent if a request has no reply.
    heading_letter
        Letter of the axis that rotates the tool: A, B or C; empty if there is none.
    """

    rest_seconds = 5.0

    def __init__(self, address: LinuxcncAddress, silence: float, heading_letter: str = "C") -> None:
        self.shell = RemoteShell(address, silence)
        super().__init__(self.shell, silence)
        self._address = address
        self._joints = address.joints
        self.heading_letter = heading_letter
        self._changed = 0.0
        self._reference: tuple[float, Pose] | None = None  # time and position of an earlier report
        self._still = False
        self._observed: tuple[float, Pose] | None = None  # time and position last compared

    # -- opening and closing ----------------------------------------------------------------------

    async def open(self) -> None:
        """Connect to LinuxCNC; do nothing else."""
        await self.shell.open()
        await self.shell.messages()  # of earlier programs
        self._start_watch("linuxcnc watch")

    async def reach(self) -> None:
        """Clear the recorded fault; reconnect if the connection is lost.

        Raises
        ------
        ControllerError
            LinuxCNC cannot be reached.
        """
        if self.shell.connected:
            with suppress(ControllerError):  # the connection may be lost without having closed
                await self.shell.enable()  # another client may have taken the permission
        if not self.shell.connected:
            await self.open()
        await self.shell.messages()
        self.fault = None

    async def read_settings(self) -> tuple[dict[str, str], tuple[Message, ...]]:
        """Return the units of the joints with the entries of the INI file, and what is unknown.

        Raises
        ------
        ControllerError
            The connection is lost, or LinuxCNC is silent.
        """
        found = ini_settings.unit_settings(await self.shell.get("joint_units"), self._joints)
        reported = await self.shell.get("inifile")
        # A path that LinuxCNC reports is of another computer if its folders are mounted elsewhere.
        path = self._address.ini or ("" if self._address.remote else reported)
        try:
            text = await asyncio.to_thread(Path(path).read_text, errors="replace")
        except OSError:
            return found, (Message("linuxcnc.ini-unread", name=self.name, path=reported),)
        return found | ini_settings.read(text.splitlines()), ()

    # -- status reports ---------------------------------------------------------------------------

    async def report(self) -> Status:
        """Request a status report and return it.

        A failure that the report shows is recorded as the fault.

        Raises
        ------
        ControllerError
            The connection is lost, or LinuxCNC is silent; this is recorded as the fault, too.
        """
        try:
            status = await self._read_status()
            if status.state is State.RUN:
                await self._require_task_controller(status)
            # Messages about other commands are read where the command was sent.
            runs = self.program is not None and not self.program.checking
            messages = await self.shell.messages() if runs else []
        except ControllerError as error:
            raise self.fail(error) from None
        self.status = status
        if not self.recovering:
            self._check(status, messages)
        return status

    async def _read_status(self) -> Status:
        get, program = self.shell.get, self.program
        activity = await get("program_status")
        position = self._pose_in(await get("rel_act_pos"))
        if program is not None:
            program.observe(position, asyncio.get_running_loop().time())
            if activity != "IDLE":
                program.update(self.line_in(await get("program_line")))
        self.alarm = await self._read_alarm()
        still = self._compare(position)
        if self.alarm is not None:
            state = State.ALARM
        elif activity == "PAUSED":
            state = State.HOLD
        elif activity == "RUNNING":
            state = State.CHECK if self._checks() else State.RUN
            if program is None and await get("mode") != "AUTO":
                state = State.JOG
        else:
            state = State.IDLE if still else State.JOG
        done = self.executed if program is None or program.checking else program.before
        begun = 0 if program is None or program.checking else program.line
        located = program is None or program.checking or program.line > 0
        return Status(
            state,
            position,
            done + begun,
            still,
            free=1,
            sent=done + begun,
            located=located,
            override=self.line_in(await get("feed_override")),
        )

    async def work_offset(self) -> Pose:
        """Return what is added to coordinates of programs to get those of the machine, at rest.

        Raises
        ------
        ControllerError
            The connection is lost, or LinuxCNC is silent; this is recorded as the fault, too.
        """
        try:
            machine = self._pose_in(await self.shell.get("abs_act_pos"))
            program = self._pose_in(await self.shell.get("rel_act_pos"))
        except ControllerError as error:
            raise self.fail(error) from None
        x, y, z, c = (one - other for one, other in zip(machine, program, strict=True))
        return x, y, z, c

    def _pose_in(self, reply: str) -> Pose:
        """Return the position in a reply, or raise ``ControllerError`` if the reply is garbled."""
        values = reply.split()
        try:
            x, y, z = (float(value) for value in values[:3])
            c = float(values[_ORDER.index(self.heading_letter)]) if self.heading_letter else 0.0
        except (IndexError, ValueError):
            raise ControllerError("linuxcnc.unreadable", name=self.name, reply=reply) from None
        return x, y, z, c

    def line_in(self, reply: str) -> int:
        """Return the number in a reply, or raise ``ControllerError`` if the reply is garbled."""
        try:
            return int(reply)
        except ValueError:
            raise ControllerError("linuxcnc.unreadable", name=self.name, reply=reply) from None

    def _compare(self, position: Pose) -> bool:
        """Return whether no axis has moved since an earlier report, at least ``_APART`` ago."""
        now = asyncio.get_running_loop().time()
        if self._reference is None:
            self._reference = now, position
        elif now - self._reference[0] >= _APART:
            self._still = _is_near(self._reference[1], position)
            self._reference = now, position
        return self._still

    async def _read_alarm(self) -> Message | None:
        """Return why LinuxCNC cannot move the machine; None if it can."""
        get = self.shell.get
        power = await get("machine")
        # Requested last: an emergency stop between the two requests is not a mere "off".
        if await get("estop") != "OFF":
            return Message("linuxcnc.estop", name=self.name)
        if power != "ON":
            return Message("linuxcnc.machine-off", name=self.name)
        homed = (await get("joint_homed")).split()[: self._joints]
        missing = [str(joint) for joint, word in enumerate(homed) if word != "YES"]
        return Message("linuxcnc.not-homed", name=self.name, joints=missing) if missing else None

    async def _require_task_controller(self, status: Status) -> None:
        """Raise ``ControllerSilent`` if nothing changes because the task controller has died."""
        now = asyncio.get_running_loop().time()
        last = self.status
        if last is None or not status.still or last.acknowledged != status.acknowledged:
            self._changed = now
        elif now - self._changed > _UNCHANGED:
            self._changed = now
            await self.confirm()

    async def confirm(self) -> None:
        """Let the task controller confirm a command without effect, in a later cycle.

        Raises
        ------
        ControllerError
            The connection is lost, or the task controller is silent.
        """
        await self.shell.set(f"optional_stop {await self.shell.get('optional_stop')}")

    def _checks(self) -> bool:
        return self.program is not None and self.program.checking

    def _check(self, status: Status, messages: list[str]) -> None:
        """Record a fault if a report shows an alarm, an error, or a position off the program."""
        if self.alarm is not None:
            self.fail(ControllerAlarm(self.alarm))
        elif messages and self.program is not None:
            cause = Message("linuxcnc.cause", texts=messages)
            self.fail(
                ControllerRejected(
                    "linuxcnc.stopped", name=self.name, line=self.program.line, cause=cause
                )
            )
        elif (
            self.observer is not None
            and self.program is not None
            and not self._is_same(status)
            and (error := self.observer.observe(status)) is not None
        ):
            self.fail(error)

    def _is_same(self, status: Status) -> bool:
        """Return whether the position was compared with the program already, and is not old."""
        now = asyncio.get_running_loop().time()
        if self._observed is not None:
            since, position = self._observed
            if position == status.position and now - since < _SAME:
                return True
        self._observed = now, status.position
        return False

    def not_at_rest(self, seconds: float) -> ControllerError:
        """Return the error for a machine that is not at rest after some seconds."""
        return ControllerError("linuxcnc.not-at-rest", name=self.name, seconds=seconds)

    # -- single commands --------------------------------------------------------------------------

    async def abort(self) -> None:
        """Stop the motion and the spindle, and discard the program."""
        with suppress(ControllerRejected):  # while the machine is off
            await self.shell.set("abort")
        if self.program is not None and self.status is not None:
            self.program.observe(self.status.position, asyncio.get_running_loop().time())

    def has_not_begun(self, program: RunningProgram, rest: Status) -> bool:
        """Return whether an aborted program has left neither its start nor the first line 0."""
        at_start = program.start is not None and _is_near(program.start, rest.position)
        return at_start and program.watched and program.line == 0

    async def execute(self, lines: Iterable[str], patience: float = 0.0) -> None:
        """Execute lines of G-code (MDI) one after another; return when the machine is at rest.

        Parameters
        ----------
        lines
            The lines.  If LinuxCNC refuses one of them, the others are still executed.
        patience
            Time until the end of the motion of a line (s), in addition to the limit of silence.

        Raises
        ------
        ControllerRejected
            LinuxCNC refuses lines.
        ControllerError
            The connection is lost, LinuxCNC is silent, or a motion has not ended in time.
        """
        refusals = []
        await self.shell.messages()  # about earlier commands
        await self.shell.set("mode mdi")
        await self.shell.set("set_wait done")
        try:
            for line in lines:
                try:
                    await self.shell.set(f"mdi {line}", self.silence + patience)
                except ControllerRejected as refused:
                    refusals.append(refused.message)
        finally:
            if self.shell.connected:
                await self.shell.set("set_wait received")
        if refusals:
            raise ControllerRejected("controller.refused-safe-state", refusals=refusals)


def _is_near(first: Pose, second: Pose) -> bool:
    return all(abs(a - b) <= _MOTION for a, b in zip(first, second, strict=True))
