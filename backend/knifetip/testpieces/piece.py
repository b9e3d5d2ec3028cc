"""piece: the record of a test piece: its lines with their depths, and what is measured on it."""

from __future__ import annotations

import math
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Final, NamedTuple, TypeAlias

import numpy as np

from knifetip.geometry.columns import F64, U8
from knifetip.model.dieline import LineType
from knifetip.model.job_options import CreaseDepth, CutDepth

Point: TypeAlias = tuple[float, float]

#: Side of the triangle that is cut off the lower left corner of a piece, so that a person finds the
#: first line (mm).
CHAMFER: Final = 10.0


class Line(NamedTuple):
    """A straight line of a test piece."""

    start: Point  #: mm
    end: Point  #: mm
    line_type: LineType
    depth: float = math.nan  #: below the top face (mm); NaN for the depth of the line type


class Arrow(NamedTuple):
    """A dimension that is measured, for the picture of a piece."""

    start: Point  #: mm
    end: Point  #: mm
    letter: str  #: letter of the measure in texts, such as "b"


@dataclass(frozen=True, slots=True)
class Piece:
    """A test piece.  Row i of its drawing is line i."""

    lines: tuple[Line, ...]
    arrows: tuple[Arrow, ...]

    @property
    def ends(self) -> F64:
        """Start and end of each of the n lines, (n, 2, 2) mm."""
        return np.array([(line.start, line.end) for line in self.lines], np.float64)

    @property
    def line_type(self) -> U8:
        """LineType of each line, (n,)."""
        return np.array([line.line_type for line in self.lines], np.uint8)

    @property
    def cut_depths(self) -> tuple[CutDepth, ...]:
        """The option of an order with the depths of cuts and half-cuts."""
        return tuple(
            CutDepth(edges=(row,), depth=line.depth)
            for row, line in enumerate(self.lines)
            if math.isfinite(line.depth) and line.line_type != LineType.CREASE
        )

    @property
    def crease_depths(self) -> tuple[CreaseDepth, ...]:
        """The option of an order with the depths of creases."""
        return tuple(
            CreaseDepth(edges=(row,), depth=line.depth)
            for row, line in enumerate(self.lines)
            if math.isfinite(line.depth) and line.line_type == LineType.CREASE
        )


def polyline(points: Sequence[Point], line_type: LineType = LineType.CUT) -> tuple[Line, ...]:
    """Return the lines from each point to the next one."""
    return tuple(Line(a, b, line_type) for a, b in pairwise(points))


def blank(width: float, height: float) -> tuple[Line, ...]:
    """Return the outline of a piece with its lower left corner at the origin, which is cut off."""
    return polyline(
        (
            (CHAMFER, 0.0),
            (width, 0.0),
            (width, height),
            (0.0, height),
            (0.0, CHAMFER),
            (CHAMFER, 0.0),
        )
    )
