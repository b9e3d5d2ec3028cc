"""line_widths: convert the widths with which a file draws its lines to the unit of a drawing."""

from __future__ import annotations

from typing import Final

import numpy as np

from knifetip.drawing_builder.columns import Style
from knifetip.geometry.columns import F64, I32
from knifetip.geometry.unique_rows import unique_rows
from knifetip.model.drawing import NO_LINE_WIDTH

#: Greatest line width (1/100 mm); greater ones count as equal to it.
GREATEST: Final = 1_000_000


def hundredths(widths: F64) -> I32:
    """Return k line widths in 1/100 mm, (k,), as ``Drawing.line_width`` contains them.

    ``widths`` (k,) are in mm.  The width of a line is ``NO_LINE_WIDTH`` if it is negative or not a
    number.
    """
    with np.errstate(invalid="ignore"):
        whole = np.rint(np.minimum(widths * 100.0, GREATEST))
        result: I32 = np.where(whole >= 0.0, whole, NO_LINE_WIDTH).astype(np.int32)
    return result


def enlargements(matrix: F64) -> F64:
    """Return the factors by which p matrices, (p, 6), enlarge the widths of lines, (p,).

    A matrix that scales x and y differently enlarges a width by the geometric mean of both.
    """
    a, b, c, d = matrix[:, :4].T
    factors: F64 = np.sqrt(np.abs(a * d - b * c))
    return factors


def add_line_widths(styles: list[Style], style: I32, widths: F64) -> tuple[list[Style], I32]:
    """Return the styles of p paths with their line widths, and the style of each path, (p,).

    Parameters
    ----------
    styles
        Styles without line widths.
    style : (p,)
        Index of the style of each path.
    widths : (p,)
        Line width of each path (mm), negative if it has none.
    """
    line_width = hundredths(widths)
    first, number = unique_rows(style, line_width)
    pairs = zip(style[first].tolist(), line_width[first].tolist(), strict=True)
    return [styles[one]._replace(line_width=width) for one, width in pairs], number.astype(np.int32)
