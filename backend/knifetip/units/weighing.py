"""weighing: the unit of a drawing for which the user has given none.

Drawing -> Drawing in its likeliest unit, or in file units where the unit must be asked
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import UnitFinding
from knifetip.units.evidence import judge
from knifetip.units.rescale import rescaled


def in_likeliest_unit(drawing: Drawing, read_in: Callable[[str], Drawing]) -> Drawing:
    """Return the drawing in the unit that the evidence supports, file and geometry together.

    The unit that the file states is kept unless another one is far likelier.  Where the evidence
    is not conclusive, the drawing is returned in file units, with ``unit`` empty.

    Parameters
    ----------
    drawing
        As it was read without a unit from the user.
    read_in
        Reads the same file again in a given unit: curves are fitted within a tolerance in mm, so
        that scaling the drawing would not do.
    """
    found = judge(drawing)
    if found.unit == drawing.unit:
        return drawing
    if drawing.unit and drawing.evidence.code != "unit.header":
        # Only the unit of a DXF header may be wrong: it often comes from the template.
        return drawing
    better = read_in(found.unit) if found.unit else rescaled(drawing, "")
    return replace(better, evidence=_outcome(found, drawing))


def _outcome(found: UnitFinding, drawing: Drawing) -> Message:
    best = found.ranking[0]
    if best == drawing.stated:
        return Message("unit.inconclusive", stated=drawing.evidence, unit=best)
    reason = next(one.text for one in found.evidence if one.unit == best)
    return Message("unit.overruled", stated=drawing.evidence, unit=best, reason=reason)
