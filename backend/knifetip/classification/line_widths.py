"""line_widths: find out where the widths of lines tell edges of one style apart.

Many authors draw cuts with thick and folds with thin lines.  Widths that differ by chance, for
example because each part of a drawing was scaled on its own, say nothing about line types.
"""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.geometry.columns import I32, I64
from knifetip.geometry.unique_rows import unique_rows
from knifetip.model.drawing import NO_LINE_WIDTH

#: Widths that differ by at most this much look alike (1/100 mm).
_ALIKE: Final = 2
#: Width at which most programs draw a line for which a DXF file states none (1/100 mm).
_DEFAULT: Final = 25
#: Largest number of widths that distinguish the edges of a style; more are chance.
_MOST: Final = 4
#: Least number of edges for each width, on average, if a style has three widths or more.
_EDGES: Final = 3


def distinguishing_widths(line_width: I32, *style: I32 | I64) -> I32:
    """Return for each of n edges the number of its line width among the edges of its style, (n,).

    Edges of a style whose line widths look different have different numbers, from 1 on in the order
    of their widths.  The number is 0 for all edges of a style whose widths look alike, or are so
    many that they are chance.

    Parameters
    ----------
    line_width : (n,)
        Line width of each edge, as in ``Drawing``.
    style
        One or more integer columns, (n,) each; edges with equal values have one style.
    """
    if len(line_width) == 0 or (line_width == line_width[0]).all():
        return np.zeros(len(line_width), np.int32)
    first, row = unique_rows(*style, line_width)
    _, style_of = unique_rows(*(column[first] for column in style))
    stated = line_width[first]
    width = np.where(stated == NO_LINE_WIDTH, _DEFAULT, stated)
    order = np.lexsort((width, style_of))
    width, style_of, edges = width[order], style_of[order], np.bincount(row)[order]
    begins_style = np.diff(style_of, prepend=-1) > 0
    look = np.cumsum(begins_style | (np.diff(width, prepend=width[0]) > _ALIKE))
    number = look - look[begins_style][style_of] + 1
    widths = np.zeros(len(stated), np.int64)
    np.maximum.at(widths, style_of, number)
    average = np.bincount(style_of, edges, len(stated)) / np.maximum(widths, 1)
    distinguish = (widths == 2) | ((widths > 2) & (widths <= _MOST) & (average >= _EDGES))
    result = np.zeros(len(stated), np.int32)
    result[order] = np.where(distinguish[style_of], number, 0)
    return result[row]
