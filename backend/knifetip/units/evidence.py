"""evidence: find the unit of a drawing from all evidence together.

The result is a ``UnitFinding``: the unit, or none if the user must choose, and the evidence.  The
candidates are all units that the program supports, such as mm, in and pt.  The header of the file
is one kind of evidence among several.  Each kind gives every candidate a weight: the natural
logarithm of its likelihood relative to the least likely candidate.  The weights of all kinds are
added to a total weight for each candidate.  The unit that the header states is kept if its total
weight is the greatest by a margin.  A unit that the header does not state is chosen only by a
larger margin.  Otherwise the user must choose.
"""

from __future__ import annotations

import math
from collections.abc import Iterable

import numpy as np

from knifetip.messages import Message
from knifetip.model.drawing import Drawing
from knifetip.model.unit import DRAWN_IN, MILLIMETRES, UnitEvidence, UnitFinding
from knifetip.units import weights
from knifetip.units.corner_loops import loop_evidence
from knifetip.units.lengths import (
    Lengths,
    drawing_lengths,
    feature_evidence,
    grid_evidence,
    paper_evidence,
    size_evidence,
)
from knifetip.units.mixed_scales import mixed_scale_warnings
from knifetip.units.text_evidence import text_evidence


def find_unit(drawing: Drawing) -> UnitFinding:
    """Return the unit of a drawing, the evidence for all candidate units, and warnings.

    The unit is empty if the evidence is not conclusive.  The evidence is computed from the
    coordinates in the file, so it does not depend on the unit in which the drawing was read.  The
    warnings report contradictions between the unit in which the drawing was read and the evidence,
    and parts of the drawing that have different scales.
    """
    evidence = _header_evidence(drawing) + _hint_evidence(drawing)
    warnings: tuple[Message, ...] = ()
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
                *loop_evidence(drawing, found.longer),
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
        # Round numbers on a page without a physical size may be pixels: only texts are conclusive,
        # and only if they do not suit another unit of pages as well.
        sized = all(hint.kind != "pixels" for hint in drawing.hints)
        certain = sized or _text_lead(from_texts, ranking[0]) >= weights.STATED_MARGIN
        doubtful = bool(warnings) or not certain
        unit = _choose_unit(drawing.stated, ranking[0], margin, doubtful=doubtful)
    if has_size:
        lead = 0.0 if not drawing.unit else total[ranking[0]] - total[drawing.unit]
        if drawing.unit == drawing.stated and drawing.unit not in DRAWN_IN:
            # Round numbers are no evidence against points and pixels that the format defines.
            lead = min(lead, _text_lead(from_texts, ranking[0]))
        warnings = (*_contradictions(drawing, found, ranking[0], lead), *warnings)
    return UnitFinding(
        unit,
        bool(unit),
        tuple(sorted((one for one in evidence if one.weight > 0.05), key=_by_weight)),
        tuple(ranking),
        margin,
        warnings,
    )


def _text_lead(evidence: Iterable[UnitEvidence], unit: str) -> float:
    """Return the weight of the texts for a unit, minus their greatest weight for another unit."""
    total = dict.fromkeys(MILLIMETRES, 0.0)
    for one in evidence:
        total[one.unit] += one.weight
    return total[unit] - max(total[other] for other in total if other != unit)


def _by_weight(one: UnitEvidence) -> float:
    return -one.weight


def _choose_unit(stated: str, best: str, margin: float, *, doubtful: bool) -> str:
    """Return the unit that the evidence supports; empty if the evidence is not conclusive.

    The total weight of a unit is the sum of the weights of all evidence for it.

    ``stated``: unit that the header states, empty for none.
    ``best``: the likeliest unit: the unit with the greatest total weight.
    ``margin``: total weight of the likeliest unit minus total weight of the second likeliest unit.
    ``doubtful``: whether parts of the sheet have different scales, or the drawing has no physical
    size. If so, only the unit that the header states can be returned.
    """
    if stated and best == stated:
        return stated if margin >= weights.STATED_MARGIN else ""
    far = weights.OVERRULE_MARGIN if stated else weights.DECISION_MARGIN
    return best if margin >= far and not doubtful else ""


def _contradictions(drawing: Drawing, lengths: Lengths, best: str, lead: float) -> list[Message]:
    """Return a warning for each contradiction to the unit in which the drawing was read.

    There may be one warning that the header states a different unit, and one that the evidence
    supports a third unit, which is neither the unit of the drawing nor the unit in the header.  The
    list is empty if the drawing has no unit.

    ``lengths``: lengths of the edges, and size, of the drawing.
    ``best``: the likeliest unit: the unit with the greatest total weight of evidence.
    ``lead``: total weight of the likeliest unit minus the total weight of the unit of the drawing.
    """
    if not drawing.unit:
        return []
    warnings = []
    unit, stated = drawing.unit, drawing.stated
    width, height = lengths.size_in(unit)
    if stated and unit != stated:
        stated_width, stated_height = lengths.size_in(stated)
        warnings.append(
            Message(
                "unit.read-against-header",
                stated=stated,
                stated_width=stated_width,
                stated_height=stated_height,
                unit=unit,
                width=width,
                height=height,
            )
        )
    if best not in (unit, stated) and lead >= weights.STATED_MARGIN:
        best_width, best_height = lengths.size_in(best)
        warnings.append(
            Message(
                "unit.read-against-evidence",
                best=best,
                best_width=best_width,
                best_height=best_height,
                unit=unit,
                width=width,
                height=height,
            )
        )
    return warnings


def _header_evidence(drawing: Drawing) -> list[UnitEvidence]:
    """Return the evidence for each candidate unit from the header of the file.

    The weight of a candidate is computed from a fraction: how many of the carton drawings whose
    header states the same unit, or states no unit if this one states none, are really in the
    candidate unit.  The least likely candidate has the weight 0 and no entry in the list.
    """
    fractions = weights.STATED[drawing.stated]
    least = min(fractions.values())
    return [
        UnitEvidence(unit, _header_message(drawing.stated, unit, fractions[unit]), weight, "header")
        for unit in MILLIMETRES
        if (weight := math.log(fractions[unit] / least)) > 0.0
    ]


def _header_message(stated: str, unit: str, fraction: float) -> Message:
    """Return the message that states how often drawings with a given header are in ``unit``.

    ``stated``: the unit that the header states, empty for none.
    ``fraction``: fraction (0…1) of the drawings whose header states ``stated`` that are in
    ``unit``.
    """
    if not stated:
        return Message("unit.share-unstated", unit=unit, percent=100.0 * fraction)
    return Message("unit.share-stated", stated=stated, unit=unit, percent=100.0 * fraction)


def _hint_evidence(drawing: Drawing) -> list[UnitEvidence]:
    """Return the evidence for candidate units from settings in the file that do not state the unit.

    An example of such a setting is the choice between metric and imperial measures in a DXF header.
    """
    evidence = []
    for hint in drawing.hints:
        favoured, weight = weights.HINTS[hint.kind]
        evidence += [UnitEvidence(unit, hint.message, weight, "header") for unit in favoured]
    return evidence
