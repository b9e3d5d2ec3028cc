"""stream: send a program to a controller, and report the progress of the machine.

    stream(program: Program | bytes, controller: Controller) -> AsyncIterator[Progress]

To hold or resume the machine, call ``hold`` or ``resume`` of the controller.  If the iterator is
closed early, the machine is stopped and brought into its safe state.  For this to happen also after
an exception in the code that uses the iterator, wrap the iterator in ``contextlib.aclosing``.

The bytes are sent unaltered.  A line that switches an output is sent when the machine is at rest.
Memory does not grow with the length of the program, except for its bytes and the durations of its
lines.
"""

from __future__ import annotations

import asyncio
import logging
import math
from collections.abc import AsyncGenerator, Awaitable, Callable, Mapping
from dataclasses import dataclass
from typing import Final

from knifetip.errors import (
    CheckRefused,
    ControllerAlarm,
    ControllerError,
    ControllerRejected,
)
from knifetip.gateway.controller import (
    Controller,
    InterpretingController,
    LimitedController,
    LineController,
    ProgramController,
    State,
    Status,
)
from knifetip.gateway.corridor import Corridor
from knifetip.gateway.interpreter import Interpreter, LineInterpreter, switches_output
from knifetip.gateway.motion import Limits, Pose
from knifetip.gateway.program_blocks import ProgramBlocks, lines_of
from knifetip.gateway.program_follower import ProgramFollower
from knifetip.gateway.time_left import TimeLeft
from knifetip.gateway.travel import find_excess
from knifetip.messages import Message
from knifetip.model.program import Program

#: Longest time until a check run has ended after a failure of the controller (s).
_CHECK_END = 0.5
#: Default limits of the axes: 1 m/s, 5 m/s², two turns per second.
TYPICAL = Limits(
    (1000.0, 1000.0, 200.0, 720.0),
    (5000.0, 5000.0, 2000.0, 7200.0),
    (-math.inf,) * 4,
    (math.inf,) * 4,
)

#: Number of lines that are announced together before they are sent.
_AHEAD = 64
#: States in which a controller executes no program: it never goes on by itself, nor with a resume.
_NO_PROGRAM = frozenset({State.CHECK, State.SLEEP, State.TOOL})

_log = logging.getLogger(__name__)


@dataclass(frozen=True, slots=True)
class Progress:
    """Progress of the machine in the program that it executes, at the time of a status report."""

    executed: int  #: executed lines; the machine is at the next one
    acknowledged: int  #: lines answered by the controller
    lines: int  #: number of lines of the program
    position: Pose  #: X, Y, Z, C in work coordinates
    state: State
    output: int  #: digital output last switched on (the station in use), -1 for none
    #: estimated by ``TimeLeft``, without holds (s); None if unknown
    seconds_left: float | None
    located: bool = True  #: the position is known
    awaits_end: bool = False  #: a person must confirm the end of the program: see ``Status``
    door_open: bool = False  #: the safety door is open

    @property
    def held(self) -> bool:
        """Whether the machine is held, by a feed hold or by its safety door."""
        return self.state in (State.HOLD, State.DOOR)

    @property
    def resumable(self) -> bool:
        """Whether the machine is held and would continue at once; not with an open door."""
        return self.held and not self.door_open


@dataclass(frozen=True, slots=True)
class StreamHooks:
    """Functions that are called while a program runs; None for no call."""

    #: called after the check run, before the first line is sent; an error of it ends the run, of
    #: which nothing was executed
    begin: Callable[[], Awaitable[None]] | None = None
    #: called before lines are sent to a ``LineController``, with the number of the last line that
    #: is sent before the next call
    sending: Callable[[int], None] | None = None


_NO_HOOKS: Final = StreamHooks()


