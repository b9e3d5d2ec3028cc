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

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import Observer, SafeState, State, Status
from knifetip.gateway.mcx314 import recovery
from knifetip.gateway.mcx314.connection import NO_PROGRAM, BoardConnection, RunningProgram
from knifetip.gateway.mcx314.frames import LONGEST
from knifetip.gateway.mcx314.instructions import AXES, BadLine, Name, parse
from knifetip.gateway.mcx314.interpreter import Mcx314Interpreter
from knifetip.gateway.mcx314.operating import Mcx314Operations
from knifetip.gateway.motion import Pose
from knifetip.gateway.program_blocks import lines_of

#: Program lines in one request, and the bytes that a request needs besides them.
_BATCH = 16
_MARGIN = 48
#: Time between two reports after one that deviates from the program (s).
_DOUBTFUL = 0.01
#: Pulses that a program states may differ by this from those of the board.
_EQUAL = 1e-5


class Mcx314(Mcx314Operations):
    """A board with an MCX314; the methods are those of ``ProgramController`` and ``Operable``.

    Parameters
    ----------
    address
        Address of the board, as for ``transport.connect``.
    safe
        Safe state into which ``open`` and ``stop`` bring the machine.  If None, they only end the
        running program.
    silence
        Seconds after which the board counts as silent if a request has no answer.
    poll
        Time between two reports while a program runs (s).
    """

    #: Moves that may be executed at the same time: the board reports the line that it executes.
    capacity: int | None = 1
    #: The board reports the pulses of the chip, whose lines and arcs deviate by two at most.
    accuracy: float = 0.1
    ahead: int = 0

    def __init__(
        self,
        address: str,
        *,
        safe: SafeState | None = None,
        silence: float = 1.5,
        poll: float = 0.05,
    ) -> None:
        self._connection = BoardConnection(address, silence)
        self._safe = safe
        self._poll = poll

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        return self._connection.name

    @property
    def fault(self) -> ControllerError | None:
        """First failure since the machine was last in its safe state; None if there is none."""
        return self._connection.fault

    @property
    def acknowledged(self) -> int:
        """Number of program lines that the board has begun since ``open``."""
        return 0 if self._connection.status is None else self._connection.status.acknowledged

    @property
    def sent(self) -> int:
        """Number of lines of the programs that were begun since ``open``."""
        return self._connection.sent

    @property
    def observer(self) -> Observer | None:
        """Object that compares each status report with the program; None if no program runs."""
        return self._connection.observer

    @observer.setter
    def observer(self, observer: Observer | None) -> None:
        self._connection.observer = observer

    def interpreter(self, start: Pose) -> Mcx314Interpreter:
        """Return an interpreter of the programs of this board, from a pose on."""
        return Mcx314Interpreter(self._connection.pulses, start)

    # -- opening and closing ----------------------------------------------------------------------

    async def open(self, *, stop_motion: bool = False) -> None:
        """Take control of the machine and bring it into its safe state.

        Parameters
        ----------
        stop_motion
            Whether to stop a machine that executes a program, because it is one of this gateway.
            If False, such a machine is left as it is, and an error is raised.

        Raises
        ------
        ControllerAlarm
            An alarm locks the board; nothing has moved.
        ControllerError
            The board is busy or does not answer, or refuses a step.
        """
        connection = self._connection
        await connection.open()
        status = await connection.report()
        connection.raise_fault()
        if status.state is State.IDLE and status.still:
            await self._secure()
        elif stop_motion:
            await self.stop()
        else:
            raise ControllerError("controller.busy", name=self.name, state=status.state.value)

    async def close(self) -> None:
        """Close the connection; the board itself ends a program that runs."""
        await self._connection.close()
        self._connection.fail(ControllerError("controller.closed", name=self.name))

    def lock(self, alarm: ControllerAlarm) -> None:
        """Record an alarm as the fault of the controller, until ``unlock`` or ``home``."""
        self._connection.fail(alarm)

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
            if instruction.name is Name.PULSES:
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
        answer = await self._guarded(f"BEGIN {lines}")
        number = int(answer.removeprefix("PROGRAM="))
        program = RunningProgram(number, connection.executed, lines)
        connection.sent += lines
        connection.program = program
        await self._load(text, program)
        while program.done < lines:
            await self._next_report()
        while (status := await self.status()).state is not State.IDLE or not status.still:
            await asyncio.sleep(self._poll)
        connection.executed, connection.program = program.before + lines, None
        # A program releases everything at its end; what is off already stays off.
        if self._safe is not None:
            for request in recovery.release_requests(self._safe):
                await self._guarded(request)
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
        answer = await self._guarded(f"LOAD {program.number} {first} {'|'.join(batch)}")
        return int(answer.removeprefix("FREE="))

    async def _guarded(self, request: str) -> str:
        """Send a request; record a failure as the fault."""
        try:
            return await self._connection.request(request)
        except ControllerError as error:
            # The reason why the board refuses is in its status.
            if isinstance(error, ControllerRejected) and not self._connection.recovering:
                await self._connection.report()
                if error.message.arguments.get("code") == NO_PROGRAM:
                    error = self._connection.discarded()
            raise self._connection.fail(error) from None

    async def _next_report(self) -> None:
        doubtful = self.observer is not None and self.observer.doubtful
        await asyncio.sleep(_DOUBTFUL if doubtful else self._poll)
        await self.status()

    async def status(self) -> Status:
        """Request a status report and return it.

        Raises
        ------
        ControllerError
            The fault of the controller, if it has failed before or now.
        """
        self._connection.raise_fault()
        status = await self._connection.report()
        self._connection.raise_fault()
        return status

    async def hold(self) -> None:
        """Decelerate to a stop from which ``resume`` can continue."""
        self._connection.raise_fault()
        await self._guarded("HOLD")

    async def resume(self) -> None:
        """Let the machine continue after a hold."""
        self._connection.raise_fault()
        await self._guarded("RESUME")

    async def stop(self) -> Status:
        """Discard the rest of the program and bring the machine into its safe state.

        Clears earlier failures; reconnects if the connection is lost.

        Returns
        -------
        Status
            Status of the machine at rest, after Z was raised to its safe height.

        Raises
        ------
        ControllerError
            An alarm locks the board, it refuses a step, or it cannot be reached.
        """
        connection = self._connection
        connection.recovering = True
        done = False
        try:
            status = await recovery.make_safe(connection, self._safe)
            done = True
            self._forget_switches()
        except ControllerError as unsafe:
            connection.fault = None  # the present fault matters more than the first one
            raise connection.fail(unsafe) from None
        finally:
            connection.recovering = False
            connection.program = None
            if not done:
                connection.fail(ControllerError("controller.not-recovered", name=self.name))
        connection.executed = connection.sent
        return status

    async def _secure(self) -> None:
        await recovery.secure(self._connection, self._safe)
        self._forget_switches()


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

    Parameters
    ----------
    address
        Address of the board, as for ``transport.connect``.
    safe
        Safe state of the machine; if None, the tool is not raised and no output is switched off.
    stop_motion
        Whether to stop a machine that executes a program, because it is one of this gateway.  If
        False, such a machine is left as it is, and an error is raised.
    silence
        Seconds after which the board counts as silent.
    poll
        Time between two reports while a program runs (s).

    Raises
    ------
    ControllerError
        The board does not answer or is busy.
    """
    controller = Mcx314(address, safe=safe, silence=silence, poll=poll)
    try:
        await controller.open(stop_motion=stop_motion)
    except ControllerAlarm as locked:
        controller.lock(locked)
    except BaseException:
        await controller.close()
        raise
    return controller
