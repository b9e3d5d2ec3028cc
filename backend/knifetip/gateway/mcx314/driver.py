"""driver: runs programs on the board of an MCX314 (docs/mcx314-link.md).

The gateway loads program lines into the queue of the board, which executes them and reports which
line it executes.  Every failure raises an error: ``ControllerAlarm``, ``ControllerRejected`` (the
board refuses a line), ``ControllerReset``, ``ControllerSilent`` and ``ControllerError`` (the
connection is lost).  Afterwards ``stop`` brings the machine into its safe state (``recovery``).  If
the gateway itself is gone, the board does so after a few seconds.
"""

from __future__ import annotations

import asyncio
from collections.abc import Iterable

from knifetip.errors import ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.mcx314 import recovery
from knifetip.gateway.mcx314.connection import (
    NO_PROGRAM,
    BoardConnection,
    RunningProgram,
    is_unbegun,
)
from knifetip.gateway.mcx314.frames import LONGEST
from knifetip.gateway.mcx314.instructions import AXES, BadLine, InstructionName, parse
from knifetip.gateway.mcx314.interpreter import Mcx314Interpreter
from knifetip.gateway.mcx314.operating import Mcx314Operations
from knifetip.gateway.motion import Pose
from knifetip.gateway.program_blocks import lines_of
from knifetip.gateway.takeover import Found
from knifetip.gateway.whole_program.controller import take_control
from knifetip.gateway.whole_program.recovery import wait_until_still

#: Program lines in one request, and the bytes that a request needs besides them.
_BATCH = 16
_MARGIN = 48
#: Pulses that a program states may differ by this from those of the board.
_EQUAL = 1e-5


class Mcx314(Mcx314Operations):
    """A board with an MCX314; the methods are those of ``ProgramController`` and ``Operable``.

    The parameters are those of ``WholeProgramController``.
    """

    #: The board reports the pulses of the chip, whose lines and arcs deviate by two at most.
    accuracy: float = 0.1

    def interpreter(self, start: Pose) -> Mcx314Interpreter:
        """Return an interpreter of the programs of this board, from a pose on."""
        return Mcx314Interpreter(self._connection.pulses, start)

    async def _find_program(self, status: Status) -> Found | None:
        connection = self._connection
        if status.state is State.RUN:
            await connection.request("HOLD")
            await wait_until_still(connection)
        # The board forgets a program that it has given up.
        number, done = connection.fields["PROGRAM"], int(connection.fields["DONE"])
        if number == "0":
            return None
        begun = not is_unbegun(connection.fields)
        return Found(connection.name_of(number), executed=done, begun=begun)

    # -- programs ---------------------------------------------------------------------------------

    async def check(self, lines: Iterable[bytes]) -> None:
        """Check that each line is an instruction, and that the program is made for the board.

        Raises
        ------
        ControllerRejected
            It is not; nothing was sent.
        """
        number = 0
        for number, line in enumerate(lines, 1):
            try:
                instruction = parse(line.decode("latin-1"))
            except BadLine:
                text = line[:40].decode("latin-1")
                raise ControllerRejected("mcx314.unknown-line", line=number, text=text) from None
            if instruction.name is InstructionName.PULSES:
                stated = [instruction.words.get(letter, 0.0) for letter in AXES]
                pairs = zip(stated, self._connection.pulses, strict=True)
                if any(abs(one - other) > _EQUAL for one, other in pairs):
                    raise ControllerRejected("mcx314.pulses-of-board", name=self.name)
            if number % 1000 == 0:
                await asyncio.sleep(0)

    async def run(self, text: bytes) -> Status:
        """Run a program; return the status of the machine at rest after its end.

        Raises
        ------
        ControllerError
            The board refuses a line, or the machine has stopped before the end of the program.
        """
        connection = self._connection
        connection.raise_fault()
        lines = text.count(b"\n")
        answer = await self._send_or_record_fault(f"BEGIN {lines}")
        number = int(answer.removeprefix("PROGRAM="))
        name = connection.name_of(number)
        program = RunningProgram(number, connection.executed, lines, name)
        connection.sent += lines
        connection.program = program
        self._program_name = name
        await self._load(text, program)
        while program.done < lines:
            await self._next_report()
        while (status := await self.status()).state is not State.IDLE or not status.still:
            await asyncio.sleep(self._poll)
        connection.executed, connection.program = program.before + lines, None
        # A program releases everything at its end; what is off already stays off.
        if self._safe is not None:
            for request in recovery.release_requests(self._safe):
                await self._send_or_record_fault(request)
        return await self.status()

    async def _load(self, text: bytes, program: RunningProgram) -> None:
        """Load the lines of a program into the queue of the board as it has room for them."""
        free = self._connection.queue
        first, batch = 1, list[str]()
        size = 0
        for line in lines_of(text):
            shown = line.decode("latin-1")
            if shown.startswith(";"):
                shown = ";"  # a comment is no more than a line
            if batch and (len(batch) == _BATCH or size + len(shown) > LONGEST - _MARGIN):
                free = await self._load_batch(program, first, batch, free)
                first, batch, size = first + len(batch), [], 0
            batch.append(shown)
            size += len(shown) + 1
        await self._load_batch(program, first, batch, free)

    async def _load_batch(
        self, program: RunningProgram, first: int, batch: list[str], free: int
    ) -> int:
        """Load some lines; return how many more the board has room for."""
        while free < len(batch):
            await self._next_report()
            free = int(self._connection.fields.get("FREE", "0"))
        answer = await self._send_or_record_fault(
            f"LOAD {program.number} {first} {'|'.join(batch)}"
        )
        return int(answer.removeprefix("FREE="))

    async def _send_or_record_fault(self, request: str) -> str:
        """Send a request; record a failure as the fault."""
        try:
            return await self._connection.request(request)
        except ControllerError as error:
            # The reason why the board refuses is in its status.
            if isinstance(error, ControllerRejected) and not self._connection.recovering:
                await self._connection.report()
                if error.message.arguments.get("code") == NO_PROGRAM:
                    error = self._connection.discard_error()
            raise self._connection.fail(error) from None

    async def _next_report(self) -> None:
        await self._pause()
        await self.status()

    async def hold(self) -> None:
        """Decelerate to a stop from which ``resume`` can continue."""
        self._connection.raise_fault()
        await self._send_or_record_fault("HOLD")

    async def resume(self) -> None:
        """Let the machine continue after a hold."""
        self._connection.raise_fault()
        await self._send_or_record_fault("RESUME")

    async def _make_safe(self) -> Status:
        try:
            return await super()._make_safe()
        finally:
            self._connection.program = None  # the board discards it by itself if it is not reached


async def dial(
    address: str,
    safe: SafeState | None = None,
    *,
    stop_motion: bool = False,
    silence: float = 1.5,
    poll: float = 0.05,
) -> Mcx314:
    """Connect to a board, take control of it and bring its machine into the safe state.

    A board that an alarm locks is returned with this alarm as its ``fault``: a person at the
    machine can then call ``unlock`` or ``home``.

    The parameters are those of ``controller.Driver``, ``BoardConnection`` and ``Mcx314``.

    Raises
    ------
    ControllerError
        The board does not answer.
    """
    controller = Mcx314(BoardConnection(address, silence), safe, poll)
    return await take_control(controller, stop_motion=stop_motion)
