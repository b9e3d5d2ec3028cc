"""role: what an edge can be in its net, and how a message describes it."""

from __future__ import annotations

from enum import IntEnum
from typing import Final

from knifetip.messages import Message


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
    def message(self) -> Message:
        """How a message describes it."""
        return _MESSAGES[self]


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

_MESSAGES: Final = {
    Role.UNKNOWN: Message("classification.unknown"),
    Role.OUTLINE: Message("classification.outline"),
    Role.HOLE: Message("classification.hole"),
    Role.DIVIDER: Message("classification.divider"),
    Role.SLIT: Message("classification.slit"),
    Role.FREE: Message("classification.free"),
    Role.STRAY: Message("classification.stray"),
    Role.FRAME: Message("classification.frame"),
    Role.TABLE: Message("classification.table"),
    Role.MARK: Message("classification.mark"),
    Role.INNER: Message("classification.inner"),
    Role.OPEN: Message("classification.open"),
    Role.ARROW: Message("classification.arrow"),
    Role.BLEED: Message("classification.bleed"),
    Role.LETTER: Message("classification.letter"),
    Role.SPECK: Message("classification.speck"),
    Role.SLOT: Message("classification.slot"),
    Role.AROUND: Message("classification.around"),
    Role.NAMED: Message("classification.named"),
    Role.LEGEND: Message("classification.legend"),
}
