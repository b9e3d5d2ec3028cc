"""by_rule: decide the line type of edges whose style has a rule in the profile.

The rule decides unless the shape contradicts it: a crease cannot be the outline of a blank.
"""

from __future__ import annotations

from typing import Final

from knifetip.classification.decision.conventions import FOLD_TYPES
from knifetip.classification.decision.decision import Decision
from knifetip.classification.decision.role_types import IGNORED_CONFIDENCE, likeliest_type
from knifetip.classification.decision.style_evidence import StyleEvidence
from knifetip.classification.shape.roles import HOLES, NOT_CARTON, Role
from knifetip.messages import Message
from knifetip.model.dieline import LineType

#: Roles that are so certain that they override rules.
_OVERRIDING_ROLES: Final = (Role.ARROW, Role.LEGEND)
#: Confidence that a profile swaps cut and crease, if it seems to.
_SWAPPED: Final = 0.74
#: Line types that a closed line inside a panel may have, besides cut.
_CLOSED_IN_PANEL: Final = (LineType.PERFORATION, LineType.COMBI, LineType.HALF_CUT)


def decide_by_rule(evidence: StyleEvidence, style: int, role: Role) -> Decision:
    """Return the decision that follows from a style's profile rule and the role of its edges.

    If the shape contradicts the rule, the decision has a low confidence, or a different line
    type with the line type of the rule as an alternative.  ``style`` is the index of the style,
    and ``role`` the role of the edges in the drawing's shape.
    """
    kind = LineType(int(evidence.matches.line_type[style]))
    confidence = float(evidence.matches.confidence[style])
    rule = Message(
        "classification.rule",
        profile=evidence.profile.name,
        rule=evidence.matches.conditions[style],
    )
    if kind == LineType.UNCLASSIFIED:
        return Decision(kind, 0.0, rule)
    if evidence.swapped and kind != LineType.IGNORED:
        return _decide_swapped(evidence.swapped, rule, kind, role)
    if not evidence.has_outline or role in (Role.UNKNOWN, Role.OPEN):
        return Decision(kind, confidence, rule, by_rule=True)
    if role in _OVERRIDING_ROLES and kind != LineType.IGNORED:
        reason = Message("classification.contradicted", rule=rule, reason=role.message)
        return Decision(LineType.IGNORED, IGNORED_CONFIDENCE[role], reason, (kind,))
    against, instead = _contradiction(evidence, kind, confidence, style, role)
    if against:
        both = Message("classification.role-against", role=role.message, against=against)
        reason = Message("classification.contradicted", rule=rule, reason=both)
        return Decision(kind, min(confidence, 0.5), reason, instead)
    return Decision(kind, confidence, rule, by_rule=True)


def _decide_swapped(swapped: Message, rule: Message, kind: LineType, role: Role) -> Decision:
    """Return the decision where the profile seems to swap cut and crease.

    All edges that a rule cuts or folds have one decision, so that one answer confirms the swap.
    ``swapped`` is why the profile seems to swap them, ``rule`` the clause that names the rule,
    ``kind`` its line type, and ``role`` the role of the edges.
    """
    reason = Message("classification.contradicted", rule=rule, reason=swapped)
    if role in NOT_CARTON or kind not in (LineType.CUT, *FOLD_TYPES):
        return Decision(kind, 0.3, reason)
    other = LineType.CREASE if kind == LineType.CUT else LineType.CUT
    return Decision(other, _SWAPPED, reason, (kind,))


def _contradiction(
    evidence: StyleEvidence, kind: LineType, confidence: float, style: int, role: Role
) -> tuple[Message | None, tuple[LineType, ...]]:
    """Return why the shape contradicts a profile rule, and the other possible line types.

    If nothing contradicts the rule, the message is None and the tuple of line types is empty.
    ``kind`` and ``confidence`` are the line type that the rule gives and the confidence in the
    rule; ``style`` and ``role`` are the style and the role of the edges.
    """
    weak = confidence < 0.9
    if kind == LineType.IGNORED:
        if role in (Role.OUTLINE, Role.DIVIDER):
            kinds = (likeliest_type(role), LineType.CUT)
            return Message("classification.must-be-processed"), kinds
        return None, ()
    if role in (Role.STRAY, Role.DEBRIS):
        return Message("classification.closes-nothing"), (LineType.IGNORED,)
    if role in NOT_CARTON:
        return Message("classification.not-made"), (LineType.IGNORED,)
    if kind == LineType.CUT:
        if role == Role.DIVIDER and weak and evidence.only_divides[style]:
            return Message("classification.none-closes"), (LineType.CREASE,)
        return None, ()
    if role == Role.OUTLINE or (role == Role.MARK and weak):
        return Message("classification.board-ends"), (LineType.CUT,)
    if role in (*HOLES, Role.INNER) and kind not in _CLOSED_IN_PANEL:
        return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
    if role in (Role.FREE, Role.SLIT) and weak and kind == LineType.CREASE:
        return Message("classification.divides-panels", type=kind.word), (LineType.CUT,)
    return None, ()
