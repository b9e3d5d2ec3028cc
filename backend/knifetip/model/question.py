"""Question: a decision that the user must make."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.messages import Message, printable


@dataclass(frozen=True, slots=True)
class Question:
    """A decision that the user must make before a drawing can be compiled."""

    kind: str  #: "unit", "line-type" or "tool"
    message: Message  #: the question, with measures that help to answer it
    choices: tuple[str, ...]  #: possible answers
    edges: tuple[int, ...] = ()  #: rows of the drawing that it concerns
    layer: str = ""  #: the layer that it concerns, "" for none
    colour: int = 0  #: the colour index that it concerns, 0 for none

    @property
    def text(self) -> str:
        """The question in English."""
        return str(self.message)

    def as_json(self) -> dict[str, object]:
        """Return the question as plain data, with the code and arguments of its message."""
        return {
            **self.message.as_json(),
            "kind": self.kind,
            "choices": list(self.choices),
            "edges": list(self.edges),
            "layer": printable(self.layer),
            "colour": self.colour,
        }
