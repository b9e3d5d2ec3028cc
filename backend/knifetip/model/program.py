"""Record of a program: its bytes, and for each program line the move that the line commands."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import I32, freeze


@dataclass(frozen=True, eq=False, slots=True)
class Program:
    """A program for one controller, with the move of the tool path that each program line commands.

    ``source`` contains the row of this move in the tool path, or -1 for program lines without a
    move.
    """

    text: bytes  #: all program lines, each with a newline at its end
    dialect: str
    source: I32  #: (lines,) row in the tool path, -1 for program lines without a move

    def __post_init__(self) -> None:
        count = self.text.count(b"\n")
        object.__setattr__(self, "source", freeze(self.source, np.int32, count))

    def __len__(self) -> int:
        return len(self.source)

    def lines(self) -> list[bytes]:
        """Return the lines of the program as bytes without newlines."""
        return self.text.split(b"\n")[:-1]
