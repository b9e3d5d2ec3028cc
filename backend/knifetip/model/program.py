"""Program: the bytes for a controller, and the row of the toolpath for each line."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from knifetip.geometry.columns import I32, freeze


@dataclass(frozen=True, eq=False, slots=True)
class Program:
    """Bytes for one controller; line i of ``lines()`` came from Toolpath row ``source[i]``."""

    text: bytes  #: all lines, each ended by a newline
    dialect: str
    source: I32  #: (lines,) row in Toolpath, -1 for lines without a move

    def __post_init__(self) -> None:
        count = self.text.count(b"\n")
        object.__setattr__(self, "source", freeze(self.source, np.int32, count))

    def __len__(self) -> int:
        return len(self.source)

    def lines(self) -> list[bytes]:
        """Return the lines without their newlines."""
        return self.text.split(b"\n")[:-1]
