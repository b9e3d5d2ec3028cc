"""machine: the machine of a simulated table: its axes, outputs and spindle.

It is independent of the protocol.  Positions and limits of travel are in work coordinates.
"""

from __future__ import annotations

from collections import deque
from collections.abc import Sequence
from dataclasses import replace

from knifetip.errors import ControllerError
from knifetip.gateway.motion import Limits, Move, Planner, Pose
from knifetip.model.machine import Machine
from knifetip.simulators.grbl.trace import SwitchEvent, Trace

#: Distance between the limits of travel and the mechanical end stops (mm or degrees).
PAST = 1e-4
#: Blocks of the planner, as ``$I`` and ``Bf`` report.
BLOCKS = 15


class TableMachine:
    """The machine, which a controller moves and switches.

    Parameters
    ----------
    machine
        Machine that is simulated.
    sample
        Simulated seconds between two samples of the trace; 0 for no trace.

    Raises
    ------
    ControllerError
        The machine has several carriages.
    """

    def __init__(self, machine: Machine, sample: float) -> None:
        if machine.gantry:
            count = len(machine.carriages)
            raise ControllerError("controller.one-carriage", machine=machine.title, count=count)
        self.machine = machine
        self.time = 0.0  #: simulated seconds of motion and dwell
        self.trace = Trace(sample) if sample > 0.0 else None
        self.outputs: dict[int, bool] = {}
        self.switch_events: deque[SwitchEvent] = deque(maxlen=10_000)
        self.oscillating = False
        self.reversed = False  #: the spindle turns counter-clockwise
        self._limits = Limits.from_machine(machine)  # in work coordinates
        self._offset: Pose = (0.0, 0.0, 0.0, 0.0)  # machine position of the work zero
        self._planner = Planner(self._limits, BLOCKS, (0.0, 0.0, machine.travel_z, 0.0))
        self._dwell = 0.0

    @property
    def position(self) -> Pose:
        """Position of the axes in work coordinates: x, y, z (mm) and c (degrees)."""
        return self._planner.position

    @property
    def busy(self) -> bool:
        """Whether an axis moves or the table dwells."""
        return self._planner.moving or (self._dwell > 0.0 and not self._planner.holding)

    def _is_within_travel(self, move: Move) -> bool:
        low, high = move.bounds()
        return all(
            least >= bottom - PAST and most <= top + PAST
            for least, most, bottom, top in zip(
                low, high, self._limits.low, self._limits.high, strict=True
            )
        )

    def _switch(self, output: int, on: bool) -> None:
        self.outputs[output] = on
        self.switch_events.append(
            SwitchEvent(self.time, output, on, self.position, self._planner.speed > 0.0)
        )

    def _go_home(self) -> None:
        """Set the position that the axes have after homing."""
        zero_x, zero_y, zero_z, zero_c = self._offset
        self._planner.position = (-zero_x, -zero_y, self.machine.travel_z - zero_z, -zero_c)

    def _move_zero(self, shift: Sequence[float]) -> None:
        """Move the work zero; the axes do not move, so their work coordinates change.

        ``shift``: distance along each axis (mm or degrees).
        """

        def shifted(pose: Pose) -> Pose:
            x, y, z, c = (value - by for value, by in zip(pose, shift, strict=True))
            return x, y, z, c

        limits = self._limits
        x, y, z, c = (value + by for value, by in zip(self._offset, shift, strict=True))
        self._offset = (x, y, z, c)
        self._limits = replace(limits, low=shifted(limits.low), high=shifted(limits.high))
        self._planner.position = shifted(self.position)

    def _pass_time(self, seconds: float) -> None:
        """Count simulated time that has passed, and sample the position."""
        self.time += seconds
        if self.trace:
            self.trace.add(self.time, self.position)
