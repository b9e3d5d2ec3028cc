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

from knifetip.errors import ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.linuxcnc import recovery
from knifetip.gateway.linuxcnc.address import LinuxcncAddress
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection, RunningProgram
from knifetip.gateway.linuxcnc.operating import LinuxcncOperations
from knifetip.gateway.linuxcnc.program_folder import ProgramFolder
from knifetip.gateway.whole_program.controller import take_control

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

    # -- opening and closing ----------------------------------------------------------------------

    async def _first_report(self) -> Status:
        # The first report cannot show whether an axis moves.
        await self._connection.report()
        await asyncio.sleep(self._poll)
        return await self._connection.report()

    async def close(self) -> None:
        """Close the connection; LinuxCNC continues with what it does."""
        await super().close()
        self._folder.remove()

    # -- programs ---------------------------------------------------------------------------------

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
        program = RunningProgram(connection.executed, lines)
        connection.sent += lines
        connection.program = program
        await connection.shell.set("run")
        await self._wait_until_begun()
        await self._wait_until_ended()
        connection.executed, connection.program = program.before + lines, None
        # A program releases everything at its end, but not if another client has aborted it there.
        if self._safe is not None:
            await connection.execute(recovery.release_lines(self._safe))
        return await self.status()

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
        LinuxCNC does not answer or is busy.
    """
    place = LinuxcncAddress.of(address)
    connection = LinuxcncConnection(place, silence)
    controller = Linuxcnc(connection, ProgramFolder(place), safe, poll)
    return await take_control(controller, stop_motion=stop_motion)
