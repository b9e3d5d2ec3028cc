"""driver: runs programs on LinuxCNC through its remote shell, linuxcncrsh.

LinuxCNC runs whole program files.  The driver writes the file, lets LinuxCNC open and run it, and
follows it by reports of the position and of the program line.  The reported position is that of the
axes, without the work offset: it contains the offset of the tool.

Every failure raises an error: ``ControllerAlarm`` (emergency stop, machine off, not homed),
``ControllerRejected`` (an error message of LinuxCNC), ``ControllerSilent`` (no reply) and
``ControllerError`` (the connection is lost).  Afterwards ``stop`` brings the machine into its safe
state (``recovery``).  The reasons for this design are in docs/decisions/0071.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterable
from dataclasses import replace

from knifetip.errors import CheckRefused, ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.linuxcnc import ini_settings, recovery
from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection, RunningProgram
from knifetip.gateway.linuxcnc.operating import LinuxcncOperations
from knifetip.gateway.linuxcnc.program_folder import ProgramFolder
from knifetip.gateway.motion import Pose
from knifetip.gateway.operations import AXES
from knifetip.gateway.presupposed import PresupposedSettings
from knifetip.gateway.takeover import Found
from knifetip.gateway.travel import Excess, Travel
from knifetip.gateway.whole_program.controller import take_control
from knifetip.gateway.whole_program.recovery import wait_until_still
from knifetip.model.machine import Machine

#: Longest time until LinuxCNC begins a program (s).
_START = 2.0
#: Consecutive reports of rest after which a program has ended: an error message may come late.
_ENDED = 2


class Linuxcnc(LinuxcncOperations):
    """A LinuxCNC; the methods are those of ``ProgramController`` and ``Operable``.

    Parameters
    ----------
    connection
        Connection to the LinuxCNC; not open yet.
    folder
        Where programs are written for this LinuxCNC.
    safe, poll
        As for ``WholeProgramController``.
    """

    #: The reported positions are those of the joints, which lag behind the commanded ones.
    accuracy: float = 0.5

    def __init__(
        self,
        connection: LinuxcncConnection,
        folder: ProgramFolder,
        safe: SafeState | None,
        poll: float,
    ) -> None:
        super().__init__(connection, safe, poll)
        self._folder = folder
        #: lowest and highest positions of the axes in the INI file; None if it cannot be read
        self._limits: tuple[Pose, Pose] | None = None

    # -- opening and closing ----------------------------------------------------------------------

    async def _first_report(self) -> Status:
        # The first report cannot show whether an axis moves.
        await self._connection.report()
        await asyncio.sleep(self._poll)
        return await self._connection.report()

    async def _find_program(self, status: Status) -> Found | None:
        connection = self._connection
        path = await connection.shell.get("program")
        if status.state is State.IDLE:
            # A move by hand or by a single command would have changed the mode.
            alone = status.still and await connection.shell.get("mode") == "AUTO"
            return Found(path, rest=status.position if alone else None)
        if status.state not in (State.RUN, State.HOLD) or await connection.shell.get("mode") != (
            "AUTO"
        ):
            return None
        if status.state is State.RUN:
            await connection.shell.set("pause")
            await wait_until_still(connection)
        # The line is that of the present motion; at rest it remains so until the program goes on.
        line = connection.line_in(await connection.shell.get("program_line"))
        if await connection.shell.get("program_status") != "PAUSED":
            status = await connection.report()  # it has ended meanwhile
            return Found(path, rest=status.position if status.state is State.IDLE else None)
        return Found(path, executed=max(line - 1, 0))

    async def close(self) -> None:
        """Close the connection; LinuxCNC continues with what it does."""
        await super().close()
        self._folder.remove()

    async def _read_presupposed(self, machine: Machine) -> PresupposedSettings:
        """Read the units of the joints and the INI file."""
        found, unknown = await self._connection.read_settings()
        self._limits = None if unknown else ini_settings.limits_of(machine, found)
        return PresupposedSettings(ini_settings.requirements(machine, found), found, unknown)

    # -- programs ---------------------------------------------------------------------------------

    async def travel(self) -> Travel | None:
        """Return the travel in the INI file, with the present offset of programs.

        Returns None if the INI file cannot be read.
        """
        self._connection.raise_fault()
        if self._limits is None:
            return None
        return Travel(*self._limits, await self._connection.work_offset())

    def beyond_travel(self, excess: Excess) -> CheckRefused:
        """Return the error about a program that leaves the travel of LinuxCNC."""
        return CheckRefused(
            "linuxcnc.beyond-travel",
            name=self.name,
            line=excess.line,
            axis=AXES[excess.axis],
            position=excess.position,
            limit=excess.limit,
            unit="degrees" if excess.axis == AXES.index("C") else "mm",
        )

    async def check(self, lines: Iterable[bytes]) -> None:
        """Let LinuxCNC parse a program without motion (``run -1``).

        Raises
        ------
        ControllerRejected
            LinuxCNC refuses a line; nothing has moved.
        """
        connection = self._connection
        self._forget_switches()  # every program begins by switching everything off
        text = b"".join(line + b"\n" for line in lines)
        await self._open_program(text)
        connection.program = RunningProgram(connection.executed, 0, checking=True)
        try:
            await connection.shell.set("run -1")
            await self._wait_until_ended()
            cause = await connection.shell.cause()
        finally:
            connection.program = None
            # The interpreter is at the end of the program; abort takes it back to the machine.
            if connection.shell.connected:
                await connection.shell.set("abort")
        if cause is not None:
            raise ControllerRejected("linuxcnc.rejected-in-check", name=self.name, cause=cause)

    async def run(self, text: bytes) -> Status:
        """Run a program; return the status of the machine at rest after its end.

        Raises
        ------
        ControllerError
            LinuxCNC cannot open the program, or the machine has stopped before its end.
        """
        connection = self._connection
        await self._open_program(text)
        lines = text.count(b"\n")
        start, now = (await self.status()).position, asyncio.get_running_loop().time()
        program = RunningProgram(connection.executed, lines, start=start, seen=now)
        connection.sent += lines
        connection.program = program
        self._program_name = await connection.shell.get("program")
        await connection.shell.set("run")
        await self._wait_until_begun()
        await self._wait_until_ended()
        # Another client may have aborted it: only the place of rest shows that it was at its end.
        connection.executed, connection.program = program.before + program.line, None
        # A program releases everything at its end, but not if another client has aborted it there.
        if self._safe is not None:
            await connection.execute(recovery.release_lines(self._safe))
        status = await self.status()
        connection.executed = program.before + lines
        # Nothing is awaited from here on, so nobody sees the lines before the place was compared.
        return replace(status, acknowledged=connection.executed, sent=connection.executed)

    async def _open_program(self, text: bytes) -> None:
        """Write a program file and let LinuxCNC open it."""
        connection = self._connection
        connection.raise_fault()
        path = self._folder.write(text)
        await connection.shell.messages()  # about earlier commands
        await connection.shell.set("mode auto")
        await connection.shell.set(f"open {path}")
        cause = await connection.shell.cause()
        if cause is not None or await connection.shell.get("program") != path:
            raise ControllerError(
                "linuxcnc.program-not-opened", name=self.name, path=path, cause=cause
            )

    async def _wait_until_begun(self) -> None:
        clock = asyncio.get_running_loop()
        deadline = clock.time() + _START
        while (await self.status()).state is State.IDLE:
            if clock.time() > deadline:
                raise self._connection.fail(
                    ControllerError("linuxcnc.not-begun", name=self.name, seconds=_START)
                )
            await asyncio.sleep(self._poll)

    async def _wait_until_ended(self) -> None:
        idle = 0
        while idle < _ENDED:
            status = await self.status()
            idle = idle + 1 if status.state is State.IDLE else 0
            await self._pause()

    async def hold(self) -> None:
        """Decelerate to a stop from which ``resume`` or ``step`` can continue."""
        # A pause of an idle LinuxCNC would hold the next program.
        if (await self.status()).state is State.RUN:
            await self._connection.shell.set("pause")

    async def resume(self) -> None:
        """Let the machine continue after a hold."""
        if (await self.status()).state is State.HOLD:
            await self._connection.shell.set("resume")

    async def step(self) -> None:
        """Let the machine execute one program line after a hold, and hold again."""
        # A step of an idle LinuxCNC would begin the program again.
        if (await self.status()).state is State.HOLD and self._connection.program is not None:
            await self._connection.shell.set("step")


async def dial(
    address: str,
    safe: SafeState | None = None,
    *,
    stop_motion: bool = False,
    silence: float = 1.5,
    poll: float = 0.05,
) -> Linuxcnc:
    """Connect to a LinuxCNC, take control of it and bring its machine into the safe state.

    A LinuxCNC that is switched off, in emergency stop or not homed is returned with this alarm as
    its ``fault``: a person at the machine can then call ``unlock`` or ``home``.

    The parameters are those of ``controller.Driver``, ``LinuxcncConnection`` and ``Linuxcnc``.

    Raises
    ------
    ControllerError
        LinuxCNC does not answer.
    """
    place = LinuxcncAddress.parse(address)
    connection = LinuxcncConnection(place, silence, safe.heading_letter if safe else "C")
    controller = Linuxcnc(connection, ProgramFolder(place), safe, poll)
    return await take_control(controller, stop_motion=stop_motion)
