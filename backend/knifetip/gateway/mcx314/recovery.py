"""recovery: bring a machine with an MCX314 into its safe state.

The steps are: abort, wait for rest, lift Z, oscillation off, outputs off.  In an alarm the board
moves no axis; the outputs are then switched off nevertheless (ADR 19).
"""

from __future__ import annotations

import asyncio

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.mcx314.connection import BoardConnection

#: Speed of the lift (mm/s); the board lowers it to what the axis can do.
LIFT_SPEED = 100.0
#: Time allowed for the deceleration after an abort, and for the lift (s).
REST_SECONDS = 15.0
#: Pause between two attempts to reach the board (s).
PAUSE = 0.25
#: Time between two reports while the machine comes to rest (s).
POLL = 0.02
#: Z may be this much below the lift (mm): less than a pulse.
LEVEL = 1e-3


async def make_safe(board: BoardConnection, safe: SafeState | None) -> Status:
    """Discard the running program, bring the machine into its safe state and return its status.

    If the board does not answer or the connection is lost, the function tries again for 6 times the
    limit of silence.

    Raises
    ------
    ControllerAlarm
        An alarm locks the board; its outputs are off.
    ControllerRejected
        The board refuses a step; all other steps were done.
    ControllerError
        The board could not be reached.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + 6.0 * board.silence
    while True:
        try:
            await board.reach()
            await board.request("ABORT")
            board.program = None
            await wait_for_rest(board)
            return await secure(board, safe)
        except (ControllerAlarm, ControllerRejected):
            raise
        except ControllerError:
            if clock.time() > deadline:
                raise
        await asyncio.sleep(PAUSE)


async def secure(board: BoardConnection, safe: SafeState | None) -> Status:
    """Raise Z, stop the oscillation and switch all outputs off, at rest; return a status.

    Raises
    ------
    ControllerAlarm
        An alarm locks the board; its outputs are off.
    ControllerRejected
        The board refuses a step; the steps that it does not refuse were done.
    ControllerError
        The board did not answer.
    """
    status = await board.report()
    if safe is None:
        return status
    refusals = []
    if board.alarm is None and status.position[2] < safe.lift - LEVEL:
        try:
            lift, scale = round(safe.lift * board.pulses[2]), board.pulses[2]
            await board.request(f"MOVE Z{lift} V{LIFT_SPEED * scale:.0f}")
            await wait_for_rest(board)
        except ControllerRejected as refused:
            refusals.append(refused.message)
    for request in release_requests(safe):
        try:
            await board.request(request)
        except ControllerRejected as refused:
            refusals.append(refused.message)
    await board.guard(safe)
    status = await board.report()
    if board.alarm is not None:
        raise ControllerAlarm("mcx314.not-lifted", cause=board.alarm)
    if refusals:
        raise ControllerRejected("controller.refused-safe-state", refusals=refusals)
    return status


def release_requests(safe: SafeState) -> list[str]:
    """Return the requests that stop the oscillation and switch all outputs of a machine off."""
    return ["OSC OFF", *(f"OUT {output} OFF" for output in safe.outputs)]


async def wait_for_rest(board: BoardConnection) -> Status:
    """Wait until the board executes nothing and no axis moves; return the last status.

    Raises
    ------
    ControllerError
        The machine is not at rest after ``REST_SECONDS``.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + REST_SECONDS
    while True:
        status = await board.report()
        if status.still and status.state in (State.IDLE, State.ALARM):
            return status
        if clock.time() > deadline:
            raise ControllerError("mcx314.not-at-rest", name=board.name, seconds=REST_SECONDS)
        await asyncio.sleep(POLL)
