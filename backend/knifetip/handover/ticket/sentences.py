"""sentences: the texts of a job ticket, made from its facts in a language."""

from __future__ import annotations

import math
from collections.abc import Iterator
from datetime import datetime
from typing import Final

from knifetip.handover.ticket.facts import Accepted, StationUse, TicketFacts
from knifetip.messages import Argument, Message, render
from knifetip.model.tool import CreaseWheel, Cutter, Knife, Laser, Tool, VCutter

#: Most accepted exceptions that a ticket lists.
_MOST_ACCEPTED: Final = 30
#: Times below this have a decimal (s); from here on they are rounded to 10 s and more.
_TENTHS_BELOW: Final = 9.95
#: Names of the kinds of tools.
_KINDS: Final = {
    "knife": "ticket.kind-knife",
    "crease-wheel": "ticket.kind-crease-wheel",
    "v-cutter": "ticket.kind-v-cutter",
    "cutter": "ticket.kind-cutter",
    "laser": "ticket.kind-laser",
}


def tool_message(tool: Tool) -> Message | None:
    """Return the dimensions by which a person recognises a tool; None for an unknown kind."""
    match tool:
        case Knife():
            code = "ticket.tool-oscillating" if tool.oscillating else "ticket.tool-blade"
            return Message(code, width=tool.blade_width, angle=tool.blade_angle)
        case CreaseWheel():
            return Message("ticket.tool-wheel", diameter=2.0 * tool.radius, width=tool.width)
        case VCutter():
            return Message(
                "ticket.tool-groove",
                tilt=tool.tilt,
                back=tool.back,
                half_width=tool.half_width,
            )
        case Cutter():
            return Message("ticket.tool-cutter", diameter=2.0 * tool.radius)
        case Laser():
            return Message("ticket.tool-laser", kerf=tool.kerf)
        case _:
            return None


def time_text(seconds: float) -> str:
    """Return a time in the time zone of the server: 2030-01-02 03:04 CET."""
    try:
        return datetime.fromtimestamp(seconds).astimezone().strftime("%Y-%m-%d %H:%M %Z")
    except (OverflowError, OSError, ValueError):
        return "–"


class Sentences:
    """The texts of one ticket in one language."""

    def __init__(self, facts: TicketFacts, language: str) -> None:
        self._facts = facts
        self._language = language

    def word(self, code: str, **arguments: Argument) -> str:
        """Return the text of a message."""
        return render(Message(code, **arguments), self._language)

    def rows(self) -> Iterator[tuple[str, str]]:
        """Yield title and text of the facts about order, drawing, board and machine."""
        facts = self._facts
        yield self.word("ticket.order"), facts.order or self.word("ticket.job", job=facts.job)
        yield self.word("ticket.customer"), facts.customer or self.word("ticket.no-value")
        yield (
            self.word("ticket.due"),
            self.word("ticket.no-value") if facts.due is None else time_text(facts.due),
        )
        code = "ticket.changed" if facts.is_changed else "ticket.revision"
        yield (
            self.word("ticket.drawing"),
            self.word(code, drawing=facts.drawing, revision=facts.revision),
        )
        board = facts.board
        if facts.caliper is not None:
            board = self.word("ticket.board-thickness", board=board, caliper=facts.caliper)
        yield self.word("ticket.board"), board
        yield self.word("ticket.sheet"), self._sheet()
        if facts.corner is not None:
            x, y = facts.corner
            code = "ticket.place-drawing" if facts.sheet is None else "ticket.place-at"
            yield self.word("ticket.place"), self.word(code, x=x, y=y)
        if facts.registration is not None:
            yield self.word("ticket.marks"), render(facts.registration, self._language)
        yield self.word("ticket.copies"), str(facts.copies)
        yield self.word("ticket.machine"), facts.machine
        yield self.word("ticket.times"), self._times()

    def _sheet(self) -> str:
        facts = self._facts
        if facts.sheet is None:
            return self.word("ticket.sheet-any")
        (width, height), (left, below) = facts.sheet, facts.margins
        return self.word("ticket.sheet-size", width=width, height=height, left=left, below=below)

    def _times(self) -> str:
        facts = self._facts
        if facts.seconds <= 0.0:
            return self.word("ticket.no-value")
        if facts.copies == 1:
            return self.duration(facts.seconds)
        each, total = (_duration(time) for time in (facts.seconds, facts.copies * facts.seconds))
        return self.word("ticket.times-all", each=each, all=total)

    def duration(self, seconds: float | None) -> str:
        """Return a duration as the page writes it: 7.4 s, 19 s, 1:05 min or 1:02 h."""
        return (
            self.word("ticket.no-value")
            if seconds is None
            else render(_duration(seconds), self._language)
        )

    def station(self, use: StationUse) -> tuple[str, str, str, str]:
        """Return station, tool, length and time of a station, as the columns of a table."""
        tool = self.word(_KINDS[use.kind])
        if use.tool is not None:
            tool = f"{tool}: {render(use.tool, self._language)}"
        length = self.word("ticket.metres", length=use.length / 1000.0)
        return f"T{use.number}  {use.name}", tool, length, self.duration(use.seconds)

    def line_types(self) -> list[tuple[str, str]]:
        """Return for each line type its name and a text with the length of its edges."""
        return [
            (
                one.line_type.upper(),
                self.word("ticket.line-type", type=one.line_type, length=one.length / 1000.0),
            )
            for one in self._facts.lengths
        ]

    @property
    def is_ready(self) -> bool:
        """Whether the program is accepted, so that the job may be made."""
        return self._facts.summary is not None and bool(self._facts.summary["accepted"])

    def verdict(self) -> str:
        """Return the verdict on the program in one sentence."""
        facts = self._facts
        if facts.lines == 0:
            return self.word("ticket.no-program", state=facts.state)
        if facts.summary is None:
            return self.word("ticket.no-verdict", state=facts.state)
        # Summaries of older versions have fewer figures.
        figures = {"faults": 0, "shortfalls": 0, "exceptions": 0, **facts.summary}
        if not figures["accepted"]:
            return self.word("ticket.refused", count=int(figures["faults"] + figures["shortfalls"]))
        measured = {name: figures[name] for name in ("deviation", "tolerance")}
        if figures["exceptions"]:
            return self.word("ticket.verified-except", **measured, count=int(figures["exceptions"]))
        return self.word("ticket.verified", **measured, overcut=figures["overcut"])

    def accepted(self) -> list[str]:
        """Return a sentence for each accepted exception, and how many more there are."""
        found = [self._accepted(one) for one in self._facts.accepted[:_MOST_ACCEPTED]]
        more = len(self._facts.accepted) - len(found)
        return [*found, self.word("ticket.more", count=more)] if more > 0 else found

    def _accepted(self, one: Accepted) -> str:
        return self.word(
            "ticket.accepted-by",
            finding=one.message,
            by=one.by or "–",
            at=time_text(one.at),
            reason=one.reason or "–",
        )


def _duration(seconds: float) -> Message:
    """Return a duration (s) in the steps of ``formatDuration`` of the page."""
    if seconds < _TENTHS_BELOW:
        return Message("ticket.tenths", seconds=max(seconds, 0.0))
    minutes, rest = divmod(math.floor(seconds + 0.5), 60)
    if minutes == 0:
        return Message("ticket.seconds", seconds=rest)
    if minutes < 60:
        return Message("ticket.minutes", time=f"{minutes}:{rest:02d}")
    return Message("ticket.hours", time=f"{minutes // 60}:{minutes % 60:02d}")
