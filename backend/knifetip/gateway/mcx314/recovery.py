"""recovery: bring a machine with an MCX314 into its safe state.

The steps are: abort, wait for rest, lift Z, oscillation off, outputs off.  In an alarm the board
moves no axis; the outputs are switched off all the same (ADR 19).
"""

from __future__ import annotations

from knifetip.errors import ControllerAlarm, ControllerRejected
from knifetip.gateway.controller import SafeState, Status
from knifetip.gateway.mcx314.connection import BoardConnection
from knifetip.gateway.whole_program.recovery import wait_for_rest

#: Speed of the lift (mm/s); the board lowers it to what the axis can do.
LIFT_SPEED = 100.0
#: Z may be this much below the lift (mm): less than a pulse.
LEVEL = 1e-3


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
