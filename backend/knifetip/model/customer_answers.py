"""Records of what the drawings of one customer have taught: answers, and what follows from them."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from typing import Any

from knifetip.model.dieline import LineType


@dataclass(frozen=True, slots=True)
class Look:
    """What the edges of one question have in common, in all drawings of a customer.

    Edges of one look usually have the same line type in all drawings of the customer.
    """

    layer: str  #: name or series of names, in lower case; "" for layers whose names mean nothing
    colour: int  #: AutoCAD colour index
    true_colour: int  #: 0xRRGGBB; -1 for none
    linetype: str  #: dash pattern, in lower case
    line_width: int  #: 1/100 mm; -1 if widths distinguish no edges of this look


@dataclass(frozen=True, slots=True)
class LookUse:
    """Edges of one look in one drawing that have one line type for one reason."""

    look: Look
    #: codes of the reason why the edges were asked about, joined by "/"; "" for edges that were
    #: decided without an answer
    reason: str
    line_type: LineType
    edges: int


@dataclass(frozen=True, slots=True)
class TaughtDrawing:
    """A drawing of a customer whose questions were answered."""

    name: str  #: file name
    sha256: str  #: of the file
    uses: tuple[LookUse, ...]
    unit: str = ""  #: that a user gave to the file, see ``model.unit``; "" for none


@dataclass(frozen=True, slots=True)
class LearnedUnit:
    """The unit that a customer's drawings give to a file that states none."""

    unit: str
    drawings: tuple[str, ...]  #: names of the files whose answers agree, the newest first


@dataclass(frozen=True, slots=True)
class LearnedAnswer:
    """The line type that a customer's drawings give to the open edges of a look."""

    look: Look
    reason: str  #: as in ``LookUse``; "" for all reasons
    line_type: LineType
    drawings: tuple[str, ...]  #: names of the files whose answers agree, the newest first
    #: whether these drawings suffice; otherwise the shape of the edges must suggest the same
    sure: bool

    def as_json(self) -> dict[str, Any]:
        """Return the answer as JSON data; the line type is a word."""
        return {**asdict(self), "line_type": self.line_type.word, "drawings": list(self.drawings)}

    @classmethod
    def from_json(cls, plain: dict[str, Any]) -> LearnedAnswer:
        """Return the answer from the JSON data that ``as_json`` returned."""
        return cls(
            Look(**plain["look"]),
            plain["reason"],
            LineType.from_word(plain["line_type"]),
            tuple(plain["drawings"]),
            plain["sure"],
        )


def use_json(use: LookUse) -> dict[str, Any]:
    """Return a use as JSON data; the line type is a word."""
    return {**asdict(use), "line_type": use.line_type.word}


def use_from_json(plain: dict[str, Any]) -> LookUse:
    """Return the use from the JSON data that ``use_json`` returned."""
    return LookUse(
        Look(**plain["look"]),
        plain["reason"],
        LineType.from_word(plain["line_type"]),
        plain["edges"],
    )


def learned_text(learned: tuple[LearnedAnswer, ...]) -> str:
    """Return learned answers as JSON text for an ``Interpretation``; "" for none."""
    return json.dumps([one.as_json() for one in learned]) if learned else ""


def learned_from_text(text: str) -> tuple[LearnedAnswer, ...]:
    """Return the learned answers in the text that ``learned_text`` returned."""
    return tuple(LearnedAnswer.from_json(one) for one in json.loads(text)) if text else ()
