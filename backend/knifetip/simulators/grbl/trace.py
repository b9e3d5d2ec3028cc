"""trace: records the positions of the axes and the switched outputs of a simulated table."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field

import numpy as np

from knifetip.gateway.motion import Pose

#: Samples that a trace keeps at most.
SAMPLES = 500_000


@dataclass(frozen=True, slots=True)
class SwitchEvent:
    """One change of a digital output."""

    time: float
    output: int
    on: bool
    position: Pose
    moving: bool  #: whether an axis was moving


@dataclass(slots=True)
class Trace:
    """Positions of the simulated axes, sampled every ``interval`` seconds of motion or dwell."""

    interval: float
    _values: array[float] = field(default_factory=lambda: array("d"))

    def add(self, time: float, position: Pose) -> None:
        """Add a sample, unless the trace already has ``SAMPLES`` samples.

        Parameters
        ----------
        time
            Simulated time (s).
        position
            Position of the axes.
        """
        if len(self._values) < 5 * SAMPLES:
            self._values.extend((time, *position))

    def samples(self) -> np.ndarray[tuple[int, int], np.dtype[np.float64]]:
        """Return time (s), x, y, z (mm) and c (degrees) of each sample, shape (samples, 5)."""
        return np.array(self._values, dtype=np.float64).reshape(-1, 5)
