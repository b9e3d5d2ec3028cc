"""swapped_rules: two rules of a profile that seem to swap cut and crease are one question.

The question is about the edges that close the outlines, which are certainly cut.  Its answer
confirms or refuses the swap, and so decides the edges of the other rule.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.classification.decision.conventions import FOLD_TYPES
from knifetip.geometry.columns import U8, Bool
from knifetip.messages import Message
from knifetip.model.dieline import Dieline, LineType
from knifetip.model.interpretation import NO_OVERRIDE

_CODES: Final = frozenset(
    f"classification.{name}" for name in ("swapped", "swapped-both", "swapped-like")
)


def swapped_types(dieline: Dieline) -> tuple[U8, U8]:
    """Return the guess for edges of swapped rules, and the line type of the rule, (n,) each.

    Both are 0 for other edges.
    """
    types = np.zeros((len(dieline.rules) + 1, 2), np.uint8)
    for number, (rule, others) in enumerate(zip(dieline.rules, dieline.alternatives, strict=False)):
        reason = rule.arguments.get("reason")
        if rule.code != "classification.contradicted" or not isinstance(reason, Message):
            continue
        if reason.code in _CODES and len(others) > 1:
            types[number] = others[:2]
    guess, own = types[dieline.rule].T
    return guess, own


def find_dependent(dieline: Dieline) -> Bool:
    """Return the mask of open edges that the answer to another question decides, (n,).

    They are edges that a rule cuts, while edges that a rule folds are open for the same reason.
    """
    guess, own = swapped_types(dieline)
    is_open = dieline.line_type == LineType.UNCLASSIFIED
    dependent: Bool = is_open & (own == LineType.CUT) & (guess != 0) & find_deciding(dieline).any()
    return dependent


def find_deciding(dieline: Dieline) -> Bool:
    """Return the mask of open edges whose answer decides those of the other rule, (n,)."""
    _, own = swapped_types(dieline)
    deciding: Bool = (dieline.line_type == LineType.UNCLASSIFIED) & np.isin(own, FOLD_TYPES)
    return deciding


def swapped_answers(decided: Dieline, overrides: U8) -> U8:
    """Return the line types that follow from the answer about swapped rules, (n,) uint8.

    The swap is confirmed or refused if the user gave all edges of one of the two rules the line
    type of the guess, or all of them that of the rule.  The result is ``NO_OVERRIDE`` elsewhere.

    Parameters
    ----------
    decided
        The dieline of n edges, before the user gave any line type.
    overrides : (n,) uint8
        Line type that the user gave to each edge, or ``NO_OVERRIDE``.
    """
    follows = np.full(len(overrides), NO_OVERRIDE, np.uint8)
    guess, own = swapped_types(decided)
    is_open = (decided.line_type == LineType.UNCLASSIFIED) & (guess != 0)
    cut = is_open & (own == LineType.CUT)
    folded = is_open & ~cut
    for answered, other in ((folded, cut), (cut, folded)):
        if not (answered.any() and other.any()):
            continue
        for meant in (guess, own):
            if (overrides[answered] == meant[answered]).all():
                follows[other] = meant[other]
    return follows
