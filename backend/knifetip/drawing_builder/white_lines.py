"""Find lines that are not visible because they are white on a white page.

White lines on a dark background are visible, and so are the lines of a drawing that has no others:
its background may be outside the file.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import Final

import numpy as np

from knifetip.geometry.columns import F64, Bool

#: Least value of each component of a colour, 0 … 255, that looks white: 98 %.
_WHITE: Final = 250
#: Number of dark areas that are compared with a white line: the largest ones.
_BACKGROUNDS: Final = 32


def is_white(colour: int) -> bool:
    """Return whether a colour, 0xRRGGBB or ``UNKNOWN_COLOUR``, is at least 98 % white."""
    return colour >= 0 and min(colour >> 16, colour >> 8 & 255, colour & 255) >= _WHITE


def unseen_white_lines(
    strokes: Sequence[int | None], fills: Sequence[int | None], box: F64, *, page: int | None
) -> Bool:
    """Return the mask, (p,), of the paths whose stroke is white on a white page.

    Parameters
    ----------
    strokes, fills
        Colours of stroke and fill of each of p paths, in the order in which they are painted; None
        for no paint.
    box : (p, 4)
        Bounding box of each path.
    page
        Colour of the page; None if the file states none.
    """
    unseen = np.zeros(len(strokes), bool)
    is_white_line = [stroke is not None and is_white(stroke) for stroke in strokes]
    others = sum(stroke is not None for stroke in strokes) > sum(is_white_line)
    if not others or not any(is_white_line) or (page is not None and not is_white(page)):
        return unseen
    backgrounds: list[tuple[float, ...]] = []
    for path, (white, fill) in enumerate(zip(is_white_line, fills, strict=True)):
        low_x, low_y, high_x, high_y = one = tuple(box[path].tolist())
        unseen[path] = white and not any(
            low_x >= dark[0] and low_y >= dark[1] and high_x <= dark[2] and high_y <= dark[3]
            for dark in backgrounds
        )
        if fill is not None and not is_white(fill) and high_x > low_x and high_y > low_y:
            backgrounds.append(one)
            if len(backgrounds) > _BACKGROUNDS:
                backgrounds.remove(min(backgrounds, key=_area))
    return unseen


def _area(box: tuple[float, ...]) -> float:
    return (box[2] - box[0]) * (box[3] - box[1])
