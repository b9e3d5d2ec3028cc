"""figures: all figures of the chip MCX314, each with its source.

The register manual was not at hand.  Before a real chip is driven, every figure must be compared
with the manual of its version.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

#: Notes of this project on controllers, which were made from secondary sources.
NOTES: Final = "notes of this project on controllers; secondary source"
#: NOVA electronics, user's manual of the MCX314, quoted from memory.
MEMORY: Final = "NOVA electronics, MCX314 user's manual, quoted from memory; secondary source"
#: Codes of the newer chip MCX514 in public firmware; its command set continues that of the MCX314.
SISTER: Final = "command codes of the MCX514 in public firmware; secondary source of a sister chip"
#: What the simulated chip does where no source was at hand.
ASSUMED: Final = "assumed for the simulation; no source was at hand"

#: Version of the format of programs, in their first line.
FORMAT: Final = 1


@dataclass(frozen=True, slots=True)
class Figure:
    """One figure of the chip."""

    name: str
    value: int
    source: str


FIGURES: Final[list[Figure]] = []


def _figure(name: str, value: int, source: str) -> int:
    """Add a figure to ``FIGURES`` and return its value."""
    FIGURES.append(Figure(name, value, source))
    return value


AXES: Final = _figure("number of axes", 4, NOTES)
LARGEST: Final = _figure("largest finish point and centre (pulses, 24 bits)", 0x7FFFFF, NOTES)

LINE_2: Final = _figure("command: line of 2 axes", 0x30, NOTES)
LINE_3: Final = _figure("command: line of 3 axes", 0x31, NOTES)
CLOCKWISE: Final = _figure("command: arc clockwise", 0x32, NOTES)
COUNTER_CLOCKWISE: Final = _figure("command: arc counter-clockwise", 0x33, NOTES)
BITS_2: Final = _figure("command: bit pattern of 2 axes", 0x34, MEMORY)
BITS_3: Final = _figure("command: bit pattern of 3 axes", 0x35, MEMORY)
BITS_OPEN: Final = _figure("command: enable writing of bit patterns", 0x36, MEMORY)
BITS_CLOSE: Final = _figure("command: disable writing of bit patterns", 0x37, MEMORY)
BITS_PUSH: Final = _figure("command: push bit patterns onto the stack", 0x38, MEMORY)
SET_ACCELERATION: Final = _figure("command: acceleration A", 0x02, SISTER)
SET_START: Final = _figure("command: start speed SV", 0x04, SISTER)
SET_SPEED: Final = _figure("command: drive speed V", 0x05, SISTER)
SET_FINISH: Final = _figure("command: finish point P", 0x06, SISTER)
SET_CENTRE: Final = _figure("command: centre C", 0x08, SISTER)
SET_POSITION: Final = _figure("command: logical position LP", 0x09, MEMORY)
GET_POSITION: Final = _figure("command: read the logical position", 0x10, MEMORY)
CLEAR: Final = _figure("command: clear the finish status", 0x25, MEMORY)
STOP: Final = _figure("command: sudden stop", 0x27, MEMORY)

WR0: Final = _figure("register WR0: command, with the axes in bits 8 to 11", 0, MEMORY)
WR5: Final = _figure("register WR5: axes of the interpolation, 2 bits each", 5, MEMORY)
WR6: Final = _figure("register WR6: low word of data", 6, MEMORY)
WR7: Final = _figure("register WR7: high word of data", 7, MEMORY)
BITS_PLUS: Final = _figure("register of the + pulses of the first axis", 2, MEMORY)
RR0: Final = _figure("register RR0: status", 0, MEMORY)
RR6: Final = _figure("register RR6: low word of data", 6, MEMORY)
RR7: Final = _figure("register RR7: high word of data", 7, MEMORY)
DRIVING: Final = _figure("bit of RR0: an interpolation is driven", 1 << 8, MEMORY)
NEXT: Final = _figure("bit of RR0: the next segment can be written", 1 << 9, MEMORY)
STACK: Final = _figure("lowest of 2 bits of RR0: bit patterns on the stack", 13, MEMORY)
CONSTANT_2: Final = _figure("bits of WR5: constant vector speed of 2 axes", 1 << 8, MEMORY)

FASTEST: Final = _figure("largest drive speed V (times the multiple, pulses/s)", 8000, MEMORY)
PATTERN: Final = _figure("pulses in a bit pattern", 16, MEMORY)
DEPTH: Final = _figure("bit patterns on the stack", 3, MEMORY)
GREATEST_MULTIPLE: Final = _figure("largest multiple of the speeds", 500, MEMORY)
RAMP_UNIT: Final = _figure(
    "unit of the acceleration A (times the multiple, pulses/s²)", 125, MEMORY
)
STEEPEST: Final = _figure("largest acceleration A", 8000, MEMORY)

# Conditions of ramps.  The chip decelerates by itself only at the end of a line with a fixed number
# of pulses.  On arcs, bit patterns and continuous interpolation the point at which it decelerates
# must be written, and deceleration must be enabled in the last segment only.  The board therefore
# uses none of it: it divides segments and lowers the drive speed (``simulators.mcx314.planner``).
ENABLE_DECELERATION: Final = _figure("command: enable deceleration; not used", 0x3B, MEMORY)
DISABLE_DECELERATION: Final = _figure("command: disable deceleration; not used", 0x3C, MEMORY)
NEXT_SPEED: Final = _figure(
    "1: a drive speed that is written with the next segment takes effect with it", 1, ASSUMED
)
