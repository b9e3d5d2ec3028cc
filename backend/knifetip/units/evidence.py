"""evidence: find the unit of a drawing from all evidence together.

    Drawing -> UnitFinding: the unit, or none if the user must choose, and the evidence

The header is one kind of evidence among several.  Each kind gives every unit a weight: the
natural logarithm of its likelihood relative to the least likely unit.  The weights are added.
The unit that the header states is kept if it leads.  Another unit is chosen only if it leads by
a large margin.  Otherwise the user is asked, with the likeliest unit first.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, NAMES, UnitEvidence, UnitFinding
from knifetip.units import weights
from knifetip.units.lengths import (
    Lengths,
    drawing_lengths,
    feature_evidence,
    format_mm,
    grid_evidence,
    paper_evidence,
    size_evidence,
)
from knifetip.units.mixed_scales import mixed_scale_warnings
from knifetip.units.text_evidence import text_evidence


def find_unit(drawing: Drawing) -> UnitFinding:
    """Return the unit of a drawing, if the evidence is sufficient, and the evidence.

    The evidence is computed from the coordinates in the file, so it does not depend on the unit
    that the drawing was read in.  The warnings refer to that unit, if there is one.
    """
    evidence = _header_evidence(drawing) + _hint_evidence(drawing)
    warnings: tuple[str, ...] = ()
    with np.errstate(all="ignore"):
        found = drawing_lengths(drawing)
        has_size = found.longer > 0.0 and math.isfinite(found.longer)
        from_texts: tuple[UnitEvidence, ...] = ()
        if has_size:
            texts = text_evidence(drawing, found)
            from_texts = texts.evidence
            evidence += [
                *size_evidence(found),
                *feature_evidence(found),
                *paper_evidence(found),
                *grid_evidence(found),
                *from_texts,
            ]
            warnings = (*texts.warnings, *mixed_scale_warnings(drawing))
    total = dict.fromkeys(MILLIMETRES, 0.0)
    for one in evidence:
        total[one.unit] += one.weight
    ranking = sorted(total, key=lambda unit: -total[unit])
    margin = total[ranking[0]] - total[ranking[1]]
    if not has_size:
        unit = drawing.stated
    elif len(drawing) < weights.THIN_EDGES and drawing.stated and not from_texts:
        low, high = weights.THIN_SIZE
        fits = low <= found.longer * MILLIMETRES[drawing.stated] <= high
        unit = drawing.stated if fits else ""
    else:
        # Round numbers on a page without a physical size may be pixels: only texts are conclusive.
        sized = all(hint.kind != "pixels" for hint in drawing.hints)
        certain = sized or any(one.unit == ranking[0] for one in from_texts)
        doubtful = bool(warnings) or not certain
        unit = _choose_unit(drawing.stated, ranking[0], margin, doubtful=doubtful)
    if has_size:
        lead = 0.0 if not drawing.unit else total[ranking[0]] - total[drawing.unit]
        warnings = (*_contradictions(drawing, found, ranking[0], lead), *warnings)
    return UnitFinding(
        unit,
        bool(unit),
        tuple(sorted((one for one in evidence if one.weight > 0.05), key=_by_weight)),
        tuple(ranking),
        margin,
        warnings,
    )


def _by_weight(one: UnitEvidence) -> float:
    return -one.weight


def _choose_unit(stated: str, best: str, margin: float, *, doubtful: bool) -> str:
    """Return the unit that the evidence supports, empty if it is not conclusive.

    Parameters
    ----------
    doubtful
        Parts of the sheet have different scales, or there is no physical size.  Then only the
        unit that the header states can be returned.
    """
    if stated and best == stated:
        return stated if margin >= weights.STATED_MARGIN else ""
    far = weights.OVERRULE_MARGIN if stated else weights.DECISION_MARGIN
    return best if margin >= far and not doubtful else ""


def _contradictions(drawing: Drawing, found: Lengths, best: str, lead: float) -> list[str]:
    """Return warnings if the drawing's unit is neither the stated nor the likeliest one.

    Parameters
    ----------
    best
        The likeliest unit.
    lead
        Total weight of the likeliest unit minus that of the drawing's unit.
    """

    def size(unit: str) -> str:
        scale = MILLIMETRES[unit]
        return f"{format_mm(found.width * scale)} × {format_mm(found.height * scale)} mm"

    warnings = []
    unit = drawing.unit
    if unit and drawing.stated and unit != drawing.stated:
        warnings.append(
            f"The header states {NAMES[drawing.stated]}, which would make the drawing "
            f"{size(drawing.stated)}; it is read in {NAMES[unit]}: {size(unit)}."
        )
    if unit and best not in (unit, drawing.stated) and lead >= weights.STATED_MARGIN:
        warnings.append(
            f"The evidence supports {NAMES[best]}: {size(best)}; it is read in {NAMES[unit]}: "
            f"{size(unit)}."
        )
    return warnings


def _header_evidence(drawing: Drawing) -> list[UnitEvidence]:
    """Return the weight of each unit under the header's statement, or under no statement."""
    share = weights.STATED[drawing.stated]
    least = min(share.values())
    text = (
        f"the header states {NAMES[drawing.stated]}; of such drawings"
        if drawing.stated
        else "the file states no unit; of such drawings"
    )
    return [
        UnitEvidence(
            unit, f"{text} {100.0 * share[unit]:.3g} % are in {NAMES[unit]}", weight, "header"
        )
        for unit in MILLIMETRES
        if (weight := math.log(share[unit] / least)) > 0.0
    ]


def _hint_evidence(drawing: Drawing) -> list[UnitEvidence]:
    """Return the weights of the header's other variables that depend on the unit."""
    evidence = []
    for hint in drawing.hints:
        favoured, weight = weights.HINTS[hint.kind]
        evidence += [
            UnitEvidence(unit, f"the header has {hint.text}", weight, "header") for unit in favoured
        ]
    return evidence
