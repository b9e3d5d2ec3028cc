"""lengths: parse lengths with units in attributes and styles of an SVG.

For example, ``parse_length`` returns 12.5 and "mm" for "12.5mm"; ``to_pixels`` converts such a text
to pixels of 1/96 in.
"""

from __future__ import annotations

import math
import re
from typing import Final

from knifetip.formats.invalid_content import InvalidContent

#: CSS pixels in one unit; 96 pixels are one inch.
PIXELS: Final[dict[str, float]] = {
    "": 1.0,
    "px": 1.0,
    "mm": 96.0 / 25.4,
    "cm": 96.0 / 2.54,
    "in": 96.0,
    "pt": 96.0 / 72.0,
    "pc": 16.0,
    "q": 96.0 / 101.6,
}

_LENGTH: Final = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([A-Za-z%]*)\s*")


def parse_length(text: str) -> tuple[float, str]:
    """Return the number and the unit of a length.

    The unit is in lower case, and empty if the text has no unit.

    Raises
    ------
    InvalidContent
        The text is not a finite number with an optional unit.
    """
    match = _LENGTH.fullmatch(text)
    if match is None or not math.isfinite(value := float(match[1])):
        raise InvalidContent("import.bad-value", value=text[:30])
    return value, match[2].lower()


def to_pixels(text: str, full_length: float = 0.0, font_size: float = 16.0) -> float:
    """Return the length that is written in ``text``, in CSS pixels (1/96 inch).

    Parameters
    ----------
    text
        Number with an optional unit, such as "12.5mm" or "50%".
    full_length
        The length to which percentages refer (pixels).
    font_size
        The length of one ``em`` (pixels).

    Raises
    ------
    InvalidContent
        The text is not a length.
    """
    try:
        # Fast path: most lengths have no unit.
        if math.isfinite(value := float(text)):
            return value
    except ValueError:
        pass
    value, unit = parse_length(text)
    if unit == "%":
        return value * full_length / 100.0
    if unit in ("em", "rem"):
        return value * font_size
    if unit == "ex":
        return value * font_size / 2.0
    if unit not in PIXELS:
        raise InvalidContent("import.value-unit", value=text[:30])
    return value * PIXELS[unit]
