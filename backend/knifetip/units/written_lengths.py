"""written_lengths: parse lengths, units and scales in texts on a sheet.

Examples of texts with lengths are "300 x 200 x 150 mm", '13 3/4"', "L=300" and "13,78 in".  Each
parsed length has its value, and its unit if one is written.  Dates, angles, scales, telephone
numbers and parts of names are skipped.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import Final

#: Larger numbers are not lengths of a carton, in any unit.
_LARGEST: Final = 20000.0

_UNIT_OF: Final = {
    "mm": "mm",
    "millimetre": "mm",
    "millimetres": "mm",
    "millimeter": "mm",
    "millimeters": "mm",
    "мм": "mm",
    "毫米": "mm",
    "cm": "cm",
    "centimetres": "cm",
    "centimeters": "cm",
    "zentimeter": "cm",
    "см": "cm",
    "厘米": "cm",
    "m": "m",
    "in": "in",
    "in.": "in",
    "inch": "in",
    "inches": "in",
    "zoll": "in",
    "pouces": "in",
    "pulgadas": "in",
    "英寸": "in",
    '"': "in",
    "''": "in",
    "″": "in",
    "”": "in",
    "ft": "ft",
    "feet": "ft",
    "'": "ft",
    "′": "ft",
}
_UNIT: Final = "|".join(re.escape(word) for word in sorted(_UNIT_OF, key=len, reverse=True))
_FRACTION_SIGNS: Final = {
    "½": " 1/2",
    "¼": " 1/4",
    "¾": " 3/4",
    "⅛": " 1/8",
    "⅜": " 3/8",
    "⅝": " 5/8",
    "⅞": " 7/8",
}
#: 1200, 12.5, 12,5, 13 3/4, 13-3/4, 3/4, but not within a word, a date or another number.
_NUMBER: Final = re.compile(
    r"(?<![\w.,:/\-Ø⌀°])(?<!\d )"
    r"(?:(?P<whole>\d{1,5})(?:-|\s+)(?P<up>\d{1,2})/(?P<down>2|4|8|16|32|64)(?!\d)"
    r"|(?P<alone>\d{1,2})/(?P<under>2|4|8|16|32|64)(?!\d)"
    r"|(?P<decimal>(?!0\d)\d{1,5}(?:[.,]\d{1,6})?))"
    rf"(?P<unit>\s?(?:{_UNIT})(?!\w))?"
    r"(?![\d°%:/])(?![.,\-]\d)(?![^\W\d_])",
    re.IGNORECASE,
)
#: The signs in 300x200x150, which separate numbers.
_TIMES: Final = re.compile(r"(?<=[\d\"'″m])\s*[x×*X]\s*(?=[\d.,]*\d)")
_LABEL: Final = re.compile(r"\b[A-Za-z]{1,9}\s*[=:]\s*(?=\d)")
_SCALE: Final = re.compile(r"\b(\d{1,4})\s?:\s?(\d{1,4})\b")
#: "Dimensions in mm", "Alle Maße in mm", "units: inches", "尺寸单位: 毫米".
_STATEMENT: Final = re.compile(
    r"(?:\bdim\w*|\bunits?\b|\bmeasure\w*|\bmaße?\b|\bmasse?\b|\bmaßeinheit|\beinheit\w*|\bcotes\b"
    r"|\bmisure\b|\bmedidas\b|размер\w*|单位|尺寸)[^\d\n]{0,30}?"
    r"(?<!\w)(?P<unit>mm|cm|inch(?:es)?|millimet(?:er|re)s?|zoll|мм|см|毫米|厘米|英寸)(?!\w)",
    re.IGNORECASE,
)


@dataclass(frozen=True, slots=True)
class WrittenLength:
    """A length as it is written in a text: its value, its unit (if it has one) and precision."""

    text: str  #: the length with its unit, as written
    value: float
    unit: str  #: unit that is written, empty for none
    half: float  #: half of the last written decimal place, the precision of the value


def written_lengths(text: str) -> list[WrittenLength]:
    """Return the lengths that are written in a text, in the order of the text."""
    for sign, fraction in _FRACTION_SIGNS.items():
        text = text.replace(sign, fraction)
    text = _SCALE.sub(" ", text)
    rows = _TIMES.sub("|", _LABEL.sub(" ", text))
    found: list[WrittenLength] = []
    joined: list[bool] = []
    for part in rows.split("|"):
        first = True
        for match in _NUMBER.finditer(part):
            one = _parse(match)
            if one is not None:
                found.append(one)
                joined.append(first and len(found) > 1)
            first = False
    # 300 x 200 x 150 mm: the unit at the end applies to all numbers.
    for row in range(len(found) - 1, 0, -1):
        if joined[row] and found[row].unit and not found[row - 1].unit:
            before = found[row - 1]
            found[row - 1] = WrittenLength(before.text, before.value, found[row].unit, before.half)
    return found


def _parse(match: re.Match[str]) -> WrittenLength | None:
    unit = _UNIT_OF[match["unit"].strip().lower()] if match["unit"] else ""
    if match["decimal"] is not None:
        written = match["decimal"].replace(",", ".")
        places = len(written.partition(".")[2])
        if match["decimal"].count(",") and places == 3:
            # 1,200 may be 1200 or 1.2.
            return None
        value, half = float(written), 0.5 * 10.0**-places
    else:
        # Fractions without a unit are inches.
        unit = unit or "in"
        up, down = match["up"] or match["alone"], match["down"] or match["under"]
        value = float(match["whole"] or 0) + float(up) / float(down)
        half = 0.5 / 64.0
    if not 0.0 < value <= _LARGEST:
        return None
    return WrittenLength(match[0].strip(), value, unit, half)


def stated_unit(text: str) -> str:
    """Return the unit that a text states for all dimensions, as in "all dimensions in mm".

    The unit is empty if the text states none.
    """
    match = _STATEMENT.search(text)
    return _UNIT_OF.get(match["unit"].lower().removesuffix(" "), "in") if match else ""


def written_scales(text: str) -> list[tuple[int, int]]:
    """Return the drawing scales that are written in a text, for example (1, 10) for "1:10".

    A scale is returned only if exactly one of its two numbers is 1.
    """
    return [
        (int(one), int(other))
        for one, other in _SCALE.findall(text)
        if (one == "1") != (other == "1")
    ]
