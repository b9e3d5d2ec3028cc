"""recovery: bring a machine into its safe state after a fault or a cancel, or on connection.

The steps are: hold, wait for rest, reset, unlock if the alarm permits it, lift Z, switch the
spindle off, switch the outputs off.  The reasons for this order are in docs/decisions/0019.
"""

from __future__ import annotations

import asyncio
from collections.abc import Sequence
from contextlib import suppress
from typing import Protocol

from knifetip.errors import (
    ControllerAlarm,
    ControllerError,
    ControllerOccupied,
    ControllerRejected,
    ControllerSilent,
)
from knifetip.gateway.controller import SafeState, State, Status
from knifetip.gateway.grbl import answers
from knifetip.messages import Message

#: Speed of the lift (mm/min).
LIFT_FEED = 6000.0
#: Time allowed for the lift, in addition to the limit of silence (s).
LIFT_SECONDS = 10.0
#: Alarms that are cleared to lift the tool and release the outputs: soft limit, and reset while
#: moving.  All others have a cause at the machine that a person must inspect first.
UNLOCKABLE = frozenset({2, 3})
#: Pause between two attempts to reach the controller (s).
PAUSE = 0.25
#: Time between two status requests while the machine comes to rest (s).
POLL = 0.01
#: Z may be this much below the lift (mm): rounding of reports.
LEVEL = 1e-3


class Recoverable(Protocol):
    """The methods of a grbl controller that recovery uses."""

    @property
    def name(self) -> str:
        """Address of the controller, for messages."""
        ...

    @property
    def last_alarm(self) -> int:
        """Code of the alarm that locks the controller.

        The code is 0 if there is no alarm, or if the code of the alarm was not received.
        """
        ...

    async def reach(self) -> None:
        """Clear the recorded fault of the connection; reconnect if the connection is lost."""
        ...

    async def realtime(self, byte: bytes) -> None:
        """Send a realtime command: a single byte that the controller executes at once."""
        ...

    async def report(self) -> Status:
        """Request a status report and return it."""
        ...

    async def reset(self) -> None:
        """Reset the controller by software; return when its welcome banner has arrived."""
        ...

    async def command(self, text: bytes) -> list[str]:
        """Send a command that is no program line, such as ``$X``, and wait for its answer.

        Returns the lines that the controller sent before the ``ok`` for the command.
        """
        ...


async def make_safe(machine: Recoverable, safe: SafeState | None, silence: float) -> Status:
    """Discard the running program, bring the machine into its safe state and return a status.

    If the controller does not answer or the connection is lost, the function tries again for ``6 *
    silence`` seconds.

    Parameters
    ----------
    machine
        Connection to the controller of the machine.
    safe
        Safe state of the machine; with None the machine is only held and reset.
    silence
        Seconds after which the controller counts as silent.

    Returns
    -------
    Status
        Status of the machine at rest, after Z was raised.

    Raises
    ------
    ControllerAlarm
        An alarm locks the machine; a person must clear it.
    ControllerOccupied
        The safety door is open, so the tool stays where it is.
    ControllerRejected
        The controller refuses to raise Z or to switch an output off; all other steps were done.
    ControllerError
        The controller could not be reached.
    """
    clock = asyncio.get_running_loop()
    deadline = clock.time() + 6.0 * silence
    while True:
        try:
            await machine.reach()
            await _hold(machine, silence)
            if machine.last_alarm == answers.EMERGENCY_STOP:
                raise _locked_error(machine)
            await machine.reset()
            # The first report may be from before the reset; the second one is not.
            await machine.report()
            status = await machine.report()
            if status.state is State.ALARM:
                await _unlock(machine)
            return await secure(machine, safe, silence)
        except (ControllerAlarm, ControllerOccupied, ControllerRejected):
            raise
        except ControllerError:
            if clock.time() > deadline:
                raise
        await asyncio.sleep(PAUSE)


async def discard(machine: Recoverable, silence: float) -> bool:
    """Stop a machine and discard all that its controller holds; return whether it is not locked.

    Only alarms in ``UNLOCKABLE`` are cleared.

    Raises
    ------
    ControllerError
        The controller did not answer.
    """
    await _hold(machine, silence)
    await machine.reset()
    # The first report may be from before the reset; the second one is not.
    await machine.report()
    if (await machine.report()).state is not State.ALARM:
        return True
    try:
        await _unlock(machine)
    except ControllerAlarm:
        return False
    return True


