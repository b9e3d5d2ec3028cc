"""words: what the words on the sheet tell of its unit.

    Drawing, Lengths -> a weight for each unit, and how many times larger dimensions are than drawn

A number that is a length of the drawing ties the unit of the number to the unit of the file: "350"
beside an edge of 13.78 makes the file inches and the words millimetres.  Many lengths and small
numbers meet by chance, so each number is also tried at scales that no unit explains, and weighs
only by how much more often it meets than that.
"""

from __future__ import annotations

import math
import re
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, Bool
from knifetip.model.drawing import Drawing, Inscription
from knifetip.model.unit import DRAWN_IN, MILLIMETRES, NAMES, UnitEvidence, factor
from knifetip.units import weights
from knifetip.units.lengths import Lengths, evidence
from knifetip.units.numbers import Mention, mentions, scales, statement

#: Words beyond these are not read, and lengths beyond these not counted.
_WORDS: Final = 1000
_MENTIONS: Final = 60
#: A number meets a length that differs by less than this share.
_NEAR: Final = 3e-4
#: Scales at which a number meets a length by chance only.
_BY_CHANCE: Final = np.exp(np.linspace(-3.7, 3.7, 89)) * 1.0137
#: Scales of dimensions that differ by more than this are two.
_OTHER_SCALE: Final = 0.02
#: What stands for the measure in a dimension's own words.
_MEASURED: Final = re.compile(r"<>\s*(?P<unit>mm|cm|m|in(?:ch(?:es)?)?|\"|ft|')(?!\w)", re.I)
_SHOWN: Final = {'"': "in", "inch": "in", "inches": "in", "'": "ft"}


@dataclass(frozen=True, slots=True)
class Words:
    """What words on the sheet tell."""

    evidence: tuple[UnitEvidence, ...]
    warnings: tuple[str, ...]


@dataclass(frozen=True, slots=True)
class _Number:
    mention: Mention
    measure: float  #: of the dimension that it stands at, in file units; NaN where there is none


def by_words(drawing: Drawing, found: Lengths) -> Words:
    """Return what the words on the sheet tell of the unit."""
    scale = factor(drawing.unit)
    numbers: dict[tuple[float, str, float], _Number] = {}
    said: dict[str, str] = {}
    drawn_at: dict[tuple[int, int], None] = {}
    for words in drawing.inscriptions[:_WORDS]:
        if unit := statement(words.text):
            said.setdefault(unit, words.text)
        drawn_at.update(dict.fromkeys(scales(words.text)))
        for number in _numbers(words, scale):
            key = (number.mention.value, number.mention.unit, round(number.measure, 6))
            if math.isnan(number.measure):
                key = (*key[:2], 0.0)
            if len(numbers) < _MENTIONS:
                numbers.setdefault(key, number)
    told = [
        UnitEvidence(unit, f"the sheet says {_quoted(text)}", weights.STATEMENT, "words")
        for unit, text in said.items()
    ]
    if numbers:
        told += _by_numbers(list(numbers.values()), found, list(said))
    warnings = _scales_of(list(numbers.values()))
    other = [f"{one}:{two}" for one, two in drawn_at if one != two]
    if other:
        warnings.append(f"The sheet mentions the scale {', '.join(other[:3])}.")
    return Words(tuple(told), tuple(warnings))


def _numbers(words: Inscription, scale: float) -> Iterable[_Number]:
    measure = words.measure / scale
    if measured := _MEASURED.search(words.text):
        unit = measured["unit"].lower()
        if measure > 0.0:
            yield _Number(
                Mention(measured[0], measure, _SHOWN.get(unit, unit), 1e-3 * measure), measure
            )
        return
    for mention in mentions(words.text):
        yield _Number(mention, measure if measure > 0.0 else math.nan)


