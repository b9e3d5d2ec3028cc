"""Segments and styles that a format reader passes to ``assemble``."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import NamedTuple

import numpy as np

from knifetip.geometry.columns import F64, I32
from knifetip.model.drawing import NO_LINE_WIDTH


class Style(NamedTuple):
    """Layer, colour, linetype (dash pattern) and line width of the segments of an entity."""

    layer: str
    colour: int  #: AutoCAD colour index 1 … 255
    true_colour: int  #: 0xRRGGBB, -1 if none
    linetype: str
    line_width: int = NO_LINE_WIDTH  #: 1/100 mm, see ``Drawing.line_width``


@dataclass(frozen=True, eq=False, slots=True)
class Columns:
    """n lines and arcs in file units: ends, bulge, import report row and style of each one.

    Some of them approximate a curve of the file.
    """

    ends: F64  #: (n, 2, 2)
    bulge: F64  #: (n,)
    row: I32  #: (n,) row of the import report
    style: I32  #: (n,) index into the styles of the file
    #: (n,) greatest distance from the curve that the line or arc approximates (file units), 0 for
    #: an exact one; default 0
    fit_error: F64 = field(default_factory=lambda: np.zeros(0))

    def __post_init__(self) -> None:
        if len(self.fit_error) == 0:
            object.__setattr__(self, "fit_error", np.zeros(len(self.bulge)))
