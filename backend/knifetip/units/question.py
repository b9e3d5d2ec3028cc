"""question: build the question that asks the user for the unit of a drawing.

The possible answers are units, the likeliest one first, each with the size that the drawing would
have in this unit.  The question also states the evidence for the likeliest unit.
"""

from __future__ import annotations

from typing import Final

from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.question import Question
from knifetip.model.unit import DRAWN_IN, MILLIMETRES, UnitFinding

#: Points and pixels are offered if their rank among the likeliest units, from 0, is below this.
_OFFERED: Final = 2
#: Evidence with less weight is not shown.
_LEAST_WEIGHT: Final = 1.0
#: Largest number of pieces of evidence in a question.
_SHOWN: Final = 2


def unit_question(drawing: Drawing, finding: UnitFinding) -> Question | None:
    """Return the question that asks the user for the unit.

    The result is None if the drawing has a unit, or no edges that have a size.  ``finding`` is the
    evidence for all candidate units of the drawing.
    """
    if drawing.unit or len(drawing) == 0:
        return None
    low_x, low_y, high_x, high_y = drawing.bounds
    width, height = float(high_x - low_x), float(high_y - low_y)
    # Pages without a physical size are often in points or pixels.
    page = any(hint.kind == "pixels" for hint in drawing.hints)
    choices = [
        unit
        for rank, unit in enumerate(finding.ranking)
        if unit in DRAWN_IN or rank < _OFFERED or page
    ]
    sizes = [
        Message(
            "question.unit-size",
            unit=unit,
            width=width * MILLIMETRES[unit],
            height=height * MILLIMETRES[unit],
        )
        for unit in choices
    ]
    heaviest = [
        one.message
        for one in finding.evidence
        if one.unit == choices[0] and one.weight >= _LEAST_WEIGHT and one.kind in ("grid", "words")
    ][:_SHOWN]
    evidence = Message("question.unit-evidence", unit=choices[0], evidence=heaviest)
    message = Message(
        "question.unit",
        reason=_reason(drawing, finding),
        sizes=sizes,
        evidence=evidence if heaviest else None,
    )
    return Question("unit", message, tuple(choices))


def _reason(drawing: Drawing, finding: UnitFinding) -> Message:
    """Return the message that explains why the unit of a drawing is not known.

    ``finding`` is the evidence for all candidate units.
    """
    if drawing.stated == finding.ranking[0]:
        return Message("question.unit-doubtful", stated=drawing.stated, other=finding.ranking[1])
    if drawing.stated:
        return Message("question.unit-contradicted", stated=drawing.stated)
    statement = drawing.evidence.arguments.get("stated", drawing.evidence)
    if statement.code in ("unit.header-unitless", "unit.header-missing"):
        return Message("question.unit-not-stated")
    return Message("question.unit-unreadable", evidence=statement)