def _by_numbers(
    numbers: Sequence[_Number], found: Lengths, said: Sequence[str]
) -> list[UnitEvidence]:
    sides = np.append(found.value, [found.width, found.height])
    ratio_of = {
        (unit, written): MILLIMETRES[written] / MILLIMETRES[unit]
        for unit in MILLIMETRES
        for written in DRAWN_IN
    }
    ratios = np.array(sorted({round(ratio, 9) for ratio in ratio_of.values()}))
    column = {pair: int(np.argmin(np.abs(ratios - ratio))) for pair, ratio in ratio_of.items()}
    # (numbers, ratios): the logarithm of how much likelier what is seen is than by chance.
    gain = np.zeros((len(numbers), len(ratios)))
    hits = np.zeros((len(numbers), len(ratios)), bool)
    for row, number in enumerate(numbers):
        own = np.array([number.measure])
        against, meant = (
            (sides, weights.MEANT) if math.isnan(own[0]) else (own, weights.OVERWRITTEN)
        )
        chance = float(_meets(number.mention, _BY_CHANCE, against, found.exact[0]).mean())
        # A single length is met at one scale in 89, however lucky the choice of scales.
        chance = min(max(chance, 0.012), meant)
        hits[row] = _meets(number.mention, ratios, against, found.exact[0])
        gain[row] = np.where(
            hits[row], math.log(meant / chance), math.log((1.0 - meant) / (1.0 - chance))
        )
    told = np.any(hits, axis=1)
    if not told.any():
        return []
    gain, hits = gain[told], hits[told]
    mention = [number.mention for number, kept in zip(numbers, told, strict=True) if kept]
    gain *= min(1.0, weights.NUMBERS / len(mention))
    bare = np.array([not one.unit for one in mention])
    believed = dict(weights.BARE)
    if said:
        # Words about the unit of the numbers are about those without one.
        believed = {unit: 0.97 if unit in said else 0.01 for unit in believed}
    weight, text = {}, {}
    for unit in MILLIMETRES:
        sure = sum(
            float(gain[row, column[unit, one.unit]]) for row, one in enumerate(mention) if one.unit
        )
        parts = {
            written: math.log(share) + float(gain[bare, column[unit, written]].sum())
            for written, share in believed.items()
        }
        likely = max(parts, key=parts.__getitem__)
        weight[unit] = sure
        if bare.any():
            weight[unit] += float(np.logaddexp.reduce(list(parts.values())))
        met = [
            f"{one.text}{'' if one.unit else f' ({NAMES[likely]})'}"
            for row, one in enumerate(mention)
            if hits[row, column[unit, one.unit or likely]]
        ]
        listed = ", ".join(met[:4]) + (" …" if met[4:] else "")
        text[unit] = (
            f"in {NAMES[unit]} {len(met)} of {len(mention)} numbers on the sheet are lengths "
            f"of the drawing{f': {listed}' if listed else ''}"
        )
    return evidence("words", weight, text)


def _meets(mention: Mention, ratios: F64, against: F64, exact: float) -> Bool:
    value = mention.value * ratios
    near = np.maximum(np.maximum(exact, mention.half * ratios), _NEAR * value)
    # A number of few places meets much: half a millimetre in five is no match.
    near = np.minimum(near, 0.01 * value)
    met: Bool = np.any(np.abs(against[:, None] - value) <= near, axis=0)
    return met


def _scales_of(numbers: Sequence[_Number]) -> list[str]:
    """Say it where some dimensions are drawn at another scale than the rest."""
    ratio = np.array(
        [
            number.mention.value * MILLIMETRES[number.mention.unit or "mm"] / number.measure
            for number in numbers
            if not math.isnan(number.measure) and number.mention.value >= 1.0
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
    larger = f"{times:.3g} times smaller" if times > 1.0 else f"{1.0 / times:.3g} times larger"
    return [
        f"Dimensions do not agree on the scale: {len(groups[1])} of them are drawn {larger} than "
        f"{len(groups[0])} others."
    ]


def _quoted(text: str) -> str:
    return f"“{text[:60].strip()}{'…' if len(text) > 60 else ''}”"
