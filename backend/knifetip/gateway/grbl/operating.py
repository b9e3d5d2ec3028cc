"""operating: operations of a person at a machine with grbl's protocol, such as unlock and jog.

- ``home`` is ``$H``.  ``unlock`` is ``$X``, after a reset, because a critical alarm ends only with
  a reset.
- Jogs are ``$J=`` commands: the controller refuses those that leave its travel, and the realtime
  command 0x85 stops them.
- ``zero`` is ``G10 L20 P1``: it stores the present position as the zero of G54, in which the
  programs of knifetip run.  ``G92`` would not do: the programs cancel it in their first line.
- ``switch`` is M64 or M65.
- The feed override is changed by the realtime commands 0x90 to 0x94.
"""

from __future__ import annotations

import asyncio
from contextlib import suppress

from knifetip.contract.operations import OperationName
from knifetip.errors import ControllerAlarm, ControllerError
from knifetip.gateway.controller import State
from knifetip.gateway.grbl import answers, recovery
from knifetip.gateway.grbl.capabilities import Capabilities
from knifetip.gateway.grbl.connection import GrblConnection
from knifetip.gateway.operations import JOG_PIECE
from knifetip.gateway.supervised import SupervisedController
from knifetip.messages import Message
from knifetip.model.machine import Station

#: Longest time of a homing cycle (s).
HOMING_SECONDS = 180.0
#: Speed of the move to the park position (mm/min).
PARK_FEED = 6000.0
_CANCEL_JOG = b"\x85"
#: Feed override of a program without changes (%).
_NOMINAL = 100
#: Most realtime commands from one feed override to another: steps of 10 and of 1 %.
_MOST_STEPS = 30
#: Most reports that are requested after a step, and the time between two of them (s).
_OVERRIDE_REPORTS, _OVERRIDE_PAUSE = 20, 0.05


def _override_step(found: int, percent: int) -> bytes:
    """Return the realtime command that brings the feed override nearer to a value (%)."""
    if percent == _NOMINAL:
        return b"\x90"
    if abs(percent - found) >= 10:
        return b"\x91" if percent > found else b"\x92"
    return b"\x93" if percent > found else b"\x94"


