"""Convert RGB colours to the nearest colour of the AutoCAD colour index (0xE02020 → 1, red)."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

#: Marks paint without a single colour, such as a pattern, a gradient or an ink.
UNKNOWN_COLOUR: Final = -1

#: Least opacity of visible paint: with less, an object cannot be told from a white page.
VISIBLE: Final = 0.02

#: Colours 1 to 7 of AutoCAD's index, which are the same in all programs.
_INDEX: Final = (
    (1, 0xFF0000),
    (2, 0xFFFF00),
    (3, 0x00FF00),
    (4, 0x00FFFF),
    (5, 0x0000FF),
    (6, 0xFF00FF),
    (7, 0xFFFFFF),
    (7, 0x000000),
)


@lru_cache(maxsize=4096)
def nearest_index(true_colour: int) -> int:
    """Return the colour of the AutoCAD colour index, from 1 to 7, that is nearest to an RGB colour.

    ``true_colour`` is 0xRRGGBB.  The result is 7 for ``UNKNOWN_COLOUR``.
    """
    if true_colour < 0:
        return 7

    def off(other: int) -> int:
        return sum(
            ((true_colour >> bits & 255) - (other >> bits & 255)) ** 2 for bits in (0, 8, 16)
        )

    return min(_INDEX, key=lambda one: off(one[1]))[0]
