"""Records of a classification profile: rules that assign line types to edges by their style."""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.model.dieline import LineType


@dataclass(frozen=True, slots=True)
class LineRule:
    """A rule of a profile: an edge that matches all conditions gets the line type of the rule.

    Conditions on names are shell patterns that ignore case; an empty tuple matches every edge.  The
    condition on colour is met by the colour index or by the true colour.
    """

    line_type: LineType
    layer: tuple[str, ...] = ()
    colour: tuple[int, ...] = ()  #: AutoCAD colour indices
    linetype: tuple[str, ...] = ()
    entity: tuple[str, ...] = ()  #: LINE, ARC, TEXT …
    true_colour: tuple[int, ...] = ()  #: 0xRRGGBB
    block: tuple[str, ...] = ()  #: names of blocks that contain the entity

    @property
    def words(self) -> str:
        """The conditions of the rule as text, such as ``layer "FOLDS", colour 3``."""
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
    """The rules of a profile in order; the first rule that matches an edge is used."""

    name: str
    title: str
    rules: tuple[LineRule, ...]


@dataclass(frozen=True, slots=True)
class ProposedRule:
    """A rule proposed from the user's overrides, which contradicts no other edge of the drawing."""

    rule: LineRule
    explains: tuple[int, ...]  #: rows of overridden edges that the rule matches
    changes: tuple[int, ...]  #: rows of undecided edges that the rule would change
