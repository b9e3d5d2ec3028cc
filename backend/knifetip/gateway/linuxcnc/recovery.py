"""recovery: bring a machine with LinuxCNC into its safe state.

The steps are: abort, wait for rest, lift Z, spindle off, outputs off.  ``abort`` stops the spindle
and discards the program, but leaves all outputs as they are.  While the machine is off, in
emergency stop or not homed, LinuxCNC executes no command, so nothing is changed then.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection

#: Speed of the lift (mm/min).
LIFT_FEED = 6000.0
#: Time allowed for the lift (s).
LIFT_SECONDS = 10.0
#: Time allowed for the deceleration after an abort (s).
REST_SECONDS = 5.0
#: Pause between two attempts to reach LinuxCNC (s).
PAUSE = 0.25
#: Time between two reports while the machine comes to rest (s).
POLL = 0.02
#: Z may be this much below the lift (mm): rounding of reports.
LEVEL = 1e-3
#: Modal state for the commands of this gateway; work coordinates without a tool offset.
MODES = "G21 G90 G94 G17 G40 G49 G54"


async def make_safe(machine: LinuxcncConnection, safe: SafeState | None) -> Status:
    """Discard the running program, bring the machine into its safe state and return its status.

    If LinuxCNC does not answer or the connection is lost, the function tries again for 6 times the
    limit of silence.

    Raises
    ------
    ControllerAlarm
        The machine is off, in emergency stop or not homed; a person must change that.
    ControllerRejected
        LinuxCNC refuses to raise Z or to switch an output off; all other steps were done.
    ControllerError
        LinuxCNC could not be reached.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + 6.0 * machine.silence
    while True:
        try:
            await machine.reach()
            with suppress(ControllerRejected):  # while the machine is off
                await machine.shell.set("abort")
            machine.program = None
            await wait_for_rest(machine, REST_SECONDS)
            return await secure(machine, safe)
        except (ControllerAlarm, ControllerRejected):
            raise
        except ControllerError:
            if clock.time() > deadline:
                raise
        await asyncio.sleep(PAUSE)


async def secure(machine: LinuxcncConnection, safe: SafeState | None) -> Status:
    """Raise Z, stop the spindle and switch off every output of a machine at rest; return a status.

    Z is raised first, so that a tool in the board leaves the board along its axis.

    Raises
    ------
    ControllerAlarm
        The machine is off, in emergency stop or not homed.
    ControllerRejected
        LinuxCNC refuses a step; the steps that it does not refuse were done.
    ControllerError
        LinuxCNC did not answer.
    """
    status = await machine.report()
    if machine.alarm is not None:
        raise ControllerAlarm("linuxcnc.not-secured", cause=machine.alarm)
    if safe is None:
        return status
    lines = [MODES]
    if status.position[2] < safe.lift - LEVEL:
        lines.append(f"G1 Z{safe.lift:.4f} F{LIFT_FEED:.0f}")
    await machine.execute([*lines, *release_lines(safe)], LIFT_SECONDS)
    status = await wait_for_rest(machine, REST_SECONDS)
    if machine.alarm is not None:
        raise ControllerAlarm("linuxcnc.not-secured", cause=machine.alarm)
    return status


def release_lines(safe: SafeState) -> list[str]:
    """Return the lines that stop the spindle and switch all outputs of a machine off."""
    return ["M5", *(f"M65 P{output}" for output in safe.outputs)]


async def wait_for_rest(machine: LinuxcncConnection, seconds: float) -> Status:
    """Wait until LinuxCNC executes nothing and no axis moves; return the last status.

    The function also returns when LinuxCNC reports an alarm and no axis moves.

    Raises
    ------
    ControllerError
        The machine is not at rest after ``seconds``.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + seconds
    while True:
        status = await machine.report()
        if status.still and status.state in (State.IDLE, State.ALARM):
            return status
        if clock.time() > deadline:
            raise ControllerError("linuxcnc.not-at-rest", name=machine.name, seconds=seconds)
        await asyncio.sleep(POLL)