class GrblOperations(SupervisedController[GrblConnection]):
    """The methods of ``operations.Operable`` for a controller with grbl's protocol."""

    #: grbl executes its jogs to their ends, also without its gateway.
    jog_seconds: float = JOG_PIECE
    _silence: float
    _capabilities: Capabilities
    _homing: bool = False
    _stops: int = 0  # number of calls of ``stop_jog``

    @property
    def operations(self) -> frozenset[str]:
        """Names of the operations that the controller can do: all."""
        return frozenset(OperationName)

    @property
    def alarm(self) -> Message | None:
        """Meaning of the alarm that locks the controller, with what to do; None for no alarm."""
        # After a critical alarm grbl sends no report until it is reset.
        status, code = self._connection.status, self._connection.last_alarm
        if not self.connected:
            return None
        if code == 0 and (status is None or status.state is not State.ALARM):
            return None
        if code <= 0:
            return Message("controller.alarm-of-unknown-cause", name=self._connection.name)
        return Message(
            "controller.in-alarm",
            name=self._connection.name,
            code=code,
            alarm=answers.alarm_meaning(code),
        )

    async def _read_settings(self) -> None:
        """Request the options of the controller, and check its settings."""
        raise NotImplementedError

    async def unlock(self) -> None:
        """Clear an alarm without homing, and switch all outputs off.

        The tool is lifted only if the alarm leaves the position of the axes true; after any other
        alarm a lift could drive Z into its end stop, so nothing moves.
        """
        connection = self._connection
        code = connection.last_alarm
        await connection.reach()
        connection.recovering = True
        try:
            await connection.reset()
            await connection.command(b"$X")
            await self._read_settings()
            if code in recovery.UNLOCKABLE:
                await recovery.secure(connection, self._safe, self._silence)
            else:
                await recovery.release(connection, self._safe)
            await connection.report()  # the alarm is over
        finally:
            connection.recovering = False
        self._forget_switches()

    async def home(self) -> None:
        """Home all axes, which lifts Z to its switch, and switch all outputs off.

        The tool is not lifted further: if the zero of Z was not set since, the height of the safe
        state may be beyond the switch.
        """
        connection, locked = self._connection, self.alarm is not None
        await connection.reach()
        # grbl answers no status request during homing; this must not count as silence.
        connection.recovering = self._homing = True
        try:
            if locked:
                await connection.reset()
            # Before the cycle: with a wrong direction, homing would drive the tool into the board.
            await self._read_settings()
            await connection.command(b"$H", HOMING_SECONDS)
            await recovery.release(connection, self._safe)
            await connection.report()  # the alarm is over
        finally:
            connection.recovering = self._homing = False
        self._forget_switches()

    async def release(self) -> None:
        """Discard what the controller executes or holds, and switch all outputs off.

        No axis is moved.  A reset after a sleep may leave an alarm, which is then the fault.
        """
        connection = self._connection
        await connection.reach()
        connection.recovering = True
        try:
            if await recovery.discard(connection, self._silence):
                await self._read_settings()
                await recovery.release(connection, self._safe)
            else:
                connection.fail(ControllerAlarm("controller.locked-by-alarm", name=self.name))
        finally:
            connection.recovering = False
        self._forget_switches()

    async def jog(self, axis: str, distance: float, feed: float) -> None:
        """Begin to move one axis by a distance (mm or degrees) at a feed (per minute)."""
        jog = b"$J=G91 G21 %s%.4f F%.0f" % (axis.encode(), distance, max(feed, 1.0))
        await self._connection.command(self._capabilities.operation_to_wire(jog))

    async def stop_jog(self) -> None:
        """Stop the running jog, also that of ``park``, and discard the rest of it.

        A homing cycle is stopped by a reset; the controller is then locked by an alarm.
        """
        self._stops += 1
        if self._homing:
            with suppress(ControllerAlarm):  # the alarm of a homing cycle that was reset
                await self._connection.reset()
        else:
            await self._connection.realtime(_CANCEL_JOG)

    async def override_feed(self, percent: int) -> None:
        """Set the feed override by realtime commands, also while a program runs.

        grbl may forget a command that follows another one at once, so each step is awaited.
        """
        connection = self._connection
        if percent == _NOMINAL:
            await connection.realtime(_override_step(percent, percent))
        await connection.report()
        found = _NOMINAL
        for _ in range(_MOST_STEPS):
            found = connection.status.override if connection.status else _NOMINAL
            if found == percent:
                return
            await connection.realtime(_override_step(found, percent))
            await self._await_override(found)
        raise ControllerError(
            "operation.override-not-confirmed", name=self.name, found=found, percent=percent
        )

    async def _await_override(self, before: int) -> None:
        """Request reports until one has another feed override than before, or a second is over."""
        connection = self._connection
        for _ in range(_OVERRIDE_REPORTS):
            await connection.report()
            if connection.status is not None and connection.status.override != before:
                return
            await asyncio.sleep(_OVERRIDE_PAUSE)

    async def zero(self, axes: str) -> None:
        """Store the present position of axes as their zero in G54."""
        words = " ".join(f"{axis}0" for axis in axes)
        command = b"G10 L20 P1 " + words.encode()
        await self._connection.command(self._capabilities.operation_to_wire(command))

    async def park(self) -> None:
        """Lift the tool, then begin to move X and Y to the park position of the machine."""
        connection, safe, stops = self._connection, self._safe, self._stops
        await recovery.secure(connection, safe, self._silence)
        self._forget_switches()
        if self._stops != stops:
            raise ControllerError("operation.stopped", name=connection.name)
        if safe is not None:
            x, y = safe.park
            await connection.command(b"$J=G90 G21 X%.4f Y%.4f F%.0f" % (x, y, PARK_FEED))

    async def spin(self, station: Station | None) -> None:
        """Switch the spindle of a station on, or switch it off."""
        line = b"M5" if station is None else f"{station.spindle} S{station.speed}".encode()
        await self._connection.command(line)
        self._spinning = 0 if station is None else station.number

    async def switch(self, output: int, on: bool) -> None:
        """Switch a digital output on or off."""
        await self._connection.command(b"M64 P%d" % output if on else b"M65 P%d" % output)
        self._record_switch(output, on)
