"""Record of a user's choices for a job: corner types, sheet, and height of turns."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.corners import Corners
from knifetip.model.sheet import Sheet


@dataclass(frozen=True, slots=True)
class Choices:
    """The user's choices for a job, besides drawing, machine and board."""

    corners: Corners | None = None  #: corner types; None: the fastest on the machine
    sheet: Sheet | None = None  #: the sheet if it was cut to size
    #: height of the tool in turns above the board: the machine's "clearance", or the "least"
    lift: str = "clearance"
