"""recovery: bring a machine whose controller runs whole programs to rest and into its safe state.

The driver of the controller sends the commands that raise Z and switch the outputs off.
"""

from __future__ import annotations

import asyncio
from collections.abc import Awaitable, Callable
from typing import Any

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import State, Status
from knifetip.gateway.whole_program.connection import ProgramConnection

#: Pause between two attempts to reach the controller (s).
PAUSE = 0.25
#: Time between two reports while the machine comes to rest (s).
POLL = 0.02


async def make_safe(
    machine: ProgramConnection[Any], secure: Callable[[], Awaitable[Status]]
) -> Status:
    """Discard the running program, bring the machine into its safe state and return its status.

    If the controller does not answer or the connection is lost, the function tries again for 6
    times the limit of silence.

    Parameters
    ----------
    machine
        Connection to the controller.
    secure
        Function that raises Z and switches everything off at rest, and returns the status.

    Raises
    ------
    ControllerAlarm
        An alarm locks the machine; a person must clear it.
    ControllerRejected
        The controller refuses a step; all other steps were done.
    ControllerError
        The controller could not be reached.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + 6.0 * machine.silence
    program = machine.program
    while True:
        try:
            await machine.reach()
            await machine.abort()
            machine.program, machine.executed = None, machine.sent
            status = await wait_for_rest(machine)
            if program is not None and machine.has_not_begun(program, status):
                machine.sent -= program.lines
                machine.executed = machine.sent
            return await secure()
        except (ControllerAlarm, ControllerRejected):
            raise
        except ControllerError:
            if clock.time() > deadline:
                raise
        await asyncio.sleep(PAUSE)


async def wait_for_rest(machine: ProgramConnection[Any]) -> Status:
    """Wait until the controller executes nothing and no axis moves; return the last status.

    The function also returns when the controller reports an alarm and no axis moves.

    Raises
    ------
    ControllerError
        The machine is not at rest after ``rest_seconds``.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + machine.rest_seconds
    while True:
        status = await machine.report()
        if status.still and status.state in (State.IDLE, State.ALARM):
            return status
        if clock.time() > deadline:
            raise machine.not_at_rest(machine.rest_seconds)
        await asyncio.sleep(POLL)


async def wait_until_still(machine: ProgramConnection[Any]) -> Status:
    """Wait until no axis moves, whatever the controller executes; return the last status.

    Raises
    ------
    ControllerError
        An axis still moves after ``rest_seconds``.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + machine.rest_seconds
    while True:
        status = await machine.report()
        if status.still and status.state is not State.RUN:
            return status
        if clock.time() > deadline:
            raise machine.not_at_rest(machine.rest_seconds)
        await asyncio.sleep(POLL)