async def secure(machine: Recoverable, safe: SafeState | None, silence: float) -> Status:
    """Raise Z, stop the spindle and switch off every output of a machine at rest; return a status.

    Z is raised first, so that a tool in the board leaves the board along its axis.

    Parameters
    ----------
    machine
        Connection to the controller of the machine.
    safe
        Safe state of the machine; with None nothing is changed.
    silence
        Seconds after which the controller counts as silent.

    Returns
    -------
    Status
        Status after Z was raised, or the present status if Z is high enough or ``safe`` is None.
        The outputs are switched off after this status was reported.

    Raises
    ------
    ControllerRejected
        The controller refuses to raise Z, to stop the spindle or to switch an output off; the steps
        that it does not refuse were done.
    ControllerOccupied
        The safety door is open; nothing was done.
    ControllerError
        The machine is not idle, or the controller did not answer.
    """
    status = await machine.report()
    if safe is None:
        return status
    if status.state is State.DOOR:
        raise ControllerOccupied("controller.door-open", name=machine.name)
    if status.state is not State.IDLE:
        raise ControllerError("controller.not-secured", name=machine.name, state=status.state.value)
    refused_lift = []
    if status.position[2] < safe.lift - LEVEL:
        try:
            await machine.command(b"$J=G90 G21 Z%.4f F%.0f" % (safe.lift, LIFT_FEED))
        except ControllerRejected as refused:
            refused_lift.append(refused)
        status = await _wait_until_idle(machine, silence + LIFT_SECONDS)
    await release(machine, safe, refused_lift)
    return status


async def release(
    machine: Recoverable, safe: SafeState | None, refused: Sequence[ControllerRejected] = ()
) -> None:
    """Stop the spindle and switch off every output of a machine at rest; nothing moves.

    Parameters
    ----------
    machine
        Connection to the controller of the machine.
    safe
        Safe state of the machine; with None nothing is changed.
    refused
        Refusals of earlier steps, which the raised error contains too.

    Raises
    ------
    ControllerRejected
        The controller refuses a step, or has refused an earlier one; the other steps were done.
    ControllerError
        The controller did not answer.
    """
    if safe is None:
        return
    refusals = [*refused]
    for line in (b"M5", *(b"M65 P%d" % output for output in safe.outputs)):
        try:
            await machine.command(line)
        except ControllerRejected as refusal:
            refusals.append(refusal)
    if refusals:
        raise ControllerRejected(
            "controller.refused-safe-state", refusals=[refusal.message for refusal in refusals]
        )


async def _hold(machine: Recoverable, silence: float) -> None:
    """Send a feed hold; return when no axis moves, but at latest after ``silence`` seconds.

    No error is raised if the machine still moves then, or does not answer.
    """
    await machine.realtime(b"!")
    still = 0
    with suppress(TimeoutError, ControllerSilent):
        async with asyncio.timeout(silence):
            # Two reports: one may be old or false.
            while still < 2:
                still = still + 1 if (await machine.report()).still else 0
                await asyncio.sleep(POLL)


async def _unlock(machine: Recoverable) -> None:
    """Clear the present alarm if its code is in ``UNLOCKABLE``: soft limit, or reset during motion.

    All other alarms have a cause at the machine that a person must inspect first.

    Raises ``ControllerAlarm``: the code of the alarm is not in ``UNLOCKABLE``, or the controller
    refuses to clear the alarm.
    """
    locked = _locked_error(machine)
    if machine.last_alarm not in UNLOCKABLE:
        raise locked
    try:
        await machine.command(b"$X")
    except ControllerRejected:
        raise locked from None


def _locked_error(machine: Recoverable) -> ControllerAlarm:
    code = machine.last_alarm
    cause = Message("controller.alarm-unknown")
    if code > 0:
        cause = Message("controller.alarm-code", code=code, alarm=answers.alarm_meaning(code))
    return ControllerAlarm("controller.locked", name=machine.name, cause=cause)


async def _wait_until_idle(machine: Recoverable, seconds: float) -> Status:
    """Wait until the controller is idle after the lift of Z, and return its status.

    Raises ``ControllerError``: the controller is in alarm, or is not idle after ``seconds``.
    """
    idle = 0
    try:
        async with asyncio.timeout(seconds):
            while True:
                status = await machine.report()
                if status.state is State.ALARM:
                    raise _locked_error(machine)
                idle = idle + 1 if status.state is State.IDLE else 0
                if idle >= 2:
                    return status
                await asyncio.sleep(POLL)
    except TimeoutError:
        raise ControllerSilent(
            "controller.lift-not-finished", name=machine.name, seconds=seconds
        ) from None
