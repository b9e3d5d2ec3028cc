"""LineRules: a classification profile, a customer's rules from styles to line types."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType


@dataclass(frozen=True, slots=True)
class LineRule:
    """A rule: edges that match all its conditions have its line type.

    Patterns are shell globs that ignore case; an empty tuple matches all edges.  The condition on
    colour matches by colour index or by true colour.
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
        """The conditions as text: ``layer "FOLDS", colour 3``."""
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
    """The rules of a profile, in order: the first rule that matches an edge applies."""

    name: str
    title: str
    rules: tuple[LineRule, ...]


@dataclass(frozen=True, slots=True)
class ProposedRule:
    """A rule that gives the user's overrides and contradicts no other edge."""

    rule: LineRule
    explains: tuple[int, ...]  #: overridden rows that it covers
    changes: tuple[int, ...]  #: undecided rows that it would decide
