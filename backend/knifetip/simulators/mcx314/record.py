"""record: the events and positions that the simulation of a board records, for tests and tools."""

from __future__ import annotations

from array import array
from dataclasses import dataclass, field

import numpy as np

from knifetip.geometry.columns import F64

#: Samples that are kept at most.
SAMPLES = 500_000


@dataclass(frozen=True, slots=True)
class SwitchedOutput:
    """One change of an output or of the oscillation (-1)."""

    time: float
    output: int
    on: bool
    position: tuple[int, ...]  #: joints (pulses)
    moving: bool


@dataclass(slots=True)
class BoardRecord:
    """Events since the board was created; they outlast an interruption of its power.

    Parameters
    ----------
    interval
        Simulated seconds between two samples of the position; 0 for none.
    """

    interval: float
    switched: list[SwitchedOutput] = field(default_factory=list)
    starved: int = 0  #: stops in a cut because the queue was empty
    refusals: list[str] = field(default_factory=list)  #: refusals of the chip
    _values: array[float] = field(default_factory=lambda: array("d"))
    _sampled: float = 0.0  # time of the last sample

    def until_due(self, time: float) -> float | None:
        """Return the seconds until the next sample is due; None if none is taken."""
        return self._sampled + self.interval - time if self.interval > 0.0 else None

    def is_due(self, time: float) -> bool:
        """Return whether a sample is due."""
        return self.interval > 0.0 and time >= self._sampled + self.interval - 1e-12

    def sample(self, time: float, position: tuple[float, ...], *, moving: bool) -> None:
        """Record the position (mm, degrees) of a machine, if it moves."""
        self._sampled = time
        if moving and len(self._values) < 5 * SAMPLES:
            self._values.extend((time, *position))

    def samples(self) -> F64:
        """Return the recorded time (s) and joints (mm, degrees), (n, 5)."""
        return np.array(self._values, dtype=np.float64).reshape(-1, 5)
