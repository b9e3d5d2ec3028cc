"""role: what an edge can be in its net, and in what words that is said."""

from __future__ import annotations

from enum import IntEnum
from typing import Final


class Role(IntEnum):
    """What an edge is in its net."""

    UNKNOWN = 0
    OUTLINE = 1
    HOLE = 2
    DIVIDER = 3
    SLIT = 4
    FREE = 5
    STRAY = 6
    FRAME = 7
    TABLE = 8
    MARK = 9
    INNER = 10
    OPEN = 11
    ARROW = 12
    BLEED = 13
    LETTER = 14
    SPECK = 15
    SLOT = 16
    AROUND = 17
    NAMED = 18
    LEGEND = 19

    @property
    def words(self) -> str:
        """What the page says of it."""
        return _SAID[self]


#: What stands round or on a carton and is no part of it.
ASIDE: Final = (
    Role.STRAY,
    Role.FRAME,
    Role.TABLE,
    Role.ARROW,
    Role.BLEED,
    Role.LETTER,
    Role.SPECK,
    Role.AROUND,
    Role.NAMED,
    Role.LEGEND,
)

#: What closes round something that falls out of a panel.
HOLES: Final = (Role.HOLE, Role.SLOT)

_SAID: Final = {
    Role.UNKNOWN: "its shape tells nothing",
    Role.OUTLINE: "closes the outline of a blank",
    Role.HOLE: "closes a hole in a panel",
    Role.DIVIDER: "divides two panels",
    Role.SLIT: "begins at another line and ends inside a panel",
    Role.FREE: "lies free inside a panel",
    Role.STRAY: "lies outside every blank",
    Role.FRAME: "frames the whole drawing",
    Role.TABLE: "stands beside a text: a title block, a dimension or a label",
    Role.MARK: "closes a shape much smaller than the blank",
    Role.INNER: "lies inside a hole, or divides one",
    Role.OPEN: "belongs to an outline that does not close",
    Role.ARROW: "has an arrowhead, or belongs to a line that has",
    Role.BLEED: "runs round a blank at the same distance everywhere, as a bleed does",
    Role.LETTER: "stands in a row of small shapes, as letters do",
    Role.SPECK: "lies outside every blank, by itself, and is small",
    Role.SLOT: "closes a slot or a round hole in a panel",
    Role.AROUND: "runs round a whole carton",
    Role.LEGEND: "lies outside every blank, beside the name of a kind of line: a legend",
    Role.NAMED: "is no line of the carton by its name, and the outlines close without it",
}
