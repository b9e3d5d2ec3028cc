"""Record of a question: a decision about a drawing that only the user can make."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.messages import Message, printable


@dataclass(frozen=True, slots=True)
class Question:
    """A question that the user must answer before a drawing can be compiled."""

    kind: str  #: "unit", "line-type" or "tool"
    message: Message  #: the question, with measured values that help to answer it
    choices: tuple[str, ...]  #: possible answers
    edges: tuple[int, ...] = ()  #: rows of the edges that the question concerns
    layer: str = ""  #: layer that the question concerns, "" for none
    colour: int = 0  #: colour index that the question concerns, 0 for none

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
        }
