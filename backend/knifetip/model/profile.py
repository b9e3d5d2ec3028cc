"""LineRules: a classification profile, the customer's words for cut, crease and the rest."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType


@dataclass(frozen=True, slots=True)
class LineRule:
    """If everything that it names matches, the edge has its line type.

    Patterns are shell globs, matched without regard to case; an empty tuple matches all.  A colour
    is met by an index or by a true colour, whichever of the two the rule and the edge have.
    """

    line_type: LineType
    layer: tuple[str, ...] = ()
    colour: tuple[int, ...] = ()  #: AutoCAD colour indices
    linetype: tuple[str, ...] = ()
    entity: tuple[str, ...] = ()  #: LINE, ARC, TEXT …
    true_colour: tuple[int, ...] = ()  #: 0xRRGGBB
    block: tuple[str, ...] = ()  #: the block that holds the entity

    @property
    def words(self) -> str:
        """The rule in words, as the page shows it: ``layer "FOLDS", colour 3``."""
        parts = []
        if self.layer:
            parts.append("layer " + " or ".join(f'"{name}"' for name in self.layer))
        if self.colour or self.true_colour:
            colours = [str(index) for index in self.colour]
            colours += [f"#{colour:06x}" for colour in self.true_colour]
            parts.append("colour " + " or ".join(colours))
        if self.linetype:
            parts.append("linetype " + " or ".join(f'"{name}"' for name in self.linetype))
        if self.entity:
            parts.append("entity " + " or ".join(self.entity))
        if self.block:
            parts.append("block " + " or ".join(f'"{name}"' for name in self.block))
        return ", ".join(parts) or "everything"


@dataclass(frozen=True, slots=True)
class LineRules:
    """The rules of a profile, in order: the first that matches decides."""

    name: str
    title: str
    rules: tuple[LineRule, ...]


@dataclass(frozen=True, slots=True)
class ProposedRule:
    """A rule that would have given what somebody corrected by hand, and contradicts nothing."""

    rule: LineRule
    explains: tuple[int, ...]  #: corrected rows that it covers
    changes: tuple[int, ...]  #: further rows that it would decide, which nobody has yet
