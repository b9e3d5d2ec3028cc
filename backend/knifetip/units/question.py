"""question: what must be asked about the unit of a drawing.

Drawing, UnitFinding -> Question: the size in each unit, the likeliest first, and why
"""

from __future__ import annotations

from typing import Final

from knifetip.model.drawing import Drawing
from knifetip.model.question import Question
from knifetip.model.unit import DRAWN_IN, MILLIMETRES, NAMES, UnitFinding
from knifetip.units.lengths import measure

#: Points and pixels are offered where only so many units are likelier.
_OFFERED: Final = 2
#: Evidence of less weight is not worth a word.
_WORTH: Final = 1.0
#: So many things that speak for the likeliest unit are told.
_TOLD: Final = 2


def question(drawing: Drawing, finding: UnitFinding) -> Question | None:
    """Return what must be asked about the unit, None where it is known."""
    if drawing.unit:
        return None
    low_x, low_y, high_x, high_y = drawing.bounds
    width, height = float(high_x - low_x), float(high_y - low_y)
    # A page without a physical size is in one of the two as often as not.
    page = any(hint.says == "pixels" for hint in drawing.hints)
    choices = [
        unit
        for place, unit in enumerate(finding.ranking)
        if unit in DRAWN_IN or place < _OFFERED or page
    ]
    sizes = [
        f"in {NAMES[unit]} {'the drawing is ' * (place == 0)}"
        f"{measure(width * MILLIMETRES[unit])} × {measure(height * MILLIMETRES[unit])} mm"
        for place, unit in enumerate(choices)
    ]
    text = ", ".join(sizes)
    likeliest = [
        one.text
        for one in finding.evidence
        if one.unit == choices[0] and one.weight >= _WORTH and one.kind in ("grid", "words")
    ][:_TOLD]
    because = f" What speaks most for {NAMES[choices[0]]}: {'; '.join(likeliest)}."
    return Question(
        "unit",
        f"{_why(drawing, finding)} {text[0].upper()}{text[1:]}.{because if likeliest else ''}",
        tuple(choices),
    )


def _why(drawing: Drawing, finding: UnitFinding) -> str:
    if drawing.stated == finding.ranking[0]:
        other = NAMES[finding.ranking[1]]
        return (
            f"The file says that its unit is {NAMES[drawing.stated]}, but by what is drawn it "
            f"could also be {other}."
        )
    if drawing.stated:
        return (
            f"The file says that its unit is {NAMES[drawing.stated]}, which what is drawn does "
            "not bear out."
        )
    if drawing.evidence.startswith("$INSUNITS = 0") or "no $INSUNITS" in drawing.evidence:
        return "The file does not say its unit."
    said, _, _ = drawing.evidence.partition("; ")
    return f"The file does not say a unit that is read ({said})."