async def stream(
    program: Program | bytes,
    controller: Controller,
    *,
    limits: Limits = TYPICAL,
    tools: Mapping[int, Pose] | None = None,
    check: bool = True,
    interval: float = 0.1,
    time_left: TimeLeft | None = None,
    hooks: StreamHooks = _NO_HOOKS,
) -> AsyncGenerator[Progress, None]:
    """Run a program; yield the progress every ``interval`` seconds.

    Parameters
    ----------
    program
        Program, sent unaltered.
    controller
        Open and idle controller.
    limits
        Limits of the axes, to estimate the remaining time.
    tools
        Offset of each tool in the tool table of the controller, by its number; None for a
        controller without tool table.
    check
        Whether the controller first parses the whole program without motion.
    interval
        Time between two progress reports (s).
    time_left
        Estimates the remaining time; that of the copies before this one, so that it has learned
        from them.  None for an estimate from the limits of the axes.
    hooks
        Functions that are called before lines are sent.

    Yields
    ------
    Progress
        Progress of the machine; in the last one, every line is executed.

    Raises
    ------
    CheckRefused
        The controller refused the program in its check run, or the program leaves its travel;
        nothing was executed.
    ControllerError
        The controller is not idle, refused a line, is in alarm, was reset, does not answer, lost
        the connection, or left the path of the program.  The message states how many lines may have
        been executed.  The machine has been brought into its safe state, or the message states
        why not.
    ProgramError
        The program contains bytes that the controller would execute as realtime commands.
    """
    text = program.text if isinstance(program, Program) else program
    status = await controller.status()
    if status.state is not State.IDLE:
        raise ControllerError(
            "controller.not-ready", name=controller.name, state=status.state.value
        )

    def interpreter() -> LineInterpreter:
        if isinstance(controller, InterpretingController):
            return controller.interpreter(status.position)
        return Interpreter(status.position, tools)

    blocks = ProgramBlocks(text, interpreter)
    durations = await blocks.measure(limits)
    if isinstance(controller, LimitedController):
        await _require_travel(controller, blocks)
    lines = len(durations)
    followed, expected = blocks.readers()
    follower = ProgramFollower(followed, durations, controller.ahead)
    corridor = Corridor(
        expected, status, controller.capacity, off=controller.accuracy, ahead=controller.ahead
    )
    time_left = TimeLeft() if time_left is None else time_left
    time_left.begin(sum(durations))
    base = status
    controller.observer = corridor
    feeding = asyncio.create_task(_feed(text, controller, corridor, check, hooks), name="feed")
    try:
        while True:
            status = await controller.status()
            if feeding.done():
                feeding.result()
                break
            _check_state(controller, status, base)
            answered = status.acknowledged - base.acknowledged
            if status.state is not State.CHECK:
                follower.update(status, answered, controller.capacity)
            now = asyncio.get_running_loop().time()
            left = time_left.update(follower.seconds_done, status.state, now, status.override)
            yield _progress(follower, status, answered, lines, left)
            # Not longer than the program: a gateway that is killed before it has recorded the end
            # cannot know it.
            await asyncio.wait({feeding}, timeout=interval)
    except ControllerError as found:
        error = found
        if controller.sent == base.sent:
            # The check run may state what the controller has found in it.
            await asyncio.wait({feeding}, timeout=_CHECK_END)
            if feeding.done() and isinstance(refused := feeding.exception(), CheckRefused):
                error = refused
        await _give_up(feeding)
        if controller.fault is None and controller.sent == base.sent:
            raise  # refused in check mode: nothing has moved
        raise await _stop(controller, error, follower, base, lines) from error
    except BaseException as ended:
        await _give_up(feeding)
        try:
            await _make_safe(controller)
        except ControllerError as unsafe:
            if isinstance(ended, asyncio.CancelledError):
                _log.error("%s", unsafe)
            else:
                raise
        raise
    controller.observer = None
    time_left.end()
    follower.finish(lines)
    yield _progress(follower, status, lines, lines, 0.0)


async def _require_travel(controller: LimitedController, blocks: ProgramBlocks) -> None:
    """Raise ``CheckRefused`` if a program leaves the travel of its controller."""
    travel = await controller.travel()
    if travel is None:
        return
    moves, _ = blocks.readers()
    if (excess := await find_excess(moves, travel)) is not None:
        raise controller.beyond_travel(excess)


