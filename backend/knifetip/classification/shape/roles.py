"""roles: the roles that an edge can have in the shape of a drawing."""

from __future__ import annotations

from enum import IntEnum
from typing import Final

from knifetip.messages import Message


class Role(IntEnum):
    """The role of an edge in the shape of a drawing, such as outline, divider or hole."""

    UNKNOWN = 0  #: not examined
    OUTLINE = 1  #: closes the outline of a blank
    HOLE = 2  #: closes a hole in a panel
    DIVIDER = 3  #: lies between two panels
    SLIT = 4  #: starts at another line and ends inside a panel
    FREE = 5  #: lies inside a panel and touches nothing
    STRAY = 6  #: lies outside all blanks
    FRAME = 7  #: belongs to a frame round blanks
    TABLE = 8  #: belongs to a title block
    MARK = 9  #: closes a shape much smaller than a blank
    INNER = 10  #: lies inside a hole
    OPEN = 11  #: belongs to an outline that does not close
    ARROW = 12  #: belongs to an arrow
    BLEED = 13  #: follows the outline of a blank at a distance
    LETTER = 14  #: belongs to a word that was converted to lines
    DEBRIS = 15  #: short, and outside all blanks
    SLOT = 16  #: closes a slot or a round hole in a panel
    ENCLOSING = 17  #: surrounds a whole carton, and is neither frame nor bleed
    NAMED = 18  #: is an annotation by its layer's name
    LEGEND = 19  #: is a sample of a line type beside that type's name
    DIMENSION = 20  #: belongs to a dimension: a text beside it states its length
    LABELLED = 21  #: closes a shape with a text in or beside it: a label, or a small part
    MEASURED = 22  #: may be a dimension line, since a text beside it states its length

    @property
    def message(self) -> Message:
        """The clause that describes the role, such as "the edge closes the outline of a blank"."""
        return _MESSAGES[self]


#: Roles of edges that belong to no carton.
NOT_CARTON: Final = (
    Role.STRAY,
    Role.FRAME,
    Role.TABLE,
    Role.ARROW,
    Role.BLEED,
    Role.LETTER,
    Role.DEBRIS,
    Role.ENCLOSING,
    Role.NAMED,
    Role.LEGEND,
    Role.DIMENSION,
    Role.LABELLED,
    Role.MEASURED,
)

#: Roles of edges round a piece of waste that falls out of a panel.
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
    Role.DEBRIS: Message("classification.speck"),
    Role.SLOT: Message("classification.slot"),
    Role.ENCLOSING: Message("classification.around"),
    Role.NAMED: Message("classification.named"),
    Role.LEGEND: Message("classification.legend"),
    Role.DIMENSION: Message("classification.dimension"),
    Role.LABELLED: Message("classification.labelled"),
    Role.MEASURED: Message("classification.measured"),
}
