"""instructions: read program lines for an MCX314, for the gateway and the simulated board."""

from __future__ import annotations

import re
from dataclasses import dataclass
from enum import StrEnum

#: Letters of the axes, in the order of poses and registers.
AXES = "XYZC"

_WORD = re.compile(r"([XYZCIJV])(-?\d{1,9}(?:\.\d{1,6})?)")


class InstructionName(StrEnum):
    """First words of instructions."""

    FORMAT = "MCX314"
    PULSES = "PULSES"
    GO = "GO"
    LINE = "LINE"
    CLOCKWISE = "CW"
    COUNTER_CLOCKWISE = "CCW"
    OUT = "OUT"
    OSC = "OSC"
    DWELL = "DWELL"
    END = "END"


#: Instructions that move axes along a path at a drive speed.
SEGMENTS = frozenset(
    {InstructionName.LINE, InstructionName.CLOCKWISE, InstructionName.COUNTER_CLOCKWISE}
)

#: Instructions that move axes.
MOTIONS = SEGMENTS | {InstructionName.GO}


class BadLine(Exception):
    """Raised for a line that is not an instruction."""


@dataclass(frozen=True, slots=True)
class Instruction:
    """One line of a program; a comment has no name."""

    name: InstructionName | None
    words: dict[str, float]  #: number of each word, by its letter
    joined: bool = False  #: begins without a stop after the segment before
    output: int = -1  #: output that it switches, -1 for none
    on: bool = False
    number: int = 0  #: milliseconds of a dwell, or version of the format

    def pulses(self, letter: str) -> int:
        """Return the pulses of a word, 0 if there is none."""
        return int(self.words.get(letter, 0))

    @property
    def ways(self) -> tuple[int, int, int, int]:
        """Signed pulses of X, Y, Z and C."""
        x, y, z, c = (self.pulses(letter) for letter in AXES)
        return x, y, z, c


COMMENT = Instruction(None, {})


def parse(line: str) -> Instruction:
    """Return the instruction of a program line.

    Raises
    ------
    BadLine
        The line is not an instruction.
    """
    if line.startswith(";"):
        return COMMENT
    first, *rest = line.split(" ")
    try:
        name = InstructionName(first)
    except ValueError:
        raise BadLine(line) from None
    match name:
        case InstructionName.FORMAT | InstructionName.DWELL:
            if len(rest) == 1 and rest[0].isdecimal() and len(rest[0]) <= 6:
                return Instruction(name, {}, number=int(rest[0]))
        case InstructionName.OUT:
            if len(rest) == 2 and rest[0].isdecimal() and rest[1] in ("ON", "OFF"):
                return Instruction(name, {}, output=int(rest[0]), on=rest[1] == "ON")
        case InstructionName.OSC:
            if len(rest) == 1 and rest[0] in ("ON", "OFF"):
                return Instruction(name, {}, on=rest[0] == "ON")
        case InstructionName.END:
            if not rest:
                return Instruction(name, {})
        case _:
            joined = bool(rest) and rest[-1] == "JOIN" and name in SEGMENTS
            return Instruction(name, _words(line, rest[:-1] if joined else rest), joined)
    raise BadLine(line)


def _words(line: str, texts: list[str]) -> dict[str, float]:
    words: dict[str, float] = {}
    for text in texts:
        match = _WORD.fullmatch(text)
        if match is None or match[1] in words:
            raise BadLine(line)
        words[match[1]] = float(match[2])
    return words
