"""operating: operations of a person at a machine with LinuxCNC, such as unlock and jog.

- ``unlock`` resets the emergency stop of LinuxCNC and switches the machine on.  LinuxCNC refuses
  while a button is pressed.
- ``home`` homes all joints in their order in the INI file.
- Jogs and the move to the park position are lines of G-code, so that the limits of LinuxCNC hold.
- ``zero`` is ``G10 L20 P1``: it stores the present position as the zero of G54.
- ``switch`` is M64 or M65.
"""

from __future__ import annotations

import asyncio

from knifetip.contract.operations import OperationName
from knifetip.errors import ControllerAlarm, ControllerError, ControllerRejected
from knifetip.gateway.controller import State, Status
from knifetip.gateway.linuxcnc import recovery
from knifetip.gateway.linuxcnc.connection import LinuxcncConnection
from knifetip.gateway.operations import AXES, JOG_PIECE
from knifetip.gateway.whole_program.controller import WholeProgramController
from knifetip.messages import Message
from knifetip.model.machine import Station

#: Longest time until all joints are homed (s).
HOMING_SECONDS = 180.0
#: Speed of the move to the park position (mm/min).
PARK_FEED = 6000.0
#: Time between two reports during homing (s).
_POLL = 0.1
#: Most reports until LinuxCNC reports a new feed override.
_OVERRIDE_REPORTS = 10
#: Cycles of the task controller without a message after which none is left.
_SILENT_CYCLES = 3


class LinuxcncOperations(WholeProgramController[LinuxcncConnection]):
    """The methods of ``operations.Operable`` for LinuxCNC."""

    #: LinuxCNC executes a move to its end, also without its gateway.
    jog_seconds: float = JOG_PIECE
    _jog: tuple[str, float] = ("", 0.0)  # axis and target of the last jog

    @property
    def operations(self) -> frozenset[str]:
        """Names of the operations that the controller can do: all."""
        return frozenset(OperationName)

    async def _secure(self) -> Status:
        return await recovery.secure(self._connection, self._safe)

    async def _release_outputs(self) -> None:
        if self._safe is not None:
            await self._connection.execute(recovery.release_lines(self._safe))

    async def unlock(self) -> None:
        """Reset the emergency stop and switch the machine on.

        If the joints are homed, the tool is then lifted, and all outputs are switched off.
        """
        connection = self._connection
        await connection.reach()
        connection.recovering = True
        try:
            await connection.shell.set("estop off")
            await connection.shell.set("machine on")
            await connection.report()
            self._require_power()
            if connection.alarm is None:
                await self._secure()
        finally:
            connection.recovering = False
        self._forget_switches()

    async def home(self) -> None:
        """Home all joints, lift the tool and switch all outputs off."""
        connection = self._connection
        await connection.reach()
        connection.recovering = True
        try:
            await connection.report()
            self._require_power()
            await connection.shell.messages()  # about earlier commands
            await connection.shell.set("mode manual")
            await connection.shell.set("teleop_enable off")
            await connection.shell.set("home -1")
            await self._wait_until_homed()
            await self._secure()
        finally:
            connection.recovering = False
        self._forget_switches()

    def _require_power(self) -> None:
        """Raise ``ControllerAlarm`` if the machine is off or in emergency stop."""
        alarm = self._connection.alarm
        if alarm is not None and alarm.code != "linuxcnc.not-homed":
            raise self._connection.fail(ControllerAlarm(alarm))

    async def _wait_until_homed(self) -> None:
        connection, clock = self._connection, asyncio.get_running_loop()
        deadline = clock.time() + HOMING_SECONDS
        while clock.time() < deadline:
            status = await connection.report()
            if (cause := await connection.shell.cause()) is not None:
                raise ControllerRejected(
                    "linuxcnc.refused", name=connection.name, command="home", cause=cause
                )
            if connection.alarm is None and status.still:
                return
            await asyncio.sleep(_POLL)
        raise connection.not_at_rest(HOMING_SECONDS)

    async def jog(self, axis: str, distance: float, feed: float) -> None:
        """Begin to move one axis by a distance (mm or degrees) at a feed (per minute)."""
        status = await self._connection.report()
        moved, end = self._jog
        if status.state is State.JOG and moved == axis:
            # LinuxCNC executes it behind the running move, whose modes are in force.
            start = end
        else:
            await self._connection.execute([recovery.MODES])
            start = status.position[AXES.index(axis)]
        # An absolute move: other users of LinuxCNC do not expect G91 to be in force.
        target = start + distance
        self._jog = axis, target
        try:
            await self._begin(f"G1 {self._word(axis)}{target:.4f} F{max(feed, 1.0):.0f}")
        except ControllerRejected:
            self._jog = "", 0.0  # it never arrives there, so the next must not start there
            raise

    async def stop_jog(self) -> None:
        """Decelerate the running jog to a stop and discard the rest of it."""
        self._jog = "", 0.0
        await self._connection.shell.set("abort")

    async def zero(self, axes: str) -> None:
        """Store the present position of axes as their zero in G54."""
        words = " ".join(f"{self._word(axis)}0" for axis in axes)
        await self._connection.execute([recovery.MODES, f"G10 L20 P1 {words}"])

    async def override_feed(self, percent: int) -> None:
        """Set the feed override, also while a program runs."""
        connection = self._connection
        await connection.shell.set(f"feed_override {percent}")
        found = percent
        for _ in range(_OVERRIDE_REPORTS):
            found = (await connection.report()).override
            if found == percent:
                return
            await asyncio.sleep(_POLL)
        raise ControllerError(
            "operation.override-not-confirmed", name=connection.name, found=found, percent=percent
        )

    async def park(self) -> None:
        """Lift the tool, then begin to move X and Y to the park position of the machine."""
        await self._secure()
        self._forget_switches()
        if self._safe is not None:
            x, y = self._safe.park
            await self._begin(f"G1 X{x:.4f} Y{y:.4f} F{PARK_FEED:.0f}")

    async def spin(self, station: Station | None) -> None:
        """Switch the spindle of a station on, or switch it off."""
        line = "M5" if station is None else f"{station.spindle} S{station.speed}"
        await self._connection.execute([line])
        self._spinning = 0 if station is None else station.number

    async def switch(self, output: int, on: bool) -> None:
        """Switch a digital output on or off."""
        await self._connection.execute([f"M64 P{output}" if on else f"M65 P{output}"])
        self._record_switch(output, on)

    def _word(self, axis: str) -> str:
        """Return the letter of an axis of an operation, whose heading is C, in programs."""
        return self._connection.heading_letter if axis == "C" else axis

    async def _begin(self, line: str) -> None:
        """Begin to execute a line of G-code; ``MODES`` must be in force."""
        connection = self._connection
        await connection.shell.messages()  # about earlier commands
        await connection.shell.set(f"mdi {line}")
        if refusal := await self._refusal():
            cause = Message("linuxcnc.cause", texts=refusal)
            raise ControllerRejected(
                "linuxcnc.refused", name=connection.name, command=line, cause=cause
            )

    async def _refusal(self) -> list[str]:
        """Return all messages about the line that was just sent; none if the machine moves.

        LinuxCNC confirms a line before it refuses it, and passes on one message in each cycle of
        its task controller, which is late on a computer with other work.
        """
        connection = self._connection
        found: list[str] = []
        silent = 0
        while True:
            new = await connection.shell.messages()
            if not found and not new and (await connection.report()).state is State.JOG:
                return []
            found += new
            silent = 0 if new else silent + 1
            if silent == _SILENT_CYCLES:
                return found
            await connection.confirm()
