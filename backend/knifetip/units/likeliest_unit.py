"""likeliest_unit: choose the unit of a drawing for which the user has given none.

The result is the drawing in its likeliest unit, or in file units if the user must choose.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import UnitFinding
from knifetip.units.evidence import find_unit
from knifetip.units.rescale import rescale


def choose_unit(drawing: Drawing, read_in: Callable[[str], Drawing]) -> Drawing:
    """Return the drawing in the unit that the evidence supports.

    The unit that a DXF header states is kept unless a different unit is far likelier; the units
    that other formats state are always kept.  If the evidence is not conclusive, the drawing is
    returned in file units, with ``unit`` empty.

    Parameters
    ----------
    drawing
        The drawing, read without a unit from the user.
    read_in
        Function that reads the file of the drawing again in a given unit.  Scaling the drawing is
        not enough, because curves are fitted within a tolerance in mm when a file is read.
    """
    finding = find_unit(drawing)
    if finding.unit == drawing.unit:
        return drawing
    if drawing.unit and drawing.evidence.code != "unit.header":
        # Only the unit of a DXF header is doubted: it often comes from the template.
        return drawing
    better = read_in(finding.unit) if finding.unit else rescale(drawing, "")
    return replace(better, evidence=_unit_evidence(finding, drawing))


def _unit_evidence(finding: UnitFinding, drawing: Drawing) -> Message:
    """Return the message that explains why the unit that the file states was not kept.

    ``finding`` is the evidence for all candidate units of ``drawing``.
    """
    best = finding.ranking[0]
    if best == drawing.stated:
        return Message("unit.inconclusive", stated=drawing.evidence, unit=best)
    reason = next(one.message for one in finding.evidence if one.unit == best)
    return Message("unit.overruled", stated=drawing.evidence, unit=best, reason=reason)
