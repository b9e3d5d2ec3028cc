"""LineRules: a classification profile, the customer's words for cut, crease and the rest."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType


@dataclass(frozen=True, slots=True)
class LineRule:
    """If everything that it names matches, the edge has its line type.

    Patterns are shell globs, matched without regard to case; an empty tuple matches all.
    """

    line_type: LineType
    layer: tuple[str, ...] = ()
    colour: tuple[int, ...] = ()  #: AutoCAD colour indices
    linetype: tuple[str, ...] = ()
    entity: tuple[str, ...] = ()  #: LINE, ARC, TEXT …

    @property
    def words(self) -> str:
        """The rule in words, as the page shows it: ``layer "FOLDS", colour 3``."""
        parts = []
        if self.layer:
            parts.append("layer " + " or ".join(f'"{name}"' for name in self.layer))
        if self.colour:
            parts.append("colour " + " or ".join(str(index) for index in self.colour))
        if self.linetype:
            parts.append("linetype " + " or ".join(f'"{name}"' for name in self.linetype))
        if self.entity:
            parts.append("entity " + " or ".join(self.entity))
        return ", ".join(parts) or "everything"


@dataclass(frozen=True, slots=True)
class LineRules:
    """The rules of a profile, in order: the first that matches decides."""

    name: str
    title: str
    rules: tuple[LineRule, ...]
