"""text_evidence: evidence for the unit from texts and dimensions on the sheet.

The result is a weight for each candidate unit, and warnings about scales.  A number on the sheet
that is the length of an edge relates the unit of the number to the unit of the file: with "350"
beside an edge of 13.78, the file is in inches and the text in millimetres.  Some numbers match a
length by chance.  How often this happens is measured at scales that are not the ratio of any two
units.  The rarer such chance matches are, the greater is the weight of a match.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.messages import Message
from knifetip.model.drawing import Annotation, Drawing
from knifetip.model.unit import DRAWN_IN, MILLIMETRES, UnitEvidence, factor
from knifetip.units import weights
from knifetip.units.lengths import Lengths, evidence_of_units
from knifetip.units.written_lengths import (
    WrittenLength,
    stated_unit,
    written_lengths,
    written_scales,
)

#: Largest number of texts and of written lengths that are used.
_TEXTS: Final = 1000
_NUMBERS: Final = 60
#: Largest number of matching numbers in a message.
_SHOWN: Final = 4
#: A number equals a length if their relative difference is smaller.
_TOLERANCE: Final = 3e-4
#: Scales at which a number matches a length by chance only.
_CHANCE_SCALES: Final = np.exp(np.linspace(-3.7, 3.7, 89)) * 1.0137
#: File units per unit of a written number, by the unit of the file and the unit of the number.
_RATIO_OF: Final = {
    (unit, written): MILLIMETRES[written] / MILLIMETRES[unit]
    for unit in MILLIMETRES
    for written in DRAWN_IN
}
_RATIOS: Final[F64] = np.array(sorted({round(ratio, 9) for ratio in _RATIO_OF.values()}))
#: The index in ``_RATIOS`` of each pair of units.
_COLUMN: Final = {
    pair: int(np.argmin(np.abs(_RATIOS - ratio))) for pair, ratio in _RATIO_OF.items()
}
#: Dimensions whose log scales differ by more than this have different scales.
_OTHER_SCALE: Final = 0.02
#: "<>" in the text of a dimension: the measured length, here followed by a unit.
_MEASURED: Final = re.compile(r"<>\s*(?P<unit>mm|cm|m|in(?:ch(?:es)?)?|\"|ft|')(?!\w)", re.I)
_UNIT_OF_SIGN: Final = {'"': "in", "inch": "in", "inches": "in", "'": "ft"}


@dataclass(frozen=True, slots=True)
class TextEvidence:
    """The evidence for units found in the texts of a drawing, and warnings about scales."""

    evidence: tuple[UnitEvidence, ...]
    warnings: tuple[Message, ...]


@dataclass(frozen=True, slots=True)
class _Number:
    """A length that is written in a text on the sheet.

    If the text belongs to a dimension, the record also contains the length that the dimension
    measures in the drawing, which is normally the written length.  Otherwise the measured length is
    NaN.
    """

    written: WrittenLength
    measure: (
        float  #: length that the dimension measures, in file units; NaN if the text is no dimension
    )


def text_evidence(drawing: Drawing, lengths: Lengths) -> TextEvidence:
    """Return the evidence for all candidate units, and warnings, from the texts of a drawing.

    ``lengths`` are the lengths of the edges of the drawing.
    """
    scale = factor(drawing.unit)
    numbers: dict[tuple[float, str, float], _Number] = {}
    statements: dict[str, str] = {}
    mentioned: dict[tuple[int, int], None] = {}
    for text in drawing.annotations[:_TEXTS]:
        if unit := stated_unit(text.text):
            statements.setdefault(unit, text.text)
        mentioned.update(dict.fromkeys(written_scales(text.text)))
        for number in _numbers(text, scale):
            key = (number.written.value, number.written.unit, round(number.measure, 6))
            if math.isnan(number.measure):
                key = (*key[:2], 0.0)
            if len(numbers) < _NUMBERS:
                numbers.setdefault(key, number)
    evidence = [
        UnitEvidence(
            unit, Message("unit.text-states", text=_shorten(line)), weights.STATEMENT, "words"
        )
        for unit, line in statements.items()
    ]
    if numbers:
        evidence += _number_evidence(list(numbers.values()), lengths, list(statements))
    warnings = _dimension_scale_warnings(list(numbers.values()))
    other = [f"{one}:{two}" for one, two in mentioned if one != two]
    if other:
        warnings.append(Message("unit.scale-mentioned", scales=other[:3]))
    return TextEvidence(tuple(evidence), tuple(warnings))


def _numbers(text: Annotation, scale: float) -> Iterable[_Number]:
    """Yield each length that is written in a text, with the length that its dimension measures.

    ``scale`` is the number of millimetres in one file unit; it converts the measured length to file
    units.  The measured length is NaN if the text does not belong to a dimension.
    """
    measure = text.measure / scale
    if measured := _MEASURED.search(text.text):
        unit = measured["unit"].lower()
        if measure > 0.0:
            yield _Number(
                WrittenLength(measured[0], measure, _UNIT_OF_SIGN.get(unit, unit), 1e-3 * measure),
                measure,
            )
        return
    for written in written_lengths(text.text):
        yield _Number(written, measure if measure > 0.0 else math.nan)


def _number_evidence(
    numbers: Sequence[_Number], lengths: Lengths, stated: Sequence[str]
) -> list[UnitEvidence]:
    """Return the evidence for each candidate unit from the numbers in texts that match lengths.

    A number matches if it equals the length of an edge after conversion between two units.  The
    list is empty if no number matches.

    ``lengths``: lengths of the edges, and size, of the drawing.
    ``stated``: units that texts on the sheet state for all dimensions.
    """
    gain, hits = _match(numbers, lengths)
    matched = np.any(hits, axis=1)
    if not matched.any():
        return []
    gain, hits = gain[matched], hits[matched]
    written = [number.written for number, kept in zip(numbers, matched, strict=True) if kept]
    gain *= min(1.0, weights.NUMBERS / len(written))
    bare = np.array([not one.unit for one in written])
    share_of = dict(weights.BARE)
    if stated:
        # Numbers without a unit have the unit that a text states for all dimensions.
        share_of = {unit: 0.97 if unit in stated else 0.01 for unit in share_of}
    weight: dict[str, float] = {}
    message: dict[str, Message] = {}
    for unit in MILLIMETRES:
        with_unit = sum(
            float(gain[row, _COLUMN[unit, one.unit]]) for row, one in enumerate(written) if one.unit
        )
        parts = {
            assumed: math.log(fraction) + float(gain[bare, _COLUMN[unit, assumed]].sum())
            for assumed, fraction in share_of.items()
        }
        likely = max(parts, key=parts.__getitem__)
        weight[unit] = with_unit
        if bare.any():
            weight[unit] += float(np.logaddexp.reduce(list(parts.values())))
        matches = [
            Message("unit.number", text=one.text)
            if one.unit
            else Message("unit.number-in", text=one.text, unit=likely)
            for row, one in enumerate(written)
            if hits[row, _COLUMN[unit, one.unit or likely]]
        ]
        message[unit] = _match_message(unit, matches, len(written))
    return evidence_of_units("words", weight, message)


def _match_message(unit: str, matches: Sequence[Message], count: int) -> Message:
    """Return the message that lists the numbers on the sheet that equal lengths of the drawing.

    ``count``: how many numbers on the sheet were compared with lengths.
    """
    if not matches:
        return Message("unit.no-number-matches", unit=unit, all=count)
    code = "unit.numbers-match-often" if len(matches) > _SHOWN else "unit.numbers-match"
    return Message(code, unit=unit, count=len(matches), all=count, numbers=matches[:_SHOWN])


def _match(numbers: Sequence[_Number], lengths: Lengths) -> tuple[F64, Bool]:
    """Compare n numbers with the lengths of the drawing, at each ratio in ``_RATIOS``.

    A ratio is the number of file units in the unit of a written number.

    ``numbers``: numbers in the texts on the sheet.  A number in the text of a dimension is compared
    only with the length that the dimension measures.
    ``lengths``: lengths of the edges, and size, of the drawing.
    Returns ``gain`` (n, ratios): log-likelihood ratio of the outcome, which is a match or no match:
    the logarithm of p / q, where p is the probability of the outcome if the number states a length
    of the drawing, and q its probability by chance; ``hits`` (n, ratios): whether the number,
    multiplied by the ratio, equals a length.
    """
    sides = np.append(lengths.value, [lengths.width, lengths.height])
    gain = np.zeros((len(numbers), len(_RATIOS)))
    hits = np.zeros((len(numbers), len(_RATIOS)), bool)
    for row, number in enumerate(numbers):
        own = np.array([number.measure])
        against, meant = (
            (sides, weights.IS_A_LENGTH) if math.isnan(own[0]) else (own, weights.OVERWRITTEN)
        )
        chance = float(_matches(number.written, _CHANCE_SCALES, against, lengths.exact[0]).mean())
        # One length matches at one of the 89 scales, whatever scales are chosen.
        chance = min(max(chance, 0.012), meant)
        hits[row] = _matches(number.written, _RATIOS, against, lengths.exact[0])
        gain[row] = np.where(
            hits[row], math.log(meant / chance), math.log((1.0 - meant) / (1.0 - chance))
        )
    return gain, hits


def _matches(written: WrittenLength, ratios: F64, lengths: F64, exact: float) -> Bool:
    """Return the mask of the ratios at which a written length equals a length in ``lengths``.

    The shape of the mask is (ratios,).

    ``ratios``: possible numbers of file units in the unit of the written length.
    ``lengths``: lengths in the drawing (file units).
    ``exact``: precision of the lengths in ``lengths`` (file units).
    """
    value = written.value * ratios
    near = np.maximum(np.maximum(exact, written.half * ratios), _TOLERANCE * value)
    # Numbers with few digits equal many lengths, so the tolerance is limited to 1 %.
    near = np.minimum(near, 0.01 * value)
    matched: Bool = np.any(np.abs(lengths[:, None] - value) <= near, axis=0)
    return matched


def _dimension_scale_warnings(numbers: Sequence[_Number]) -> list[Message]:
    """Return a warning if the dimensions have more than one drawing scale, else an empty list.

    The scale of a dimension is the length in its text divided by the length that it measures.
    ``numbers`` are the lengths in texts, with the lengths that their dimensions measure.
    """
    ratio = np.array(
        [
            number.written.value * MILLIMETRES[number.written.unit or "mm"] / number.measure
            for number in numbers
            if not math.isnan(number.measure) and number.written.value >= 1.0
        ]
    )
    if len(ratio) < 4:
        return []
    ratio = np.sort(ratio)
    parts = np.split(ratio, np.flatnonzero(np.diff(np.log(ratio)) > _OTHER_SCALE) + 1)
    groups = sorted((part for part in parts if len(part) >= 2), key=len, reverse=True)
    if len(groups) < 2:
        return []
    times = float(np.median(groups[1]) / np.median(groups[0]))
    code, times = (
        ("unit.dimensions-smaller", times)
        if times > 1.0
        else ("unit.dimensions-larger", 1.0 / times)
    )
    return [Message(code, count=len(groups[1]), others=len(groups[0]), factor=times)]


def _shorten(text: str) -> str:
    return f"{text[:60].strip()}{'…' if len(text) > 60 else ''}"
