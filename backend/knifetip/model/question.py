"""Question: what the machine will not guess."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.messages import Message, printable


@dataclass(frozen=True, slots=True)
class Question:
    """Something that somebody must decide before anything is cut."""

    kind: str  #: "unit", "line-type" or "tool"
    message: Message  #: the question, with the measures that help to answer it
    choices: tuple[str, ...]  #: possible answers
    edges: tuple[int, ...] = ()  #: rows of the drawing that it is about
    layer: str = ""  #: the layer that it is about, if it is about one
    colour: int = 0  #: the colour index that it is about, 0 if none

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
