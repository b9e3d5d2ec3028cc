"""tool_check: move a station above a point of the table, and lower its tool almost to the board.

A person then sees whether the tool is the right one, and whether its point, height and heading are
those that the machine file states.  A trial correction of the datum can be given; the person moves
with it until the tip is above the point, and then stores the correction in the machine file.

The head travels as in a dry run.  Only then the piston of the station is lowered, and Z moves down
slowly to the height that was asked for, if the travel of Z permits it.  Neither the spindle nor a
laser is switched on.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from contextlib import suppress
from dataclasses import dataclass, replace

from knifetip.contract.operations import LARGEST_SHIFT, Operation, OperationName
from knifetip.errors import ControllerError
from knifetip.gateway.controller import Controller, State
from knifetip.gateway.dry_program import travel_program
from knifetip.gateway.dry_run import DryProgram, DryRun
from knifetip.gateway.operations import OperableController
from knifetip.messages import Message
from knifetip.model.machine import Machine, Station

#: Share of the velocities at which the head travels.
SHARE = 0.1
#: Speed at which Z is lowered (mm/min).
LOWER_FEED = 600.0
#: Time between two status requests while Z moves (s).
_POLL = 0.05
#: Time beyond that of its travel until Z must be at rest (s).
_PATIENCE = 5.0
#: Distance from its target at which Z has reached it (mm).
_NEAR = 0.02


@dataclass(frozen=True, slots=True)
class CheckedPoint:
    """The point above the table to which a tool check moves the tool of a station."""

    station: Station  #: with the trial correction in its datum
    x: float  #: mm on the sheet
    y: float  #: mm
    height: float  #: height of the tip above the mat (mm)

    @classmethod
    def from_operation(cls, operation: Operation, machine: Machine) -> CheckedPoint:
        """Return the point of an operation ``tool_check``.

        Raises
        ------
        ControllerError
            The machine has no such station, the correction is too large, or the point lies in a
            keep-out zone.
        """
        found = [one for one in machine.stations if one.number == operation.station]
        if not found or operation.point is None:
            raise ControllerError(
                "operation.no-station", station=operation.station, machine=machine.title
            )
        shift = operation.shift
        if max(map(abs, shift)) > LARGEST_SHIFT:
            raise ControllerError("tool-check.large-shift", largest=LARGEST_SHIFT)
        station, (x, y) = found[0], operation.point
        for zone in machine.zones:
            inside_x = zone.x - station.reach <= x <= zone.x + zone.width + station.reach
            inside_y = zone.y - station.reach <= y <= zone.y + zone.height + station.reach
            if inside_x and inside_y:
                raise ControllerError("tool-check.in-zone", zone=zone.name)
        dx, dy, dz, dc = shift
        moved = replace(
            station, x=station.x + dx, y=station.y + dy, z=station.z + dz, c=station.c + dc
        )
        return cls(moved, x, y, operation.height)

    def program(self, machine: Machine) -> DryProgram:
        """Return the program that moves the station above the point."""
        station = self.station
        x, y = machine.to_axes(self.x, self.y)
        point = (x + station.x, y + station.y)
        text = travel_program([point], machine, SHARE, station.c)
        return DryProgram(text, ((1, station),))


class ToolCheck(DryRun):
    """A tool check that the machine executes for a person.

    Parameters
    ----------
    job
        Id of the job that waits.
    point
        Where the station moves.
    machine
        The machine.
    may_go_on
        Returns whether the job still waits at this machine.
    """

    def __init__(
        self, job: str, point: CheckedPoint, machine: Machine, may_go_on: Callable[[], bool]
    ) -> None:
        program = point.program(machine)
        super().__init__(OperationName.TOOL_CHECK.value, job, program, machine, may_go_on)
        self._point = point
        self._lowering: OperableController | None = None

    async def stop(self) -> None:
        """End the check: the machine decelerates, and then comes into its safe state."""
        if self._lowering is None:
            await super().stop()
        else:
            self._stopped = True
            await self._lowering.stop_jog()

    async def _stream(self, controller: Controller) -> None:
        await super()._stream(controller)
        station = self._point.station
        target = self._point.height + station.z
        if station.is_beam or not isinstance(controller, OperableController):
            self._note(Message("tool-check.not-lowered-beam"))
        elif target < self._machine.z.low:
            self._note(Message("tool-check.not-lowered", target=target, lowest=self._machine.z.low))
        else:
            await self._lower(controller, station, target)

    async def _lower(self, controller: OperableController, station: Station, target: float) -> None:
        """Lower the piston of the station, and then Z to a position of the axis (mm)."""
        self._lowering = controller
        try:
            if station.output >= 0:
                await controller.switch(station.output, True)
                await asyncio.sleep(self._machine.settle)
            self._raise_if_stopped()
            distance = target - (await controller.status()).position[2]
            if distance < 0.0:
                await controller.jog("Z", distance, LOWER_FEED)
                await self._wait_until_lowered(controller, target, -distance)
        except BaseException:
            # The tool must not stay down beside a person who has pressed Stop.
            await _raise_again(controller)
            raise
        finally:
            self._lowering = None

    async def _wait_until_lowered(
        self, controller: OperableController, target: float, distance: float
    ) -> None:
        """Wait until Z is at rest at a position; ``distance`` is how far it moves (mm)."""
        clock = asyncio.get_running_loop()
        deadline = clock.time() + 60.0 * distance / LOWER_FEED + _PATIENCE
        while True:
            status = await controller.status()
            if status.state is State.IDLE and abs(status.position[2] - target) <= _NEAR:
                return
            self._raise_if_stopped()
            if clock.time() > deadline:
                raise ControllerError("tool-check.not-reached", target=target)
            await asyncio.sleep(_POLL)


async def _raise_again(controller: OperableController) -> None:
    """Stop the lowering of Z, and bring the machine into its safe state."""
    with suppress(ControllerError, TimeoutError):
        async with asyncio.timeout(_PATIENCE):
            await controller.stop_jog()
            while (await controller.status()).state is not State.IDLE:
                await asyncio.sleep(_POLL)
    if controller.alarm is None:
        await controller.stop()
