"""wiring: the record of how a machine is connected to its MCX314.

The emitter, the verifier's reader and the simulated board share this record, but no computation.
"""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Wiring:
    """How the axes X, Y, Z and C of a machine are connected to a chip, and how they are driven."""

    pulses: tuple[float, float, float, float]  #: per mm, and per degree of C
    multiple: int  #: pulses/s for each unit of the chip's drive speed
    start: int  #: rate at which an axis can start and stop without a ramp (pulses/s)
    acceleration: int  #: change of the rate in ramps (pulses/s²)
    refill: float  #: longest time that the writing of a segment takes (s)
    corner: float  #: largest change of direction without a stop (degrees)
