"""evidence: what all that a drawing says and shows tells of its unit.

    Drawing -> UnitFinding: the unit, or that it must be asked, and the evidence for each

The header is one witness among several.  Each kind of evidence gives every unit a weight, the
logarithm of a likelihood counted from the unit that it speaks for least; they are added up.  What
the header states stands if it leads; another unit is decided only where it leads by far, and
everything else is asked, with the likeliest unit first.
"""

from __future__ import annotations

import math

import numpy as np

from knifetip.model.drawing import Drawing
from knifetip.model.unit import MILLIMETRES, NAMES, UnitEvidence, UnitFinding
from knifetip.units import weights
from knifetip.units.lengths import (
    Lengths,
    by_features,
    by_grid,
    by_paper,
    by_size,
    lengths,
    measure,
)
from knifetip.units.mixed import by_parts
from knifetip.units.words import by_words


def judge(drawing: Drawing) -> UnitFinding:
    """Return what unit a drawing is in, as far as it can be known.

    Numbers are taken as the file has them, so evidence and unit are the same whatever unit the
    drawing was read in; the warnings are about that unit, where it has one.
    """
    evidence = _by_header(drawing) + _by_hints(drawing)
    warnings: tuple[str, ...] = ()
    with np.errstate(all="ignore"):
        found = lengths(drawing)
        shown = found.longer > 0.0 and math.isfinite(found.longer)
        told: tuple[UnitEvidence, ...] = ()
        if shown:
            words = by_words(drawing, found)
            told = words.evidence
            evidence += [
                *by_size(found),
                *by_features(found),
                *by_paper(found),
                *by_grid(found),
                *told,
            ]
            warnings = (*words.warnings, *by_parts(drawing))
    total = dict.fromkeys(MILLIMETRES, 0.0)
    for one in evidence:
        total[one.unit] += one.weight
    ranking = sorted(total, key=lambda unit: -total[unit])
    margin = total[ranking[0]] - total[ranking[1]]
    if not shown:
        unit = drawing.stated
    elif len(drawing) < weights.THIN_EDGES and drawing.stated and not told:
        low, high = weights.THIN_SIZE
        fits = low <= found.longer * MILLIMETRES[drawing.stated] <= high
        unit = drawing.stated if fits else ""
    else:
        # On a page without a physical size round numbers may be pixels: only words decide.
        sized = all(hint.says != "pixels" for hint in drawing.hints)
        certain = sized or any(one.unit == ranking[0] for one in told)
        doubtful = bool(warnings) or not certain
        unit = _decided(drawing.stated, ranking[0], margin, doubtful=doubtful)
    if shown:
        lead = 0.0 if not drawing.unit else total[ranking[0]] - total[drawing.unit]
        warnings = (*_contradictions(drawing, found, ranking[0], lead), *warnings)
    return UnitFinding(
        unit,
        bool(unit),
        tuple(sorted((one for one in evidence if one.weight > 0.05), key=_heaviest)),
        tuple(ranking),
        margin,
        warnings,
    )


def _heaviest(one: UnitEvidence) -> float:
    return -one.weight


def _decided(stated: str, best: str, margin: float, *, doubtful: bool) -> str:
    """Return the unit that the evidence decides on, empty where it does not.

    Where parts of a sheet are drawn at different scales only the header's own word is believed.
    """
    if stated and best == stated:
        return stated if margin >= weights.STANDS else ""
    far = weights.OVERRULES if stated else weights.DECIDES
    return best if margin >= far and not doubtful else ""


def _contradictions(drawing: Drawing, found: Lengths, best: str, lead: float) -> list[str]:
    """Say it where the unit that the drawing is read in is not the header's, or not the likeliest.

    Parameters
    ----------
    lead
        By how much the likeliest unit leads the drawing's.
    """

    def size(unit: str) -> str:
        scale = MILLIMETRES[unit]
        return f"{measure(found.width * scale)} × {measure(found.height * scale)} mm"

    warnings = []
    unit = drawing.unit
    if unit and drawing.stated and unit != drawing.stated:
        warnings.append(
            f"The header states {NAMES[drawing.stated]}, which would make the drawing "
            f"{size(drawing.stated)}; it is read in {NAMES[unit]}: {size(unit)}."
        )
    if unit and best not in (unit, drawing.stated) and lead >= weights.STANDS:
        warnings.append(
            f"What is drawn speaks for {NAMES[best]}: {size(best)}; it is read in {NAMES[unit]}: "
            f"{size(unit)}."
        )
    return warnings


def _by_header(drawing: Drawing) -> list[UnitEvidence]:
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


def _by_hints(drawing: Drawing) -> list[UnitEvidence]:
    evidence = []
    for hint in drawing.hints:
        favoured, weight = weights.HINTS[hint.says]
        evidence += [
            UnitEvidence(unit, f"the header has {hint.text}", weight, "header") for unit in favoured
        ]
    return evidence
