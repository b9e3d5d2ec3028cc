"""decision: the line type that is decided for edges, and whether it is certain enough.

A decision with a confidence below ``MIN_CONFIDENCE`` becomes a question that has the best guess as
its first choice.
"""

from __future__ import annotations

from dataclasses import dataclass
from typing import Final

from knifetip.messages import Message
from knifetip.model.dieline import LineType

#: Decisions with less confidence become questions.
MIN_CONFIDENCE: Final = 0.8


@dataclass(frozen=True, slots=True)
class Decision:
    """The line type decided for the edges of one style in one role, with confidence and reason.

    A style is a combination of layer, colour and dash pattern; a role is what an edge is in the
    shape of the drawing, such as outline or hole.
    """

    kind: LineType  #: the best guess
    confidence: float  #: 0 … 1
    reason: Message  #: the rule or the evidence
    others: tuple[LineType, ...] = ()  #: other possible line types, the likeliest first
    by_rule: bool = False  #: whether a rule decides and nothing contradicts it

    @property
    def needs_answer(self) -> bool:
        """Whether the user must decide: the confidence is too low or the line type is unknown."""
        unsure = self.confidence < MIN_CONFIDENCE and not self.by_rule
        return unsure or self.kind == LineType.UNCLASSIFIED
