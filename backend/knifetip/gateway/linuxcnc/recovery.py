"""recovery: bring a machine with LinuxCNC into its safe state.

The steps are: abort, wait for rest, lift Z, spindle off, outputs off.  ``abort`` stops the spindle
and discards the program, but leaves all outputs as they are.  While the machine is off, in
emergency stop or not homed, LinuxCNC executes no command, so nothing is changed then.
"""

from __future__ import annotations

from knifetip.errors import ControllerAlarm
from knifetip.gateway.controller import SafeState, Status
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection
from knifetip.gateway.whole_program.recovery import wait_for_rest

#: Speed of the lift (mm/min).
LIFT_FEED = 6000.0
#: Time allowed for the lift (s).
LIFT_SECONDS = 10.0
#: Z may be this much below the lift (mm): rounding of reports.
LEVEL = 1e-3
#: Modal state for the commands of this gateway; work coordinates without a tool offset.
MODES = "G21 G90 G94 G17 G40 G49 G54"


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
    status = await wait_for_rest(machine)
    if machine.alarm is not None:
        raise ControllerAlarm("linuxcnc.not-secured", cause=machine.alarm)
    return status


def release_lines(safe: SafeState) -> list[str]:
    """Return the lines that stop the spindle and switch all outputs of a machine off."""
    return ["M5", *(f"M65 P{output}" for output in safe.outputs)]
