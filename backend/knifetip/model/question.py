"""Question: what the machine will not guess."""

from __future__ import annotations

from dataclasses import dataclass


@dataclass(frozen=True, slots=True)
class Question:
    """Something that somebody must decide before anything is cut."""

    kind: str  #: "unit", "line-type" or "tool"
    text: str  #: the question, with the measure that helps to answer it
    choices: tuple[str, ...]  #: possible answers
    edges: tuple[int, ...] = ()  #: rows of the drawing that it is about
    layer: str = ""  #: the layer that it is about, if it is about one
    colour: int = 0  #: the colour index that it is about, 0 if none

    def as_json(self) -> dict[str, object]:
        """Return the question as plain data."""
        return {
            "kind": self.kind,
            "text": self.text,
            "choices": list(self.choices),
            "edges": list(self.edges),
            "layer": self.layer,
            "colour": self.colour,
        }
