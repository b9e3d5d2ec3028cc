"""operating: operations of a person at a machine with an MCX314, such as unlock and jog.

- ``unlock`` clears an alarm at the board.  Afterwards the axes must be homed, because the chip has
  stopped at once and the position may be wrong.
- ``home`` lets the board find the zero of all axes, which also clears an alarm.
- Jogs and the move to the park position are moves to absolute positions, so that a repeated request
  does not move twice.
- Runs above the board (``dry_run``) are not possible: their programs are G-code.
- ``zero`` lets the board store the present position as the zero of programs.
"""

from __future__ import annotations

import asyncio
import math

from knifetip.contract.operations import RUNS, OperationName
from knifetip.gateway.controller import State, Status
from knifetip.gateway.mcx314 import recovery
from knifetip.gateway.mcx314.connection import BoardConnection
from knifetip.gateway.operations import AXES
from knifetip.gateway.whole_program.controller import WholeProgramController
from knifetip.model.machine import Station

#: Longest time until all axes are homed (s).
HOMING_SECONDS = 180.0
#: Speed of the move to the park position (mm/s).
PARK_SPEED = 100.0
#: Time between two reports during homing (s).
_POLL = 0.05


class Mcx314Operations(WholeProgramController[BoardConnection]):
    """The methods of ``operations.Operable`` for an MCX314."""

    #: The board stops a move by itself if its gateway is gone.
    jog_seconds: float = math.inf

    @property
    def operations(self) -> frozenset[str]:
        """Names of the operations that the controller can do: all but runs above the board, and
        the feed override.
        """
        lacks = {OperationName.HOLD, OperationName.RESUME, OperationName.FEED_OVERRIDE}
        return frozenset(OperationName) - RUNS - lacks

    async def _secure(self) -> Status:
        return await recovery.secure(self._connection, self._safe)

    async def _release_outputs(self) -> None:
        for request in () if self._safe is None else recovery.release_requests(self._safe):
            await self._connection.request(request)

    async def unlock(self) -> None:
        """Clear an alarm.  If the axes are homed, then lift the tool and switch all outputs off."""
        connection = self._connection
        connection.recovering = True
        try:
            await connection.reach()
            await connection.request("UNLOCK")
            await connection.report()
            if connection.alarm is None:
                await self._secure()
            else:
                await connection.guard(self._safe)
        finally:
            connection.recovering = False
        self._forget_switches()

    async def home(self) -> None:
        """Home all axes, lift the tool and switch all outputs off."""
        connection, clock = self._connection, asyncio.get_running_loop()
        connection.recovering = True
        try:
            await connection.reach()
            await connection.request("HOME")
            deadline = clock.time() + HOMING_SECONDS
            while (status := await connection.report()).state is State.HOME or not status.still:
                if clock.time() > deadline:
                    raise connection.not_at_rest(HOMING_SECONDS)
                await asyncio.sleep(_POLL)
            await self._secure()
        finally:
            connection.recovering = False
        self._forget_switches()

    async def jog(self, axis: str, distance: float, feed: float) -> None:
        """Begin to move one axis by a distance (mm or degrees) at a feed (per minute)."""
        place = AXES.index(axis)
        scale = self._connection.pulses[place]
        status = await self._connection.report()
        target = round((status.position[place] + distance) * scale)
        speed = max(round(feed / 60.0 * scale), 1)
        await self._connection.request(f"MOVE {axis}{target} V{speed}")

    async def stop_jog(self) -> None:
        """Decelerate the running jog to a stop and discard the rest of it."""
        await self._connection.abort()

    async def zero(self, axes: str) -> None:
        """Let the board store the present position of axes as the zero of programs."""
        await self._connection.request(f"ZERO {axes}")
        await self._connection.guard(self._safe)

    async def park(self) -> None:
        """Lift the tool, then begin to move X and Y to the park position of the machine."""
        await self._secure()
        self._forget_switches()
        if self._safe is not None:
            scales = self._connection.pulses
            x, y = (round(at * scale) for at, scale in zip(self._safe.park, scales, strict=False))
            await self._connection.request(f"MOVE X{x} Y{y} V{PARK_SPEED * scales[0]:.0f}")

    async def spin(self, station: Station | None) -> None:
        """Switch the oscillation or the spindle of a station on, or switch it off."""
        await self._connection.request("OSC OFF" if station is None else "OSC ON")
        self._spinning = 0 if station is None else station.number

    async def switch(self, output: int, on: bool) -> None:
        """Switch a digital output on or off."""
        await self._connection.request(f"OUT {output} {'ON' if on else 'OFF'}")
        self._record_switch(output, on)
