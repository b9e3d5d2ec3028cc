"""lengths: a length with its unit, as attributes and styles write it.

"12.5mm" -> 12.5, "mm"          "12.5mm" -> pixels of 1/96 in
"""

from __future__ import annotations

import math
import re
from typing import Final

#: Pixels to a unit, by CSS: 96 of them are an inch.
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


def length(text: str) -> tuple[float, str]:
    """Return a length's number and its unit in lower case, empty where none is written.

    Raises
    ------
    ValueError
        It is not a finite number with a unit or without one.
    """
    found = _LENGTH.fullmatch(text)
    if found is None or not math.isfinite(value := float(found[1])):
        raise ValueError(f"{text[:30]!r} is not a length")
    return value, found[2].lower()


def pixels(text: str, whole: float = 0.0, letter: float = 16.0) -> float:
    """Return a length in pixels.

    Parameters
    ----------
    whole
        What a percentage is taken of (pixels).
    letter
        The height of the letters around it, which ``em`` counts (pixels).

    Raises
    ------
    ValueError
        It is no length.
    """
    try:
        # Most lengths are bare numbers.
        if math.isfinite(value := float(text)):
            return value
    except ValueError:
        pass
    value, unit = length(text)
    if unit == "%":
        return value * whole / 100.0
    if unit in ("em", "rem"):
        return value * letter
    if unit == "ex":
        return value * letter / 2.0
    if unit not in PIXELS:
        raise ValueError(f"{text[:30]!r} has a unit that is not known")
    return value * PIXELS[unit]
