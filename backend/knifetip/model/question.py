"""Record of a question: a decision about a drawing that only the user can make."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from knifetip.messages import Message, printable


@dataclass(frozen=True, slots=True)
class FollowingEdges:
    """Edges of one style that the answer to a question decides, besides those it asks about."""

    message: Message  #: the edges, and their line type by answer
    edges: tuple[int, ...]  #: rows of the edges
    layer: str  #: layer of the edges
    colour: int  #: colour index of the edges
    line_types: Mapping[str, str]  #: line type of the edges, by answer; other answers decide none

    def as_json(self) -> dict[str, object]:
        """Return the edges as JSON data, with the code and the arguments of their message."""
        return {
            **self.message.as_json(),
            "edges": list(self.edges),
            "layer": printable(self.layer),
            "colour": self.colour,
            "line_types": dict(self.line_types),
        }


@dataclass(frozen=True, slots=True)
class Question:
    """A question that the user must answer before a drawing can be compiled."""

    kind: str  #: "unit", "line-type" or "tool"
    message: Message  #: the question, with measured values that help to answer it
    choices: tuple[str, ...]  #: possible answers
    edges: tuple[int, ...] = ()  #: rows of the edges that the question concerns
    layer: str = ""  #: layer that the question concerns, "" for none
    colour: int = 0  #: colour index that the question concerns, 0 for none
    follows: tuple[FollowingEdges, ...] = ()  #: other edges that the answer decides

    @property
    def text(self) -> str:
        """The question in English."""
        return str(self.message)

    def as_json(self) -> dict[str, object]:
        """Return the question as JSON data, with the code and the arguments of its message."""
        return {
            **self.message.as_json(),
            "kind": self.kind,
            "choices": list(self.choices),
            "edges": list(self.edges),
            "layer": printable(self.layer),
            "colour": self.colour,
            "follows": [edges.as_json() for edges in self.follows],
        }
