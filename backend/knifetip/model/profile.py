"""Records of a classification profile: rules that assign line types to edges.

A rule has conditions on the layer, colour, dash pattern, entity kind and block of an edge.
"""

from __future__ import annotations

from dataclasses import dataclass

from knifetip.messages import Message
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
    def conditions(self) -> Message:
        """The conditions of the rule, such as ``layer "FOLDS", colour 3``."""
        conditions = []
        if self.layer:
            conditions.append(Message("rule.layer", patterns=map(_quote_pattern, self.layer)))
        if self.colour or self.true_colour:
            colours = [str(index) for index in self.colour]
            colours += [f"#{colour:06x}" for colour in self.true_colour]
            conditions.append(Message("rule.colour", colours=colours))
        if self.linetype:
            conditions.append(Message("rule.linetype", patterns=map(_quote_pattern, self.linetype)))
        if self.entity:
            conditions.append(Message("rule.entity", kinds=self.entity))
        if self.block:
            conditions.append(Message("rule.block", patterns=map(_quote_pattern, self.block)))
        if not conditions:
            return Message("rule.everything")
        return Message("rule.conditions", conditions=conditions)


@dataclass(frozen=True, slots=True)
class LineRules:
    """The rules of a profile in order; the first rule that matches an edge is used."""

    name: str
    title: str
    rules: tuple[LineRule, ...]


def _quote_pattern(pattern: str) -> str:
    return f'"{pattern}"'


@dataclass(frozen=True, slots=True)
class ProposedRule:
    """A rule that is proposed for a profile because the user set line types of edges by hand.

    No classified edge with a different line type matches the rule.
    """

    rule: LineRule
    explains: tuple[int, ...]  #: rows of overridden edges that the rule matches
    changes: tuple[int, ...]  #: rows of undecided edges that the rule would change