def _check_state(controller: Controller, status: Status, base: Status) -> None:
    """Raise ``ControllerError`` if the state of a controller shows that the program has ended.

    ``status``: last report.
    ``base``: report before the first line of the program was sent.
    """
    if status.state is State.ALARM:
        raise controller.fault or ControllerAlarm("controller.reports-alarm", name=controller.name)
    if status.state in _NO_PROGRAM and status.sent > base.sent:
        raise ControllerError(
            "controller.left-program", name=controller.name, state=status.state.value
        )


async def _make_safe(controller: Controller) -> Status:
    """Bring the machine into its safe state (tool raised, outputs off); return the new status."""
    controller.observer = None
    return await controller.stop()


async def _stop(
    controller: Controller,
    error: ControllerError,
    follower: ProgramFollower,
    base: Status,
    lines: int,
) -> ControllerError:
    """Bring the machine into its safe state; return the error to raise for an interrupted program.

    ``error``: error that interrupted the program; the returned error has its type.
    ``follower``: follower with the number of executed lines, which the returned error contains.
    ``base``: status before the first line of the program was sent.  ``base.sent``, the number of
    lines sent before the program, is subtracted from the present number of lines sent.
    """

    def progress() -> Message:
        return _progress_message(follower.lines, controller.sent - base.sent, lines)

    try:
        status = await _make_safe(controller)
    except ControllerError as unsafe:
        if _states_same_alarm(error.message, unsafe.message):
            return type(error)("controller.unsafe", error=error.message, progress=progress())
        return type(error)(
            "controller.not-stopped",
            error=error.message,
            progress=progress(),
            unsafe=unsafe.message,
        )
    return type(error)(
        "controller.stopped",
        error=error.message,
        progress=progress(),  # only at rest it is known whether a whole program was begun at all
        height=status.position[2],
    )


def _states_same_alarm(error: Message, unsafe: Message) -> bool:
    """Return whether the first of two messages contains all that the second one states."""
    if error == unsafe:
        return True
    if error.code != "controller.alarm" or unsafe.code != "controller.locked":
        return False
    locked: Message = unsafe.arguments["cause"]
    return bool(locked.arguments.get("code") == error.arguments["code"])


def _progress_message(executed: int, sent: int, lines: int) -> Message:
    """Return a message about how far a program was executed.

    ``executed``: number of lines that were certainly executed.
    ``sent``: number of lines sent; the lines between ``executed`` and ``sent`` may be executed too.
    """
    rest = sent - executed
    if sent == 0:
        return Message("run.nothing-sent")
    if rest <= 0:
        return Message("run.executed", executed=executed, lines=lines)
    return Message("run.in-buffer", executed=executed, lines=lines, rest=rest)


async def _feed(
    text: bytes,
    controller: Controller,
    corridor: Corridor,
    check: bool,
    hooks: StreamHooks,
) -> None:
    if check:
        try:
            await controller.check(lines_of(text))
        except ControllerRejected as refused:
            raise CheckRefused(refused.message) from refused
    if hooks.begin is not None:
        await hooks.begin()
    if isinstance(controller, ProgramController):
        corridor.check_rest(await controller.run(text))
        return
    assert isinstance(controller, LineController)
    announced = 0
    for number, line in enumerate(lines_of(text), 1):
        if number > announced and hooks.sending is not None:
            announced = number + _AHEAD - 1
            hooks.sending(announced)
        if switches_output(line):
            # grblHAL switches an output when it reads M64 or M65, even while axes move.
            corridor.check_rest(await controller.settle())
        await controller.send(line, number)
    corridor.check_rest(await controller.settle())


async def _give_up(task: asyncio.Task[None]) -> None:
    """Cancel the task that sends the program, and ignore the error with which the task ends.

    That error has been reported already.
    """
    task.cancel()
    await asyncio.gather(task, return_exceptions=True)


def _progress(
    follower: ProgramFollower, status: Status, answered: int, lines: int, seconds_left: float | None
) -> Progress:
    return Progress(
        follower.lines,
        answered,
        lines,
        status.position,
        status.state,
        follower.output,
        seconds_left,
        status.located,
        status.awaits_end,
        status.door_open,
    )
