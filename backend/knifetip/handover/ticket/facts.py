"""facts: what a job ticket states, without its layout on the page."""

from __future__ import annotations

from typing import NamedTuple

from knifetip.messages import Message


class Accepted(NamedTuple):
    """A shortfall of the program that somebody has accepted."""

    message: Message  #: the shortfall
    by: str  #: who accepted it; may be empty
    at: float  #: when (seconds since 1970)
    reason: str


class StationUse(NamedTuple):
    """A station that the program uses, and the tool that must be in it."""

    number: int
    name: str
    kind: str  #: name of the kind of tool, see ``model.tool.KINDS``
    tool: Message | None  #: its dimensions; None if the machine is not known any more
    length: float  #: length that it works in the board in one copy (mm)
    seconds: float | None  #: machine time of one copy (s), with the moves to its tracks


class TypeLength(NamedTuple):
    """Length of the edges of one line type in a drawing."""

    line_type: str  #: word of the line type
    length: float  #: mm


class TicketFacts(NamedTuple):
    """What a job ticket states about a job.  Times are in seconds since 1970, lengths in mm."""

    job: str  #: id
    state: str
    printed: float  #: time at which the ticket is made
    address: str  #: URL of the station page
    order: str  #: number of the order in another system; may be empty
    customer: str
    due: float | None
    notes: str
    drawing: str  #: name
    revision: int
    is_changed: bool  #: whether the drawing has other line types or sizes than when it was ordered
    machine: str  #: title
    board: str  #: title
    caliper: float | None
    sheet: tuple[float, float] | None  #: width and height; None if they are not given
    margins: tuple[float, float]  #: of the drawing from the left and from the lower edge
    corner: tuple[float, float] | None  #: where the lower left corner lies on the table
    copies: int
    seconds: float  #: machine time of one copy (s); 0 if there is no program
    lines: int  #: lines of the program; 0 if there is none
    summary: dict[str, float] | None  #: of the verdict, see ``verdict_summary``; None without one
    accepted: tuple[Accepted, ...] = ()
    stations: tuple[StationUse, ...] = ()
    lengths: tuple[TypeLength, ...] = ()
    registration: Message | None = None  #: how a printed sheet lies; None for a sheet without marks
