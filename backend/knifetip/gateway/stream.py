"""stream: a program to a controller, and how far the machine has come.

    stream(program: Program | bytes, controller: Controller) -> AsyncIterator[Progress]

The consumer holds and resumes on the controller itself.  Closing the iterator before its end is
the cancel: the machine holds, is reset, and Z is raised.  So an exception in the consumer, or
the end of the process's event loop, stops the machine too; use ``contextlib.aclosing``.

The bytes go out unaltered, one thing is added between them: a line that switches an output waits
until the machine is at rest.

Memory does not grow with the length of the program beyond its bytes.
"""

from __future__ import annotations

import asyncio
import math
from collections.abc import AsyncGenerator
from contextlib import suppress
from dataclasses import dataclass

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
    ControllerSilent,
)
from knifetip.gateway.controller import Controller, State, Status
from knifetip.gateway.executed import Executed, blocks_of, lines_of, seconds_of
from knifetip.gateway.interpreter import switches
from knifetip.gateway.motion import Limits, Pose
from knifetip.model.program import Program

#: Lines read ahead of giving other work its turn.
TURN = 500
#: Seconds between two looks at a machine that should come to rest.
REST = 0.01
#: Nominal seconds after which the real pace is believed.
PACE = 1.0
#: What is taken for the axes where nobody says: 1 m/s, 5 m/s², two turns a second.
TYPICAL = Limits(
    (1000.0, 1000.0, 200.0, 720.0),
    (5000.0, 5000.0, 2000.0, 7200.0),
    (-math.inf,) * 4,
    (math.inf,) * 4,
)


@dataclass(frozen=True, slots=True)
class Progress:
    """Where the machine is in a program."""

    executed: int  #: lines done; the machine is at the next one
    acknowledged: int  #: lines answered by the controller
    lines: int  #: of the program
    position: Pose  #: X, Y, Z, C in the program's numbers
    state: State
    output: int  #: digital output last switched on (the station in use), -1 before any
    seconds_left: float | None  #: at the pace so far, holds not counted


async def stream(
    program: Program | bytes,
    controller: Controller,
    *,
    limits: Limits = TYPICAL,
    lift: float | None = None,
    check: bool = True,
    interval: float = 0.1,
) -> AsyncGenerator[Progress, None]:
    """Run a program, and say every ``interval`` seconds how far the machine is.

    Parameters
    ----------
    program
        The bytes, which go out unaltered.
    controller
        Open and idle.
    limits
        Of the machine, for the time that is left.
    lift
        Z in the program's numbers to raise the tool to after a stop.
    check
        Have the controller read the whole program first, without moving.

    Yields
    ------
    Progress
        The last one has executed every line.

    Raises
    ------
    ControllerError
        The controller is not idle, refused a line, alarmed, was reset, fell silent, or is gone.
        After a refused line or a lost answer the machine has been stopped and raised.
    ProgramError
        The program holds bytes that would act on the controller.
    """
    text = program.text if isinstance(program, Program) else program
    status = await controller.status()
    if status.state is not State.IDLE:
        raise ControllerError(
            f"{controller.name} is not ready: it says {status.state.value}.",
            "Let it come to rest, or unlock it, then send the job again; nothing was sent.",
        )
    lines, total = await _measure(text, limits, status.position)
    following = Executed(text, limits, status.position)
    clock = _Clock(total)
    base = status.acknowledged
    feeding = asyncio.create_task(_feed(text, controller, check), name="feed")
    over = False
    try:
        while True:
            fed = feeding.done()
            if fed:
                feeding.result()
            status = await controller.status()
            if status.state is State.ALARM:
                raise controller.fault or ControllerAlarm(
                    f"{controller.name} says alarm.", "Look at the table, then home or unlock it."
                )
            answered = status.acknowledged - base
            if fed and status.state is State.IDLE and answered >= lines:
                over = True
                following.finish(lines)
                yield _progress(following, status, lines, lines, 0.0)
                return
            if status.state is not State.CHECK:
                following.update(status, answered, controller.capacity)
            yield _progress(
                following, status, answered, lines, clock.left(following.seconds_done, status)
            )
            await asyncio.sleep(interval)
    except ControllerError as error:
        # A line refused in check mode has moved nothing, and leaves no fault behind; a machine
        # that was reset, alarmed or lost is not commanded any more.
        settles = isinstance(error, ControllerRejected | ControllerSilent)
        over = not (settles and controller.fault is error)
        raise
    finally:
        await _given_up(feeding)
        if not over:
            with suppress(ControllerError):
                await controller.stop(lift)


async def _measure(text: bytes, limits: Limits, start: Pose) -> tuple[int, float]:
    """Return the number of lines and their nominal seconds, letting other work go on."""
    lines, total = 0, 0.0
    for block in blocks_of(text, start):
        lines += 1
        total += seconds_of(block, limits)
        if lines % TURN == 0:
            await asyncio.sleep(0)
    return lines, total


async def _feed(text: bytes, controller: Controller, check: bool) -> None:
    if check:
        await controller.check(lines_of(text))
    for number, line in enumerate(lines_of(text), 1):
        if switches(line):
            # grblHAL lowers or raises a station when it reads M64 or M65, whatever still moves.
            await _come_to_rest(controller)
        await controller.send(line, number)
    await controller.drain()


async def _come_to_rest(controller: Controller) -> None:
    """Wait until everything that was sent has been carried out."""
    await controller.drain()
    idle = 0
    # Once is not enough: a planner may have taken a move and not yet begun it.
    while idle < 2:
        idle = idle + 1 if (await controller.status()).state is State.IDLE else 0
        if not idle:
            await asyncio.sleep(REST)


async def _given_up(task: asyncio.Task[None]) -> None:
    """End the feeding and swallow how it ended: whoever needed that has it already."""
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


def _progress(
    following: Executed, status: Status, answered: int, lines: int, left: float | None
) -> Progress:
    return Progress(
        following.lines,
        answered,
        lines,
        status.position,
        status.state,
        following.output,
        left,
    )


class _Clock:
    """Turns nominal seconds into the seconds that this machine takes."""

    def __init__(self, total: float) -> None:
        self._total = total
        self._running = 0.0
        self._last: float | None = None

    def left(self, done: float, status: Status) -> float:
        """Return the seconds still to go after ``done`` nominal ones."""
        now = asyncio.get_running_loop().time()
        if self._last is not None and status.state is State.RUN:
            self._running += now - self._last
        self._last = now
        pace = self._running / done if done > PACE and self._running > 0.0 else 1.0
        return max(self._total - done, 0.0) * pace
